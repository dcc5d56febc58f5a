"""The graph of a workspace: which nodes meet on which topics and services.

It is the data behind `plastron graph` and the panels: complete, in the order of the program,
and each entry with the span of the statement that it comes from.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import NamedTuple

from plastron_tui.diagnostics import Span
from plastron_tui.ros.interfaces import InterfaceKind, InterfaceName
from plastron_tui.ros.qos import Qos
from plastron_tui.ros.robots.description import Description, Vector
from plastron_tui.ros.run_names import AS_WRITTEN, RunNames

from .kinds import EDITABLE, Endpoint, EndpointKind, Publication, Publisher, Subscription
from .workspace import Node, Workspace


class GraphNode(NamedTuple):
    """A node; its variable is what tells it from the others.

    Attributes:
        name: the node's name, as the program or the file has it; its full name in a namespace.
        variable: the program's variable for it.
        library: the client library; for a created node that names none, the one that it was
            last generated for; None where neither says it.
        file: the file that a loaded node came from, None for a created one.
        is_generated: whether the program generates it.
        span: the statement that created or loaded it.
        is_managed: whether it is a lifecycle node of ROS 2.
    """

    name: str
    variable: str
    library: str | None
    file: Path | None
    is_generated: bool
    span: Span
    is_managed: bool = False

    @property
    def is_loaded(self) -> bool:
        """Whether the node was read from a file."""
        return self.file is not None


class GraphRobot(NamedTuple):
    """A robot.

    Attributes:
        name: what it is called.
        variable: the program's variable for it.
        file: the file that a loaded one came from, None for a created one.
        is_generated: whether the program generates it.
        span: the statement that created or loaded it.
        description: what there is to see of it.
        has_macros: whether its file has macros that are not expanded: there is more of it then.
        meshes: points that its meshes are between, by their URIs, in the lengths of their files:
            two for the box around a mesh, more for the hull; only those that somebody measured.
    """

    name: str
    variable: str
    file: Path | None
    is_generated: bool
    span: Span
    description: Description
    has_macros: bool = False
    meshes: Mapping[str, tuple[Vector, ...]] = {}


class Sending(NamedTuple):
    """A message that goes to a topic: its variable, and when it is sent.

    `rate` is in hertz, 0 where it is not sent at a rate; `pace` says it in words.
    """

    message: str
    rate: float
    span: Span | None
    pace: str


class End(NamedTuple):
    """A node's endpoint at a topic or service.

    Attributes:
        node: the node.
        kind: the kind of the endpoint.
        endpoint: the endpoint.
        is_guess: whether its file is only guessed to have it, of this name and type.
    """

    node: GraphNode
    kind: EndpointKind
    endpoint: Endpoint
    is_guess: bool = False

    @property
    def written(self) -> str:
        """The name as the program or the file has it."""
        return self.endpoint.name

    @property
    def type(self) -> InterfaceName | None:
        """The type, None where a file does not say it."""
        return self.endpoint.type

    @property
    def span(self) -> Span | None:
        """The statement that made it, None for what was read from a file."""
        return self.endpoint.span

    @property
    def qos(self) -> Qos | None:
        """The quality of service of a topic, None where nothing of it is said."""
        match self.endpoint:
            case Publisher(qos=qos) | Subscription(qos=qos):
                return qos
            case _:
                return None

    @property
    def sendings(self) -> tuple[Sending, ...]:
        """The messages that a publisher sends; none of one that was read from a file."""
        if not isinstance(self.endpoint, Publisher):
            return ()
        sent = self.endpoint.publications
        return tuple(
            [Sending(each.message.variable, each.rate, each.span, _pace(each)) for each in sent]
        )


def _pace(publication: Publication) -> str:
    if publication.reaction is not None:
        return f"for each {publication.reaction.topic}"
    if publication.is_once:
        return "once"
    return publication.parameter or f"{publication.rate:g} Hz"


class Hub(NamedTuple):
    """A topic, or a service, by its full name, with all who meet there.

    `types` are the types in use, each once: one, unless files that were loaded disagree; none
    where no file says it. The ends are in the order of their kinds, then in that of the program.
    """

    interface: InterfaceKind
    name: str
    types: tuple[InterfaceName, ...]
    ends: tuple[End, ...]

    @property
    def noun(self) -> str:
        """What it is: a `topic`, or a `service`."""
        return NOUNS[self.interface]

    @property
    def type(self) -> InterfaceName | None:
        """The first type that is known."""
        return self.types[0] if self.types else None

    @property
    def missing(self) -> EndpointKind | None:
        """A kind of ends on the side that nobody takes, None when both sides are there."""
        sides = {end.kind.facts.sends for end in self.ends}
        kinds = KINDS_AT[self.interface]
        return next((kind for kind in kinds if kind.facts.sends not in sides), None)

    def of(self, kind: EndpointKind) -> Iterator[End]:
        """Yield the ends of one kind."""
        return (end for end in self.ends if end.kind is kind)

    @property
    def tails(self) -> list[End]:
        """Those that begin: messages and requests come from them."""
        return [end for end in self.ends if end.kind.facts.sends]

    @property
    def heads(self) -> list[End]:
        """Those that messages and requests go to."""
        return [end for end in self.ends if not end.kind.facts.sends]


def _kinds_at() -> dict[InterfaceKind, tuple[EndpointKind, ...]]:
    found: dict[InterfaceKind, tuple[EndpointKind, ...]] = {}
    for kind in EDITABLE:
        if kind.facts.interface is not None:
            found[kind.facts.interface] = (*found.get(kind.facts.interface, ()), kind)
    return found


KINDS_AT = _kinds_at()
"""The kinds of endpoints that meet where an interface is used."""

NOUNS = {at: kinds[0].facts.named or "" for at, kinds in KINDS_AT.items()}
"""What endpoints of a kind of interface meet at: a `topic`, a `service`."""


class Graph(NamedTuple):
    """The nodes of a program, where they meet, and its robots, each in the program's order."""

    nodes: tuple[GraphNode, ...]
    at: Mapping[InterfaceKind, tuple[Hub, ...]]
    robots: tuple[GraphRobot, ...] = ()

    @property
    def hubs(self) -> tuple[Hub, ...]:
        """All topics, then all services."""
        return tuple([hub for hubs in self.at.values() for hub in hubs])

    @property
    def topics(self) -> tuple[Hub, ...]:
        """The topics."""
        return self.at[InterfaceKind.MESSAGE]

    @property
    def services(self) -> tuple[Hub, ...]:
        """The services."""
        return self.at[InterfaceKind.SERVICE]


