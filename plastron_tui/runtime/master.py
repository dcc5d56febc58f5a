"""The ROS 1 master: whether one answers, and one of our own where none does.

A master is spoken to by XML-RPC (ROS wiki, "Master API"), so nothing of ROS is needed here.
"""

from __future__ import annotations

import http.client
import os
import socket
import xmlrpc.client
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any
from urllib.parse import urlsplit

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.import_path import command

from .child import Process, Role
from .environment import LOOPBACK, Environment, is_local, node_environ
from .supervisor import Supervisor

DEFAULT_PORT = 11311
_CALLER = "/plastron"
_ANSWER_LIMIT = 2.0
_START_LIMIT = 15.0
_ATTEMPTS = 3

_MASTER = "rosmaster:rosmaster_main"
"""What rosmaster's own command calls."""


class MasterError(Exception):
    """A master or a node did not answer, or answered that the call failed."""


class _Transport(xmlrpc.client.Transport):
    def __init__(self, limit: float) -> None:
        super().__init__()
        self._limit = limit

    def make_connection(self, host: Any) -> http.client.HTTPConnection:
        connection = super().make_connection(host)
        connection.timeout = self._limit
        return connection


def call(uri: str, method: str, *arguments: Any, limit: float = _ANSWER_LIMIT) -> Any:
    """Call a method of a master's or node's API, and return the value of its answer.

    Raises:
        MasterError: nothing answers in `limit` seconds, or the call failed.
    """
    try:
        with xmlrpc.client.ServerProxy(uri, transport=_Transport(limit)) as proxy:
            answer: Any = getattr(proxy, method)(_CALLER, *arguments)
        code, message, value = answer
    except (OSError, http.client.HTTPException, xmlrpc.client.Error, ValueError) as error:
        raise MasterError(f"{uri} does not answer: {error}") from error
    except Exception as error:  # expat's errors, from something that is no master
        raise MasterError(f"{uri} is no master: {error}") from error
    if code != 1:
        raise MasterError(f"{uri}: {message}")
    return value


def master_pid(uri: str) -> int | None:
    """Return the process that answers as a master, None where none does."""
    try:
        return int(call(uri, "getPid"))
    except (MasterError, TypeError, ValueError):
        return None


@dataclass(frozen=True, slots=True)
class Master:
    """The master that a run's nodes use; `process` is None for one that was there."""

    uri: str
    process: Process | None


def ensure_master(
    supervisor: Supervisor,
    environment: Environment,
    node_names: Iterable[str],
    *,
    network: bool = False,
    environ: Mapping[str, str] = os.environ,
) -> tuple[Master | None, list[Diagnostic]]:
    """Return a master for the nodes: the one that answers, else one that is started here.

    A master that the user names is used as it is. The one at the usual port is used too, unless
    it already has a node of one of the names: ROS 1 would shut that node down, so that the run
    then gets a master of its own (a second run beside the first).
    """
    named = environ.get("ROS_MASTER_URI", "")
    diagnostics: list[Diagnostic] = []
    if named and not _is_address(named):
        return None, [_no_address(named)]
    if named and not network and not is_local(named):
        diagnostics.append(_remote(named))
        named = ""
    usual = f"http://{'localhost' if network else LOOPBACK}:{DEFAULT_PORT}"
    if named:
        if master_pid(named) is not None:
            return Master(named, None), diagnostics
        port = urlsplit(named).port or DEFAULT_PORT
        if not _is_here(named) or not _is_free(port):
            return None, [*diagnostics, _silent(named)]
        ports = [port]
    elif master_pid(usual) is not None:
        if not _has_any(usual, node_names):
            return Master(usual, None), diagnostics
        ports = []
    else:
        ports = [DEFAULT_PORT] if _is_free(DEFAULT_PORT) else []
    attempts = ports if named else [*ports, *(0 for _ in range(_ATTEMPTS))]
    for port in attempts:
        master = _start(supervisor, environment, port, named, network, environ)
        if master is not None:
            return master, diagnostics
        if supervisor.is_stopping:
            return None, diagnostics
    return None, [*diagnostics, _not_started()]


def _start(
    supervisor: Supervisor,
    environment: Environment,
    port: int,
    named: str,
    network: bool,
    environ: Mapping[str, str],
) -> Master | None:
    port = port or _free_port()
    uri = named or f"http://{'localhost' if network else LOOPBACK}:{port}"
    process = Process(
        "master",
        (*command(_MASTER, str(environment.python)), "--core", "-p", str(port)),
        node_environ(environment, environ, network=network, master_uri=uri),
        role=Role.MASTER,
    )
    supervisor.start(process)
    own = {child_pid} if (child_pid := supervisor.pid_of(process)) is not None else set()
    supervisor.wait_for(
        lambda: not supervisor.is_running(process) or master_pid(uri) in own, _START_LIMIT
    )
    return Master(uri, process) if supervisor.is_running(process) else None


def _has_any(uri: str, node_names: Iterable[str]) -> bool:
    for name in node_names:
        try:
            call(uri, "lookupNode", f"/{name.lstrip('/')}")
        except MasterError:
            continue
        return True
    return False


def _is_address(uri: str) -> bool:
    """Tell whether something could answer at an address."""
    try:
        parts = urlsplit(uri)
        return bool(parts.scheme and parts.hostname) and parts.port != 0
    except ValueError:  # as in `http://[::1` or `http://host:99999`
        return False


def _is_here(uri: str) -> bool:
    """Tell whether a master at this address would be on this machine."""
    host = urlsplit(uri).hostname or ""
    return is_local(uri) or host in (socket.gethostname(), socket.getfqdn())


def _is_free(port: int) -> bool:
    with socket.socket() as probe:
        probe.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            probe.bind((LOOPBACK, port))
        except OSError:
            return False
    return True


def _free_port() -> int:
    with socket.socket() as probe:
        probe.bind((LOOPBACK, 0))
        port: int = probe.getsockname()[1]
    return port


def _remote(uri: str) -> Diagnostic:
    return Diagnostic(
        codes.REMOTE_MASTER,
        f"ROS_MASTER_URI names a master on another machine, {uri}; it is not used",
        help="give `--network` to let the nodes speak to other machines",
    )


def _no_address(uri: str) -> Diagnostic:
    return Diagnostic(
        codes.NO_MASTER,
        f"ROS_MASTER_URI is no address of a master: {uri}",
        help="write it like http://127.0.0.1:11311, or unset it to get a master on this machine",
    )


def _silent(uri: str) -> Diagnostic:
    return Diagnostic(
        codes.NO_MASTER,
        f"no ROS 1 master answers at {uri}, and none can be started there",
        help="correct ROS_MASTER_URI, or unset it to get a master on this machine",
    )


def _not_started() -> Diagnostic:
    return Diagnostic(
        codes.NO_MASTER,
        "the ROS 1 master that was started does not answer",
        help="try `rosmaster --core` by itself to see why",
    )
