"""A text being edited: its selection and its history, and nothing of a screen."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from time import monotonic
from typing import NamedTuple

from plastron_tui.diagnostics import Edit
from plastron_tui.session import Session

from .buffer import Buffer
from .history import Change, History, Kind, Selection, Step

Splice = tuple[int, int, bytes]
"""Replace the bytes from the first offset to the second."""


class Edited(NamedTuple):
    """What an edit did: bytes at `start`, and rows from `row` on, were replaced."""

    start: int
    old_end: int
    new_end: int
    row: int
    old_rows: int
    new_rows: int


class EditingState(NamedTuple):
    """Where somebody was in a text: what is kept of it while another text is in the editor."""

    selection: Selection
    history: History
    scroll: tuple[int, int]


class TextState:
    """The text of a session with a selection and a history.

    Every edit goes through `apply`; `listeners` hear of each as it is made.
    """

    buffer: Buffer
    selection: Selection
    history: History
    goal: int | None
    """The cell that the cursor would go back to when it moves up and down."""

    def __init__(self, session: Session) -> None:
        self.listeners: list[Callable[[Edited], None]] = []
        self.open(session)

    def open(self, session: Session, before: EditingState | None = None) -> None:
        """Edit the text of another session: from its start, or as it was edited `before`."""
        self.buffer = Buffer(session)
        self.selection = Selection(0, 0) if before is None else before.selection
        self.history = History() if before is None else before.history
        self.history.close()
        self.goal = None

    @property
    def cursor(self) -> int:
        """The offset of the cursor."""
        return self.selection.head

    @property
    def row(self) -> int:
        """The row of the cursor."""
        return self.buffer.row(self.cursor)

    @property
    def selected(self) -> bytes:
        """The selected text."""
        return self.buffer.text[self.selection.start : self.selection.end]

    def select(self, anchor: int, head: int) -> None:
        """Select a range; the next edit is a step of its own."""
        clamp = self.buffer.clamp
        self.selection = Selection(clamp(anchor), clamp(head))
        self.goal = None
        self.history.close()

    def move(self, offset: int, *, extend: bool = False, goal: int | None = None) -> None:
        """Move the cursor, or with `extend` the end of the selection."""
        self.select(self.selection.anchor if extend else offset, offset)
        self.goal = goal

    def apply(
        self,
        splices: Sequence[Splice],
        after: Selection | None = None,
        kind: Kind = Kind.OTHER,
    ) -> None:
        """Make edits, all in terms of the text as it is now, as one step of the history.

        Args:
            splices: the edits; they do not overlap.
            after: the selection afterwards; None puts the cursor behind the last edit.
            kind: whether it is typing that may join the step before.
        """
        ordered = sorted(splices, key=lambda splice: splice[0])[::-1]
        changes = [
            Change(start, self.buffer.text[start:end], new)
            for start, end, new in ordered
            if self.buffer.text[start:end] != new
        ]
        before = self.selection
        for change in changes:
            self._replace(change.start, len(change.old), change.new)
        if after is None and ordered:
            moved = sum(len(new) - (end - start) for start, end, new in ordered[1:])
            behind = ordered[0][0] + len(ordered[0][2]) + moved
            after = Selection(behind, behind)
        self.selection = self._clamped(after or before)
        self.goal = None
        if changes:
            self.history.add(Step(kind, changes, before, self.selection, monotonic()))

    def replace_selection(self, new: bytes, kind: Kind = Kind.OTHER) -> None:
        """Replace what is selected, or insert at the cursor."""
        start, end = self.selection.start, self.selection.end
        self.apply([(start, end, new)], kind=kind)

    def edit(self, edits: Iterable[Edit]) -> None:
        """Make edits, all in terms of the text as it is now; the cursor stays where it is."""
        normalized = self.buffer.normalized
        splices = [(edit.span.start, edit.span.end, normalized(edit.text)) for edit in edits]
        splices.sort()
        cursor = shifted(splices, self.cursor)
        self.apply(splices, Selection(cursor, cursor))

    def replace_all(self, new: bytes) -> None:
        """Replace the whole text; only what differs is touched, the cursor stays in its row."""
        old = self.buffer.text
        start = _common_prefix(old, new)
        end = _common_prefix(old[start:][::-1], new[start:][::-1])
        row, cell = self.row, self.buffer.cell(self.cursor)
        self.apply([(start, len(old) - end, new[start : len(new) - end])])
        self.move(self.buffer.at_cell(min(row, self.buffer.row_count - 1), cell))

    def delete(self, start: int, end: int) -> None:
        """Delete a range; deletes that follow each other are undone together."""
        if start < end:
            self.apply([(start, end, b"")], Selection(start, start), Kind.DELETE)

    def undo(self) -> bool:
        """Take the last step back; False when there is none."""
        if not self.history.done:
            return False
        step = self.history.done.pop()
        for start, old, new in reversed(step.changes):
            self._replace(start, len(new), old)
        self.history.undone.append(step)
        self._came_back(step.before)
        return True

    def redo(self) -> bool:
        """Make the step again that was undone last; False when there is none."""
        if not self.history.undone:
            return False
        step = self.history.undone.pop()
        for start, old, new in step.changes:
            self._replace(start, len(old), new)
        self.history.done.append(step)
        self._came_back(step.after)
        return True

    def _came_back(self, selection: Selection) -> None:
        self.selection = self._clamped(selection)
        self.goal = None
        self.history.close()

    def _clamped(self, selection: Selection) -> Selection:
        return Selection(*map(self.buffer.clamp, selection))

    def _replace(self, start: int, length: int, new: bytes) -> None:
        buffer = self.buffer
        old_end = start + length
        row = buffer.row(start)
        old_rows = buffer.row(old_end) - row + 1
        buffer.edit(start, old_end, new)
        edited = Edited(
            start, old_end, start + len(new), row, old_rows, buffer.row(start + len(new)) - row + 1
        )
        for listener in self.listeners:
            listener(edited)


def shifted(splices: Iterable[Splice], offset: int) -> int:
    """Return where an offset is after edits; within a replaced range, at its end."""
    moved = offset
    for start, end, new in splices:
        if end <= offset:
            moved += len(new) - (end - start)
        elif start < offset:
            moved += len(new) - (offset - start)
    return moved


def _common_prefix(one: bytes, other: bytes) -> int:
    """Return how many bytes two texts have in common at their start."""
    low, high = 0, min(len(one), len(other))
    while low < high:
        middle = (low + high + 1) // 2
        if one[low:middle] == other[low:middle]:
            low = middle
        else:
            high = middle - 1
    return low
