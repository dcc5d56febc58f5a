"""The running graph: what nodes are there, and what they publish, hear, serve and call."""

from __future__ import annotations

import json
import os
import socket
import struct
import subprocess
from collections.abc import Callable, Iterable, Iterator, Mapping
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field, replace
from itertools import chain
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

from plastron_tui.diagnostics import Diagnostic, Severity, codes
from plastron_tui.model.endpoint_details import ParameterDetails, Range
from plastron_tui.model.kinds import EndpointKind
from plastron_tui.ros.interfaces import InterfaceName

from .action_topics import Endpoint, with_actions
from .environment import LOOPBACK, Environment, node_environ
from .master import DEFAULT_PORT, MasterError, call
from .private_parameters import private_parameters, setting, type_of_setting

_GRAPH = Path(__file__).with_name("observers") / "graph.py"
_DISCOVERY_LIMIT = 10.0
_PROBE_LIMIT = 2.0
_AT_ONCE = 16

# What every node has, or what serves the graph itself.
_INFRASTRUCTURE_TOPICS = frozenset({"/rosout", "/rosout_agg", "/parameter_events"})
_INFRASTRUCTURE_NODES = frozenset({"/rosout"})
_INFRASTRUCTURE_PACKAGES = frozenset({"rcl_interfaces", "type_description_interfaces"})
_TOPIC_KINDS = ("Publications", "Subscriptions")
_ROSCPP_SERVICES = ("/get_loggers", "/set_logger_level")


@dataclass(frozen=True, slots=True)
class DescribedNode:
    """A running node.

    Attributes:
        name: its full name, such as `/arm/talker`.
        by_kind: the names of its endpoints that others see and their types, None where nobody
            knows the type. ROS 1 does not know which services a node calls.
        parameters: what is known of its own parameters; the default of each is its present value.
    """

    name: str
    by_kind: Mapping[EndpointKind, tuple[Endpoint, ...]] = field(default_factory=dict)
    parameters: Mapping[str, ParameterDetails] = field(default_factory=dict)

    @property
    def is_idle(self) -> bool:
        """Whether it has no endpoint beside those that every node has."""
        return not any(self.by_kind.values()) and not self.parameters

    @property
    def endpoints(self) -> Iterator[Endpoint]:
        """Its endpoints of all kinds."""
        return chain.from_iterable(self.by_kind.values())


@dataclass(frozen=True, slots=True)
class Described:
    """The nodes, by name; None for a graph that could not be read at all."""

    nodes: tuple[DescribedNode, ...] | None
    diagnostics: tuple[Diagnostic, ...] = ()


def describe(
    environment: Environment,
    *,
    network: bool = False,
    environ: Mapping[str, str] = os.environ,
) -> Described:
    """Read the graph that nodes of this environment are part of."""
    if environment.ros_version == 1:
        uri = environ.get("ROS_MASTER_URI") or f"http://{LOOPBACK}:{DEFAULT_PORT}"
        return describe_ros1(uri)
    return describe_ros2(environment, network=network, environ=environ)


def describe_ros1(uri: str) -> Described:
    """Read the graph of a ROS 1 master (ROS wiki, "Master API"), with nothing of ROS here."""
    try:
        publishers, subscriptions, services = call(uri, "getSystemState")
        types = dict(call(uri, "getTopicTypes"))
    except (MasterError, TypeError, ValueError) as error:
        return Described(None, (_no_graph(f"no ROS 1 master answers at {uri}", error),))
    owners = {owner for _, found in chain(publishers, subscriptions, services) for owner in found}
    nodes: dict[str, DescribedNode] = {}
    with ThreadPoolExecutor(_AT_ONCE) as pool:
        told = dict(
            zip(owners, pool.map(lambda owner: _topic_types(uri, owner), owners), strict=True)
        )
        names = [name for name, _ in services if not name.endswith(_ROSCPP_SERVICES)]
        found = pool.map(lambda name: _service_type(uri, name), names)
        service_types = dict(zip(names, found, strict=True))

    def topic_type(owner: str, topic: str) -> InterfaceName | None:
        return interface_name((told[owner] or {}).get(topic) or types.get(topic, ""))

    _collect(nodes, EndpointKind.PUBLISHER, publishers, topic_type)
    _collect(nodes, EndpointKind.SUBSCRIPTION, subscriptions, topic_type)
    _collect(nodes, EndpointKind.SERVICE, services, lambda _, name: service_types.get(name))
    gone = [name for name in nodes if told[name] is None]
    own = private_parameters(_tree(uri), nodes)
    kept = [
        replace(node, by_kind=with_actions(node.by_kind), parameters=own.get(name, {}))
        for name, node in nodes.items()
        if told[name] is not None
    ]
    return Described(_shown(kept), tuple(_gone(name) for name in gone))


def describe_ros2(
    environment: Environment,
    *,
    network: bool = False,
    environ: Mapping[str, str] = os.environ,
) -> Described:
    """Read the graph that ROS 2 discovers, by a short-lived node of the environment."""
    try:
        done = subprocess.run(
            [environment.python, _GRAPH, str(_DISCOVERY_LIMIT)],
            env=node_environ(environment, environ, network=network),
            capture_output=True,
            text=True,
            timeout=_DISCOVERY_LIMIT + 20,
            check=False,
        )
        report = json.loads(done.stdout.strip().splitlines()[-1])
    except (OSError, subprocess.TimeoutExpired) as error:
        return Described(None, (_no_graph("the ROS 2 graph cannot be read", error),))
    except (IndexError, ValueError):
        reason = (done.stderr.strip().splitlines() or ["no answer"])[-1]
        return Described(None, (_no_graph("the ROS 2 graph cannot be read", reason),))
    return Described(_shown(_of_report(node) for node in report["nodes"]))