def graph_of(workspace: Workspace, names: RunNames = AS_WRITTEN) -> Graph:
    """Return the graph of a workspace as it is at the end of the program.

    Args:
        workspace: the nodes.
        names: what a run of them says about names.
    """
    found: dict[InterfaceKind, dict[str, dict[EndpointKind, list[End]]]] = {
        interface: {} for interface in KINDS_AT
    }
    generated = {made.node.variable: made.library for made in workspace.generations}
    nodes = []
    for node in workspace.nodes.values():
        shown, guesses = _node(node, generated), node.guesses
        own = names.of(node.name, node.variable)
        if names.namespace:
            shown = shown._replace(name=names.full_node(node.name))
        nodes.append(shown)
        for (kind, written), endpoint in node.endpoints.items():
            if kind.facts.interface is None:
                continue
            hubs, name = found[kind.facts.interface], own.resolved(node.name, written)
            ends = hubs.get(name)
            if ends is None:
                ends = hubs[name] = {each: [] for each in KINDS_AT[kind.facts.interface]}
            is_guess = (kind, written) in guesses
            ends[kind].append(End(shown, kind, endpoint, is_guess))
    return Graph(
        tuple(nodes),
        {
            interface: tuple([_hub(interface, name, ends) for name, ends in hubs.items()])
            for interface, hubs in found.items()
        },
        tuple(_robots(workspace)),
    )


def _robots(workspace: Workspace) -> Iterator[GraphRobot]:
    generated = {made.robot.variable for made in workspace.written_robots}
    for robot in workspace.robots.values():
        source = robot.source
        yield GraphRobot(
            robot.name,
            robot.variable,
            None if source is None else source.path,
            robot.variable in generated,
            robot.span,
            robot.shown,
            source is not None and source.macros is not None and source.expanded is None,
            robot.meshes,
        )


def _hub(interface: InterfaceKind, name: str, by_kind: dict[EndpointKind, list[End]]) -> Hub:
    ends = tuple([end for found in by_kind.values() for end in found])
    types = dict.fromkeys(end.type for end in ends if end.type is not None)
    return Hub(interface, name, tuple(types), ends)


def _node(node: Node, generated: dict[str, str]) -> GraphNode:
    return GraphNode(
        node.name,
        node.variable,
        node.library or generated.get(node.variable),
        node.source.path if node.source is not None else None,
        node.variable in generated,
        node.span,
        node.is_managed,
    )
