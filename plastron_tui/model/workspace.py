"""What a program builds: nodes, their endpoints, and the messages that they send.

The same endpoints describe a node that was created and one that was loaded from a file, so
that targets, panels and graphs see one kind of node.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.diagnostics import Span

from .kinds import (
    EDITABLE,
    Endpoint,
    EndpointKey,
    EndpointKind,
    EndpointType,
    Message,
    kind_of,
)

if TYPE_CHECKING:
    from plastron_tui.ros.interfaces import InterfaceName

    from .launches import Launch, LaunchGeneration
    from .own_types import OwnType
    from .packages import Package, PackageGeneration
    from .robots import Robot, RobotGeneration
    from .source import SourceUnit


def _none() -> dict[EndpointKind, dict[str, Endpoint]]:
    return {kind: {} for kind in EDITABLE}


class Renamed(NamedTuple):
    """What something was called before a program gave it another name, and where it did so."""

    name: str
    span: Span


class Home(NamedTuple):
    """The package that a node is in.

    Attributes:
        package: its name.
        executable: what one starts the node by.
        folder: the folder of the package that its file is in; None for the usual one.
        is_own: whether it is the package of the program itself, which no statement makes: the
            files of its nodes are called as those of nodes in no package.
        is_output: whether the output folder is the package, not a folder of it by its name.
        above: where the package is from the output folder, where it was there before: `.` for the
            output folder, `..` for the one that that is in; None for a package that is written.
    """

    package: str
    executable: str
    folder: str | None = None
    is_own: bool = False
    is_output: bool = False
    above: str | None = None

    @property
    def stem(self) -> str:
        """What the node's file is called: a module's name has no `-` and no dot."""
        return self.executable.replace("-", "_").replace(".", "_")


@dataclass(slots=True)
class Node:
    """A node, as the program has it so far.

    Attributes:
        name: its name.
        variable: the program's variable for it.
        span: the statement that created or loaded it.
        library: the client library that it names.
        source: the file that a loaded node came from, None for one that was created.
        by_kind: its endpoints, by kind and then by graph name as it is written, in the order in
            which they came; `put` and `take` change them.
        removed: which statement took a name away last.
        renamed: what was given another name, by its kind and that name.
        file: the main file that a created node has, "" where none was chosen yet.
        is_managed: whether it is a lifecycle node of ROS 2.
        home: the package that the program puts it into, None for none.
    """

    name: str
    variable: str
    span: Span
    library: str | None = None
    source: SourceUnit | None = None
    by_kind: dict[EndpointKind, dict[str, Endpoint]] = field(default_factory=_none)
    removed: dict[str, Span] = field(default_factory=dict)
    renamed: dict[EndpointKey, Renamed] = field(default_factory=dict)
    file: str = ""
    is_managed: bool = False
    home: Home | None = None

    def of(self, type_: type[EndpointType]) -> Mapping[str, EndpointType]:
        """Return the endpoints of one class by name: `node.of(Publisher)`."""
        return self.by_kind[kind_of(type_)]  # type: ignore[return-value]

    def put(self, endpoint: Endpoint) -> None:
        """Give the node an endpoint, in place of the one of its kind and name."""
        self.by_kind[kind_of(type(endpoint))][endpoint.name] = endpoint

    def take(self, kind: EndpointKind, name: str) -> bool:
        """Take an endpoint away from the node, and tell whether it had one."""
        self.renamed.pop((kind, name), None)
        return self.by_kind[kind].pop(name, None) is not None

    def rename(self, kind: EndpointKind, old: str, new: str, span: Span) -> None:
        """Give what the node has of a kind another name; it keeps its place among its like."""
        earlier = self.renamed.pop((kind, old), None)
        self.renamed[kind, new] = Renamed(old if earlier is None else earlier.name, span)
        if kind in self.by_kind:
            self.by_kind[kind] = {
                name if name != old else new: each if name != old else each._replace(name=new)
                for name, each in self.by_kind[kind].items()
            }

    def names(self, kind: EndpointKind) -> Collection[str]:
        """Return the names that the node has of a kind, as far as its file says them."""
        if kind in self.by_kind:
            return self.by_kind[kind].keys()
        there = () if self.source is None else self.source.of_kind(kind)
        names = dict.fromkeys(each.name for each in there if each.name)
        new = {each.name: now for (of, now), each in self.renamed.items() if of is kind}
        return [new.get(name, name) for name in names]

    def place_of(self, endpoint: Endpoint) -> str:
        """Return the file and the line that have an endpoint, "" where a statement made it."""
        source, kind = self.source, kind_of(type(endpoint))
        if source is None or endpoint.span is not None:
            return ""
        renamed = self.renamed.get((kind, endpoint.name))
        name = endpoint.name if renamed is None else renamed.name
        found = (each for each in source.of_kind(kind) if each.label == name)
        return next((f"line {each.line} of `{source.path_of(each).name}`" for each in found), "")

    @property
    def is_idle(self) -> bool:
        """Whether the node would do nothing."""
        return not any(self.by_kind.values())

    @property
    def guesses(self) -> frozenset[EndpointKey]:
        """What its file is only guessed to have, and the program says nothing of."""
        there = () if self.source is None else self.source.endpoints
        found = {(each.kind, each.name) for each in there if each.is_guess and each.name}
        have = self.endpoints if found else {}
        return frozenset(key for key in found if key in have and have[key].span is None)

    @property
    def endpoints(self) -> dict[EndpointKey, Endpoint]:
        """The endpoints of all kinds, by kind and name."""
        return {
            (kind, name): each
            for kind, found in self.by_kind.items()
            for name, each in found.items()
        }

    @property
    def types(self) -> frozenset[InterfaceName]:
        """The interface types that the node uses."""
        types = (endpoint.type for endpoint in self.endpoints.values())
        return frozenset(type_ for type_ in types if type_ is not None)

    @property
    def packages(self) -> frozenset[str]:
        """The packages whose interface types the node uses."""
        return frozenset(type_.package for type_ in self.types)

    def snapshot(self) -> Node:
        """Return the node as it is now, untouched by what later statements do to it."""
        # `dataclasses.replace` takes four times as long, and a program may have thousands.
        by_kind = {kind: dict(found) for kind, found in self.by_kind.items()}
        return Node(
            self.name,
            self.variable,
            self.span,
            self.library,
            self.source,
            by_kind,
            dict(self.removed),
            dict(self.renamed),
            is_managed=self.is_managed,
            home=self.home,
        )


class Generation(NamedTuple):
    """A `generate_node`: the node as it was then, and the client library asked for."""

    node: Node
    library: str
    span: Span


@dataclass(slots=True)
class Workspace:
    """All that a program built, by variable, and what it asked to generate.

    Attributes:
        nodes: its nodes.
        messages: the messages that they send.
        types: its own interface types, by the name that statements have for them.
        packages: its packages.
        launches: its launch files.
        robots: its robots.
        generations: the nodes that are written.
        written_types: the types that are written for their own sake, by the same names.
        written_packages: the packages that are written.
        written_launches: the launch files that are written.
        written_robots: the robots that are written.
    """

    nodes: dict[str, Node] = field(default_factory=dict)
    messages: dict[str, Message] = field(default_factory=dict)
    types: dict[str, OwnType] = field(default_factory=dict)
    packages: dict[str, Package] = field(default_factory=dict)
    launches: dict[str, Launch] = field(default_factory=dict)
    robots: dict[str, Robot] = field(default_factory=dict)
    generations: list[Generation] = field(default_factory=list)
    written_types: dict[str, Span] = field(default_factory=dict)
    written_packages: list[PackageGeneration] = field(default_factory=list)
    written_launches: list[LaunchGeneration] = field(default_factory=list)
    written_robots: list[RobotGeneration] = field(default_factory=list)

    @property
    def has_more_than_nodes(self) -> bool:
        """Whether it writes packages, definitions, launch files or robots, or may have to."""
        return bool(
            self.types or self.written_packages or self.written_launches or self.written_robots
        )

    @property
    def is_written(self) -> bool:
        """Whether the program asks for a file, of whatever kind."""
        return bool(
            self.generations
            or self.written_types
            or self.written_packages
            or self.written_launches
            or self.written_robots
        )

    @property
    def may_run(self) -> bool:
        """Whether it writes what can be started; no robot alone is, and no type."""
        return bool(self.generations or self.written_packages or self.written_launches)

    def ros_versions(self, version_of: Callable[[str | None], int]) -> set[int]:
        """Return the generations of ROS that it is for, by that of a client library.

        None is asked for as the client library of what names none.
        """
        named = {each.library for each in self.nodes.values()}
        asked = {each.library for each in self.generations}
        return {version_of(each) for each in {None, *named, *asked}}

    def what(self, variable: str) -> tuple[str, Span] | None:
        """Return what a variable stands for, in a word, and since where; None for a free one."""
        named: dict[str, Mapping[str, Node | Message | OwnType | Package | Launch | Robot]] = {
            "node": self.nodes,
            "message": self.messages,
            "type": self.types,
            "package": self.packages,
            "launch file": self.launches,
            "robot": self.robots,
        }
        for word, things in named.items():
            if variable in things:
                return word, things[variable].span
        return None
