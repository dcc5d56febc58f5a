"""What is wrong, in the order of the program."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator
from pathlib import Path
from typing import TYPE_CHECKING

from plastron_tui.diagnostics import Diagnostic, LineIndex, Severity

from .entry import Entries, Entry, Subject

if TYPE_CHECKING:
    from ..analysis import Analysis


_EMPTY = "no problems"

_SIGNS = {
    Severity.ERROR: ("✖", "error"),
    Severity.WARNING: ("▲", "warning"),
    Severity.NOTE: ("·", "quiet"),
}
"""The sign of a problem and its tone."""


def make(analysis: Analysis, _: object) -> Entries:
    """Make what the panel shows."""
    in_order = sorted(
        (*analysis.diagnostics, *analysis.in_files),
        key=lambda found: (found.file is not None, found.span or (0, 0)),
    )
    lines = analysis.session.lines
    return Entries((entry for found in in_order for entry in _problem(found, lines)), _EMPTY)


def without(entries: Entries, held: Collection[Diagnostic]) -> Entries:
    """Return the entries of problems without those of some mistakes of the program itself."""
    keys = {(_key(each), each.span) for each in held}
    left = []
    is_left = True
    for entry in entries.all:
        if not entry.depth:
            is_left = (entry.key, entry.span) not in keys
        if is_left:
            left.append(entry)
    return Entries(left, _EMPTY)


def _key(found: Diagnostic) -> str:
    return f"problem {found.code} {found.message}"


def _problem(
    found: Diagnostic, lines: Callable[[Path | None], LineIndex | None]
) -> Iterator[Entry]:
    index = None if found.span is None else lines(found.file)
    where = found.file.name if found.file is not None else ""
    line = 0 if index is None or found.span is None else index.position(found.span.start).line
    if line:
        where = f"{where}:{line}" if where else f"line {line}"
    own = found.file is None
    key = _key(found)
    yield Entry(
        key,
        found.message,
        " · ".join(part for part in (where, found.code) if part),
        *_SIGNS[found.severity],
        span=found.span if own else None,
        subject=Subject.PROBLEM,
        name=None if own else where,
        edits=found.fix.edits if found.fix is not None and own else (),
        warning=found.fix.title if found.fix is not None and own else "",
        is_branch=found.help is not None or bool(found.labels),
        file=found.file,
        line=line,
    )
    if found.help is not None:
        span = found.span if own else None
        yield Entry(
            f"help {key}",
            found.help,
            sign="=",
            depth=1,
            span=span,
            subject=Subject.PROBLEM,
            name=None if own else where,
            file=found.file,
            line=line,
            part_of=key,
        )
    if not own or index is None:
        return
    for number, label in enumerate(found.labels):
        yield Entry(
            f"label {number} {key}",
            label.message,
            f"line {index.position(label.span.start).line}",
            "→",
            depth=1,
            span=label.span,
            subject=Subject.PROBLEM,
        )


def count(analysis: Analysis) -> int:
    """Return how much there is."""
    return len(analysis.diagnostics) + len(analysis.in_files)