def interface_name(text: str) -> InterfaceName | None:
    """Return a type's name from either ROS's form, None for `*` and the like."""
    parts = text.split("/")
    if len(parts) not in (2, 3) or not all(parts):
        return None
    return InterfaceName(parts[0], parts[-1])


def _collect(
    nodes: dict[str, DescribedNode],
    kind: EndpointKind,
    state: Iterable[tuple[str, list[str]]],
    type_of: Callable[[str, str], InterfaceName | None],
) -> None:
    """Add endpoints to the nodes, creating those that are new."""
    for name, owners in state:
        for owner in owners:
            node = nodes.get(owner, DescribedNode(owner))
            endpoints = (*node.by_kind.get(kind, ()), (name, type_of(owner, name)))
            nodes[owner] = DescribedNode(owner, {**node.by_kind, kind: endpoints})


def _of_report(report: Mapping[str, Any]) -> DescribedNode:
    def endpoints(kind: EndpointKind) -> tuple[Endpoint, ...]:
        found = report[kind.value]
        return tuple((name, interface_name(types[0])) for name, types in found if types)

    shared = (kind for kind in EndpointKind if kind.facts.interface is not None)
    return DescribedNode(
        report["name"],
        {kind: endpoints(kind) for kind in shared},
        {each["name"]: _parameter(each) for each in report["parameters"]},
    )


def _parameter(report: Mapping[str, Any]) -> ParameterDetails:
    """Return what a node of ROS 2 says of a parameter."""
    default = setting(report["value"])
    limits = report["range"]
    return ParameterDetails(
        type=type_of_setting(default),
        default=default,
        range=None if limits is None else Range(*limits),
        description=report["description"],
        is_read_only=report["read_only"],
    )


def _shown(nodes: Iterable[DescribedNode]) -> tuple[DescribedNode, ...]:
    """Return the nodes by name, without what is infrastructure."""
    kept = [
        replace(node, by_kind={kind: _own(found) for kind, found in node.by_kind.items()})
        for node in nodes
        if node.name not in _INFRASTRUCTURE_NODES and not _is_hidden(node.name)
    ]
    return tuple(sorted(kept, key=lambda node: node.name))


def _own(endpoints: tuple[Endpoint, ...]) -> tuple[Endpoint, ...]:
    return tuple(
        sorted(
            (name, type_)
            for name, type_ in endpoints
            if name not in _INFRASTRUCTURE_TOPICS
            and not name.endswith(_ROSCPP_SERVICES)
            and not _is_hidden(name)
            and (type_ is None or type_.package not in _INFRASTRUCTURE_PACKAGES)
        )
    )


def _is_hidden(name: str) -> bool:
    # A part that starts with `_` is hidden (ROS 2 design, "Topic and Service names").
    return "/_" in name or name.startswith("/plastron_watch_")


def _tree(uri: str) -> object:
    """Return all parameters of a master, as the server keeps them: a tree by name."""
    try:
        return call(uri, "getParam", "/")
    except MasterError:
        return {}


def _topic_types(uri: str, node: str) -> dict[str, str] | None:
    """Ask a node for the types of its topics; None where it is not there any more.

    The master knows one type a topic, the first, be it of a node that is long gone; each node
    knows its own (ROS wiki, "Slave API").
    """
    try:
        address = call(uri, "lookupNode", node)
        lists = [call(address, f"get{kind}", limit=_PROBE_LIMIT) for kind in _TOPIC_KINDS]
        return {topic: name for each in lists for topic, name in each if name != "*"}
    except (MasterError, TypeError, ValueError):
        return None


def _service_type(uri: str, service: str) -> InterfaceName | None:
    """Ask a service's node for its type, as `rosservice type` does (ROS wiki, "TCPROS")."""
    try:
        address = urlsplit(call(uri, "lookupService", service))
        header = _probe_header(address.hostname or "", address.port or 0, service)
    except (MasterError, OSError, ValueError, struct.error):
        return None
    return interface_name(header.get("type", ""))


def _probe_header(host: str, port: int, service: str) -> dict[str, str]:
    fields = {"callerid": "/plastron", "md5sum": "*", "probe": "1", "service": service}
    with socket.create_connection((host, port), _PROBE_LIMIT) as connection:
        parts = [f"{key}={value}".encode() for key, value in fields.items()]
        body = b"".join(struct.pack("<I", len(part)) + part for part in parts)
        connection.sendall(struct.pack("<I", len(body)) + body)
        answer = _receive(connection, struct.unpack("<I", _receive(connection, 4))[0])
    header = {}
    while answer:
        (length,) = struct.unpack("<I", answer[:4])
        key, _, value = answer[4 : 4 + length].decode("utf-8", "replace").partition("=")
        header[key] = value
        answer = answer[4 + length :]
    return header


def _receive(connection: socket.socket, length: int) -> bytes:
    if length > 1 << 20:
        raise ValueError("this is no header")
    chunks = b""
    while len(chunks) < length:
        chunk = connection.recv(length - len(chunks))
        if not chunk:
            raise ValueError("the connection ended early")
        chunks += chunk
    return chunks


def _no_graph(message: str, reason: object) -> Diagnostic:
    text = str(reason)
    return Diagnostic(
        codes.NO_GRAPH,
        message if message in text else f"{message}: {text}",
        help="start the nodes first, for instance with `plastron run FILE`",
    )


def _gone(name: str) -> Diagnostic:
    return Diagnostic(
        codes.NO_GRAPH,
        f"`{name}` is registered but does not answer, and is left out",
        help="`rosnode cleanup` takes nodes that are gone off the master",
        severity=Severity.WARNING,
    )
