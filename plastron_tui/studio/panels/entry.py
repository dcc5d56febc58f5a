"""An entry of a panel, as data: made apart from the screen, shown by `EntryList`."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterable
from enum import Enum
from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.diagnostics import Edit, Span

if TYPE_CHECKING:
    from pathlib import Path

    from plastron_tui.model.kinds import EndpointKind


class Subject(Enum):
    """What an entry is about, other than an endpoint: it decides what can be done with it."""

    NODE = "node"
    TOPIC = "topic"
    SERVICE_NAME = "service name"
    ACTION_NAME = "action name"
    MESSAGE = "message"
    PACKAGE = "package"
    LAUNCH = "launch file"
    TYPE = "type"
    FUNCTION = "function"
    ROBOT = "robot"
    LINK = "link"
    JOINT = "joint"
    PROBLEM = "problem"
    OTHER = "other"

    @property
    def word(self) -> str:
        """What one is called."""
        return self.value


_WRITTEN: dict[Subject | EndpointKind, str] = {
    Subject.PACKAGE: "generate_package",
    Subject.LAUNCH: "generate_launch",
    Subject.TYPE: "generate_type",
    Subject.ROBOT: "generate_robot",
}
"""What writes a thing to files."""


class Entry(NamedTuple):
    """One line of a panel.

    Attributes:
        key: what the entry is, the same from one analysis to the next.
        text: its name.
        detail: what is written behind the name, quietly.
        sign: one character before the name.
        tone: the tone of the sign, a name that `styles.py` knows, or a colour: `#3060ff`.
        warning: what is wrong with it, behind all the rest.
        depth: how far it is indented.
        span: the statement that it comes from, None for what was read from a file.
        subject: what it is about; of an endpoint its kind.
        node: the variable of the node that it belongs to.
        name: the topic, service, action, parameter, function or variable as the program has it; of
            a problem in another file that file and the line.
        edits: a fix that can be applied.
        is_branch: whether entries below belong to it.
        ending: the statement that ends what it is about, where that is no endpoint; or several,
            a line each.
        robot: the variable of the robot that it is a part of.
        place: where it is written, where that is another file.
        file: of a problem in another file that file.
        line: the line there, from 1; 0 where none is known.
        part_of: the key of the entry before it that it is a part of: the keys are for both.
    """

    key: str
    text: str
    detail: str = ""
    sign: str = ""
    tone: str = "dim"
    warning: str = ""
    depth: int = 0
    span: Span | None = None
    subject: Subject | EndpointKind = Subject.OTHER
    node: str | None = None
    name: str | None = None
    edits: tuple[Edit, ...] = ()
    is_branch: bool = False
    ending: str = ""
    robot: str | None = None
    place: str = ""
    file: Path | None = None
    line: int = 0
    part_of: str = ""

    @property
    def whole(self) -> str:
        """The key of the entry that is lit along with it, or its own."""
        return self.part_of or self.key

    @property
    def owner(self) -> str | None:
        """The variable of what changes along with it."""
        return self.node or self.robot

    @property
    def statement(self) -> str | None:
        """The statement that ends what the entry shows, None where there is none."""
        if isinstance(self.subject, Subject):
            return self.ending or None
        from plastron_tui.language.sentence import sentence

        editing = self.subject.editing
        texts = {"node": self.node or "", editing.name_slot: self.name or ""}
        return sentence(editing.ending, texts)

    @property
    def writing(self) -> tuple[str, str] | None:
        """The statement that writes what it is about to files, and its variable; None for none."""
        if self.node is not None:
            return f"generate_node {self.node}", self.node
        if self.robot is not None:
            return f"generate_robot {self.robot}", self.robot
        word = _WRITTEN.get(self.subject)
        return None if word is None or not self.name else (f"{word} {self.name}", self.name)

    @property
    def elsewhere(self) -> str:
        """What is said when there is no statement to go to."""
        if self.place:
            return f"{self.text} is in {self.place}"
        if self.subject is not Subject.PROBLEM:
            return f"{self.text} is not written in this program"
        return f"this is about {self.name or 'the whole program'}, not about a statement"


class Entries:
    """The entries of a panel, in order, and which of them a place of the program belongs to."""

    def __init__(self, entries: Iterable[Entry] = (), empty: str = "") -> None:
        self.all = tuple(entries)
        self.empty = empty
        # A list, for speed: there may be thousands, at every key.
        places = [
            (entry.span.start, -entry.depth, number)
            for number, entry in enumerate(self.all)
            if entry.span is not None
        ]
        places.sort()
        self._starts = [start for start, _, _ in places]
        self._numbers = [number for _, _, number in places]

    def at(self, offset: int) -> Entry | None:
        """Return the entry whose statement is at an offset, None between statements."""
        place = bisect_right(self._starts, offset) - 1
        if place < 0:
            return None
        while place > 0 and self._starts[place - 1] == self._starts[place]:
            place -= 1
        entry = self.all[self._numbers[place]]
        assert entry.span is not None
        return entry if offset <= entry.span.end else None
