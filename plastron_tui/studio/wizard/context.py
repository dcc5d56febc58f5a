"""What a program has by now: the names that a form offers, and those that are taken."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path

from plastron_tui.language.declaration import Statement
from plastron_tui.language.keywords import KEYWORDS
from plastron_tui.model.kinds import EDITABLE, Parameter
from plastron_tui.model.types import TypeResolver
from plastron_tui.model.workspace import Workspace
from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.interfaces import Interface, InterfaceKind, InterfaceName
from plastron_tui.ros.names import resolved_name
from plastron_tui.session import Session
from plastron_tui.targets import ros_version

from ..editor.vocabulary import Vocabulary


@dataclass(slots=True)
class Meeting:
    """A topic, a service or an action: where nodes meet.

    Attributes:
        name: its name, as a statement would write it.
        type: its type, None where nothing says it.
        senders: the nodes that publish, or that call, or that send goals.
        takers: the nodes that subscribe, or that provide.
    """

    name: str
    type: InterfaceName | None = None
    senders: list[str] = field(default_factory=list)
    takers: list[str] = field(default_factory=list)

    @property
    def is_lonely(self) -> bool:
        """Whether one side is missing."""
        return not self.senders or not self.takers


@dataclass(slots=True)
class Surroundings:
    """What is on this machine, looked up once.

    Attributes:
        files: the files that hold nodes, each with its client library; None before the look-up.
        others: other files, by what they are, of those that were looked up.
    """

    files: tuple[tuple[Path, str], ...] | None = None
    others: dict[str, tuple[Path, ...]] = field(default_factory=dict)

    def once(self, what: str, find: Callable[[], tuple[Path, ...]]) -> tuple[Path, ...]:
        """Return the files that are something, looked for the first time."""
        if what not in self.others:
            self.others[what] = find()
        return self.others[what]


class Scene:
    """A program, and what is around it."""

    def __init__(self, session: Session, surroundings: Surroundings | None = None) -> None:
        self.session = session
        self.surroundings = surroundings or Surroundings()
        self.workspace = session.workspace

    @property
    def text(self) -> bytes:
        """The program's text."""
        return self.session.document.text

    @cached_property
    def taken(self) -> frozenset[str]:
        """The words that are no new variable."""
        return frozenset({*variables_of(self.workspace), *KEYWORDS})

    @cached_property
    def node_names(self) -> frozenset[str]:
        """The names of the nodes in the ROS graph."""
        return frozenset(node.name for node in self.workspace.nodes.values())

    def free(self, wanted: str) -> str:
        """Return a variable like the wanted one that is not taken."""
        return free_name(wanted, self.taken)

    def library_of(self, variable: str | None) -> str:
        """Return the client library that a node is for."""
        node = self.workspace.nodes.get(variable or "")
        return (node.library if node is not None else None) or self.session.library

    def version_of(self, variable: str | None) -> int:
        """Return the generation of ROS that a node is for."""
        library = self.library_of(variable)
        return ros_version(library)

    @cached_property
    def usual_version(self) -> int:
        """The generation of ROS that the last node is for, or else the program."""
        return self.version_of(next(reversed(self.workspace.nodes), None))

    def catalog(self, version: int) -> Catalog:
        """Return the types of a generation of ROS."""
        return self.session.catalog(version)

    def resolve(self, text: str, kind: InterfaceKind, version: int) -> Interface | None:
        """Return the type that a text means, None where it means none."""
        found = TypeResolver(self.catalog(version)).resolve(text, kind)
        return found if isinstance(found, Interface) else None

    def written(self, name: InterfaceName, kind: InterfaceKind, version: int) -> str:
        """Return the shortest way to write a type."""
        alone = self.catalog(version).candidates(name.name, kind) == (name,)
        return name.name if alone else str(name)

    @cached_property
    def _meetings(self) -> dict[tuple[InterfaceKind, int], dict[str, Meeting]]:
        found: dict[tuple[InterfaceKind, int], dict[str, Meeting]] = {}

        for variable, node in self.workspace.nodes.items():
            for (kind, name), endpoint in node.endpoints.items():
                if kind.facts.interface is None:
                    continue
                full = resolved_name(node.name, name)
                known = found.setdefault((kind.facts.interface, self.version_of(variable)), {})
                is_full = name.startswith("~") or "{" in name
                meeting = known.setdefault(full, Meeting(full if is_full else name))
                meeting.type = meeting.type or endpoint.type
                (meeting.senders if kind.facts.sends else meeting.takers).append(variable)
        return found

    def meetings(self, kind: InterfaceKind, version: int) -> dict[str, Meeting]:
        """Return the topics, services or actions of a generation of ROS, by their full names."""
        return self._meetings.get((kind, version), {})

    def meeting(
        self, kind: InterfaceKind, node: str | None, name: str, version: int
    ) -> Meeting | None:
        """Return what a node means by a name, None where nobody is there yet."""
        known = self.workspace.nodes.get(node or "")
        full = resolved_name(known.name if known is not None else "", name)
        return self.meetings(kind, version).get(full)

    @cached_property
    def lonely(self) -> int:
        """How many topics, services and actions lack a side."""
        return sum(each.is_lonely for known in self._meetings.values() for each in known.values())

    def ended_by(self, variable: str, statement: type[Statement]) -> list[str]:
        """Return the names of what a statement may take away from a node."""
        node = self.workspace.nodes.get(variable)
        if node is None:
            return []
        kinds = (kind for kind in EDITABLE if kind.editing.ended_by is statement)
        return [kind.written(name) for kind in kinds for name in node.names(kind)]

    @cached_property
    def vocabulary(self) -> Vocabulary:
        """The names of the program, as completion has them."""
        return Vocabulary(self.session.program, self.workspace)

    def parameters(self, variable: str | None) -> dict[str, Parameter]:
        """Return the parameters of a node, of all nodes for None, by the names programs write."""
        return self.vocabulary.parameters(variable)

    def heard(self, variable: str) -> dict[str, InterfaceName | None]:
        """Return the types of what a node listens to, by topic."""
        return {name: each.type for name, each in self.vocabulary.heard(variable).items()}


def variables_of(workspace: Workspace) -> Iterator[str]:
    """Yield all variables of a program."""
    yield from workspace.nodes
    yield from workspace.messages
    yield from workspace.types
    yield from workspace.packages
    yield from workspace.launches
    yield from workspace.robots


def free_name(wanted: str, taken: Iterable[str]) -> str:
    """Return a name like the wanted one that is not taken."""
    known = frozenset(taken)
    name, number = wanted, 2
    while name in known:
        name, number = f"{wanted}_{number}", number + 1
    return name
