"""What was done to a text, to undo it and to do it again."""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import Enum, auto
from typing import NamedTuple

_MOST_STEPS, _MOST_BYTES = 10_000, 16 * 1024 * 1024
"""How much can be undone: so many steps, of so many bytes together; the last step always can."""

PAUSE = 2.0
"""Seconds without a key after which typing starts a step of its own."""


class Selection(NamedTuple):
    """A selected range, from where it was begun to where the cursor is."""

    anchor: int
    head: int

    @property
    def start(self) -> int:
        """The lower end."""
        return min(self)

    @property
    def end(self) -> int:
        """The upper end."""
        return max(self)

    @property
    def is_empty(self) -> bool:
        """Whether nothing is selected."""
        return self.anchor == self.head


class Change(NamedTuple):
    """The bytes at `start` were `old` and became `new`."""

    start: int
    old: bytes
    new: bytes


class Kind(Enum):
    """What an edit is: only typing, or deleting, that goes on joins the step before."""

    TYPE = auto()
    DELETE = auto()
    OTHER = auto()


@dataclass(slots=True)
class Step:
    """Changes that are undone together, in the order in which they were made."""

    kind: Kind
    changes: list[Change]
    before: Selection
    after: Selection
    time: float

    @property
    def size(self) -> int:
        """The bytes of the texts that it keeps."""
        return sum(len(change.old) + len(change.new) for change in self.changes)


@dataclass(slots=True)
class History:
    """The steps that can be undone, and those that were."""

    done: list[Step] = field(default_factory=list)
    undone: list[Step] = field(default_factory=list)
    _is_closed: bool = True
    _size: int = 0

    def add(self, step: Step) -> None:
        """Remember a step, or let the last one go on."""
        self._size += step.size - sum(each.size for each in self.undone)
        self.undone.clear()
        last = self.done[-1] if self.done and not self._is_closed else None
        if last is not None and _goes_on(last, step):
            last.changes[-1] = _joined(last.changes[-1], step.changes[0])
            last.after, last.time = step.after, step.time
        else:
            self.done.append(step)
        self._is_closed = False
        while len(self.done) > 1 and (len(self.done) > _MOST_STEPS or self._size > _MOST_BYTES):
            self._size -= self.done.pop(0).size

    def close(self) -> None:
        """Let the next edit be a step of its own, because the cursor went elsewhere."""
        self._is_closed = True


def _goes_on(last: Step, step: Step) -> bool:
    if step.kind is not last.kind or step.kind is Kind.OTHER or step.time - last.time > PAUSE:
        return False
    if len(step.changes) != 1 or len(last.changes) != 1:
        return False
    before, now = last.changes[0], step.changes[0]
    if step.kind is Kind.TYPE:
        starts_word = now.new[:1] != b" " and before.new[-1:] == b" "
        return not now.old and now.start == before.start + len(before.new) and not starts_word
    return not now.new and now.start in (before.start, before.start - len(now.old))


def _joined(before: Change, now: Change) -> Change:
    if now.new:
        return Change(before.start, before.old, before.new + now.new)
    if now.start < before.start:
        return Change(now.start, now.old + before.old, b"")
    return Change(before.start, before.old + now.old, b"")
