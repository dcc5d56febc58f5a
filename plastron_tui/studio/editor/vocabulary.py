"""The names of a program, for completion."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import cached_property
from typing import TYPE_CHECKING, Any

from plastron_tui.language import Program, SlotKind
from plastron_tui.language import statements as st
from plastron_tui.model.kinds import EDITABLE, EndpointKind, Parameter, Publisher, Subscription
from plastron_tui.model.own_types import interfaces_of
from plastron_tui.model.rename import RENAMED
from plastron_tui.ros.interfaces import InterfaceKind, InterfaceName
from plastron_tui.ros.names import spelled
from plastron_tui.ros.qos import Qos
from plastron_tui.ros.robots.description import Description

if TYPE_CHECKING:
    from plastron_tui.model.robots import Robot
    from plastron_tui.model.workspace import Workspace
    from plastron_tui.ros.catalog import Catalog

_MADE: dict[Any, EndpointKind] = {
    kind.editing.made_by: kind for kind in EDITABLE if kind.facts.interface is not None
}
"""The statements that name what nodes meet at, and its type."""

_KINDS = (
    *(SlotKind.NODE, SlotKind.MESSAGE, SlotKind.PACKAGE, SlotKind.LAUNCH, SlotKind.ROBOT),
    SlotKind.OWN_TYPE,
)
"""The kinds of slots that variables fill, as `Vocabulary.variables` has them."""

_PACKAGE = "own_interfaces"
"""The package of own types where the program has none: they are offered without it."""


class Vocabulary:
    """The names of a program, as it was when it was last understood."""

    def __init__(self, program: Program, workspace: Workspace) -> None:
        self._program = program
        self._workspace = workspace
        self._catalogs: dict[int, tuple[Catalog, Catalog]] = {}

    @cached_property
    def _variables(self) -> Mapping[str, dict[str, str]]:
        nodes: dict[str, str] = {}
        messages: dict[str, str] = {}
        libraries: dict[str, str] = {}
        for statement in self._program.statements:
            match statement:
                case st.CreateNode(name=name, variable=variable, library=library):
                    nodes[variable] = f"node '{name}'"
                    if library is not None:
                        libraries[variable] = library
                case st.Load(source=source, variable=variable):
                    nodes[variable] = f"node from {source}"
                case st.CreateMessage(variable=variable, type=type_):
                    messages[variable] = type_
        return {"nodes": nodes, "messages": messages, "libraries": libraries}

    @cached_property
    def _made(self) -> Mapping[str, dict[str, str]]:
        """The packages, the launch files, the robots and the types, and what each is."""
        packages: dict[str, str] = {}
        launches: dict[str, str] = {}
        robots: dict[str, str] = {}
        types: dict[str, str] = {}
        for statement in self._program.statements:
            match statement:
                case st.CreatePackage(name=name, variable=variable):
                    packages[variable] = f"package '{name}'"
                case st.LoadPackage(source=source, variable=variable):
                    packages[variable] = f"package in {source}"
                case st.CreateLaunch(name=name, variable=variable):
                    launches[variable] = f"launch file '{name}'"
                case st.LoadLaunch(source=source, variable=variable):
                    launches[variable] = f"launch file {source}"
                case st.CreateRobot(name=name, variable=variable):
                    robots[variable] = f"robot '{name}'"
                case st.LoadRobot(source=source, variable=variable):
                    robots[variable] = f"robot from {source}"
                case st.CreateMessageType(type=type_):
                    types[type_] = "message of your own"
                case st.CreateServiceType(type=type_):
                    types[type_] = "service of your own"
                case st.CreateActionType(type=type_):
                    types[type_] = "action of your own"
                case st.LoadType(source=source, variable=variable):
                    types[variable] = f"type from {source}"
        return {"packages": packages, "launches": launches, "robots": robots, "types": types}

    def with_own_types(self, catalog: Catalog) -> Catalog:
        """Return a catalog with the types of the program's own, as it was last understood."""
        types = self._workspace.types
        if not types:
            return catalog
        known = self._catalogs.get(catalog.ros_version)
        if known is None or known[0] is not catalog:
            packages = self._workspace.packages.values()
            package = next((each.name for each in packages), _PACKAGE)
            own = interfaces_of(types.values(), catalog.ros_version, package)
            known = self._catalogs[catalog.ros_version] = catalog, catalog.with_own(own)
        return known[1]

    @property
    def variables(self) -> Iterable[dict[str, str]]:
        """All variables, by what they stand for."""
        return self.nodes, self.messages, self.packages, self.launches, self.robots, self.types

    def kind_of(self, variable: str) -> SlotKind | None:
        """Return the kind of slot that a variable fills, None for one that is not known."""
        found = (
            kind for kind, each in zip(_KINDS, self.variables, strict=True) if variable in each
        )
        return next(found, None)

    @property
    def packages(self) -> dict[str, str]:
        """The variables of packages, and what each is."""
        return self._made["packages"]

    @property
    def launches(self) -> dict[str, str]:
        """The variables of launch files, and what each is."""
        return self._made["launches"]

    @property
    def types(self) -> dict[str, str]:
        """The names of the types of the program's own, and what each is."""
        return self._made["types"]

    @property
    def robots(self) -> dict[str, str]:
        """The variables of robots, and what each is."""
        return self._made["robots"]

    def robot(self, variable: str) -> Description:
        """Return what a robot consists of, as it was last understood."""
        found = self.known_robot(variable)
        return Description("") if found is None else found.shown

    def known_robot(self, variable: str) -> Robot | None:
        """Return a robot as it was last understood, None for one that was not."""
        return self._workspace.robots.get(variable)

    def made_parts(self, variable: str) -> frozenset[str]:
        """Return the links and joints of a robot that the program speaks of."""
        found = self.known_robot(variable)
        return frozenset() if found is None else frozenset({*found.links, *found.joints})

    def contents(self, package: str) -> Mapping[str, str]:
        """Return what a package contains, as statements name it, and what one starts it by."""
        found = self._workspace.packages.get(package)
        if found is None:
            return {}
        there = () if found.source is None else found.source.executables
        own = {variable: each.name for variable, each in found.contents.items()}
        return {**own, **{f"'{name}'": "in the package" for name in there}}

    def started(self, launch: str) -> Iterable[str]:
        """Return the names of what a launch file starts."""
        found = self._workspace.launches.get(launch)
        return () if found is None else found.by_shortest_name.keys()

    @cached_property
    def _meetings(self) -> Mapping[InterfaceKind, dict[str, str]]:
        known = self._known
        written: dict[InterfaceKind, dict[str, str]] = {each: {} for each in InterfaceKind}
        for statement in self._program.statements:
            kind = _MADE.get(type(statement))
            if kind is None or kind.facts.interface is None:
                continue
            interface = kind.facts.interface
            made: Any = statement
            name = getattr(made, kind.editing.name_slot)
            if _agrees(made.type, known[interface].get(name)):
                written[interface].setdefault(name, made.type)
        return {each: {**known[each], **written[each]} for each in InterfaceKind}

    @property
    def _known(self) -> dict[InterfaceKind, dict[str, str]]:
        """What nodes meet at and has effect, by their kinds of interface, with the full types."""
        found: dict[InterfaceKind, dict[str, str]] = {each: {} for each in InterfaceKind}
        for node in self._workspace.nodes.values():
            for kind, endpoints in node.by_kind.items():
                if kind.facts.interface is not None:
                    known = found[kind.facts.interface]
                    for name, endpoint in endpoints.items():
                        known.setdefault(name, str(endpoint.type or ""))
        return found

    @property
    def nodes(self) -> dict[str, str]:
        """The variables of nodes, and what each is."""
        return self._variables["nodes"]

    @property
    def messages(self) -> dict[str, str]:
        """The variables of messages, and the type of each as it is written."""
        return self._variables["messages"]

    def meetings(self, interface: InterfaceKind | None) -> dict[str, str]:
        """Return the topics, services or actions, and the type of each as it is written.

        A type is empty where it is unknown.
        """
        return {} if interface is None else self._meetings[interface]

    def library(self, variable: str) -> str | None:
        """Return the client library that a node names."""
        return self._variables["libraries"].get(variable)

    def endpoints(self, variable: str, keyword: str) -> Iterable[str]:
        """Return what a statement that takes something away from a node may name."""
        node = self._workspace.nodes.get(variable)
        if node is None:
            return ()
        ended = (kind for kind in EDITABLE if kind.editing.ending.keyword == keyword)
        return next((map(kind.written, node.by_kind[kind]) for kind in ended), ())

    def parameters(self, variable: str | None) -> dict[str, Parameter]:
        """Return the parameters of a node, of all nodes for None, by the names programs write."""
        nodes = self._workspace.nodes
        found = [nodes[variable]] if variable in nodes else []
        if variable is None:
            found = list(nodes.values())
        return {
            name.removeprefix("~/"): each
            for node in found
            for name, each in node.of(Parameter).items()
        }

    def heard(self, variable: str) -> Mapping[str, Subscription]:
        """Return what a node listens to, by its topic."""
        node = self._workspace.nodes.get(variable)
        return {} if node is None else node.of(Subscription)

    def offered(self, topic: str) -> list[Qos]:
        """Return the quality of service of each publisher of a topic, as far as it is known."""
        return [
            publisher.qos or Qos()
            for node in self._workspace.nodes.values()
            for name, publisher in node.of(Publisher).items()
            if name.removeprefix("/") == topic.removeprefix("/")
        ]

    def heard_with(self, message: str) -> tuple[InterfaceName, ...]:
        """Return the types that a message may be made of when it is sent.

        They are those of the topics that it is sent for; of all topics that nodes listen to where
        it is sent for none.
        """
        sent = [
            self.heard(each.node).get(spelled(each.trigger))
            for each in self._program.statements
            if isinstance(each, st.Publish) and each.message == message and each.trigger
        ]
        everything = (each for node in self._workspace.nodes for each in self.heard(node).values())
        types = (each.type for each in [*filter(None, sent)] or everything)
        return tuple(dict.fromkeys(each for each in types if each is not None))

    def named(self, variable: str, word: str) -> list[str]:
        """Return the names that a node has of what a word of `renames` says."""
        node = self._workspace.nodes.get(variable)
        if node is None:
            return []
        kinds = RENAMED.get(word, ())
        names = (kind.written(name) for kind in kinds for name in node.names(kind))
        return list(dict.fromkeys(names))

    def loaded_with(self, word: str, name: str) -> set[str]:
        """Return the nodes whose files have a name of what a word of `renames` says.

        A name is the same with and without the slash that it may begin with.
        """
        kinds = [kind for kind in RENAMED.get(word, ()) if kind in EDITABLE]
        return {
            variable
            for variable, node in self._workspace.nodes.items()
            for kind in kinds
            for written, endpoint in node.by_kind[kind].items()
            if endpoint.span is None and kind.written(written).removeprefix("/") == name
        }

    def renamable(self, variable: str) -> list[str]:
        """Return the words of `renames` for what a node has; of one that is not known, all."""
        return [word for word in RENAMED if self.named(variable, word)] or list(RENAMED)


def _agrees(written: str, known: str | None) -> bool:
    """Tell whether a type as it is written is the one that is known; a half-typed one is not."""
    return not known or written.rpartition("/")[2] == known.rpartition("/")[2]
