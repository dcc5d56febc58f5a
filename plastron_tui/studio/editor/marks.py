"""Diagnostics as marks of a text, which move along while it is edited."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

from plastron_tui.diagnostics import Diagnostic, Severity
from plastron_tui.diagnostics.terminal import visible

from .offsets import Offsets
from .state import Edited


class Mark(NamedTuple):
    """A mistake: where it is by now, and what is said about it."""

    start: int
    end: int
    severity: Severity
    message: str


class Marks:
    """The mistakes of a text, found by their place."""

    def __init__(self, diagnostics: Iterable[Diagnostic] = ()) -> None:
        found = sorted(
            (
                (diagnostic.span.start, diagnostic.span.end, diagnostic)
                for diagnostic in diagnostics
                if diagnostic.span is not None
            ),
            key=lambda entry: entry[:2],
        )
        self._starts = Offsets(start for start, _, _ in found)
        self._lengths = [max(0, end - start) for start, end, _ in found]
        self._diagnostics = [diagnostic for _, _, diagnostic in found]

    def __len__(self) -> int:
        return len(self._diagnostics)

    def between(self, start: int, end: int) -> list[Mark]:
        """Return the marks that start from one offset to another, both inclusive."""
        first, last = self._starts.at_or_after(start), self._starts.after(end)
        return [self._mark(index) for index in range(first, last)]

    def next_after(self, offset: int) -> Mark | None:
        """Return the first mark beyond an offset, from the top again after the last."""
        if not self._diagnostics:
            return None
        return self._mark(self._starts.after(offset) % len(self._diagnostics))

    def previous_before(self, offset: int) -> Mark | None:
        """Return the last mark before an offset, from the bottom again before the first."""
        if not self._diagnostics:
            return None
        return self._mark(self._starts.at_or_after(offset) - 1)

    def starts(self) -> list[int]:
        """Return where the marks start."""
        return [self._starts[index] for index in range(len(self._diagnostics))]

    def edited(self, edited: Edited) -> None:
        """Move along with an edit."""
        if not self._diagnostics:
            return
        start, old_end, new_end = edited.start, edited.old_end, edited.new_end
        shift = new_end - old_end
        before = self._starts.after(start) - 1
        if before >= 0 and old_end <= self._starts[before] + self._lengths[before]:
            self._lengths[before] = max(0, self._lengths[before] + shift)
        first, last = self._starts.after(start), self._starts.after(old_end)
        self._starts.edit(first, last, [start] * (last - first), shift)

    def _mark(self, index: int) -> Mark:
        start = self._starts[index]
        diagnostic = self._diagnostics[index]
        end = start + self._lengths[index]
        return Mark(start, end, diagnostic.severity, visible(diagnostic.message))


def worst(marks: list[Mark]) -> Mark | None:
    """Return the first error, or else the first warning."""
    errors = (mark for mark in marks if mark.severity is Severity.ERROR)
    return next(errors, marks[0] if marks else None)
