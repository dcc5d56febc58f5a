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
_HELP = "help "

_SIGNS = {
    Severity.ERROR: ("✖", "error"),
    Severity.WARNING: ("▲", "warning"),
    Severity.NOTE: ("·", "quiet"),
}
"""The sign of a problem and its tone."""


def make(analysis: Analysis, _: object) -> Entries:
    """Make what the panel shows."""
    in_order = sorted(
        analysis.diagnostics, key=lambda found: (found.file is not None, found.span or (0, 0))
    )
    lines = analysis.session.lines
    return Entries((entry for found in in_order for entry in _problem(found, lines)), _EMPTY)


def without(entries: Entries, held: Collection[Diagnostic]) -> Entries:
    """Return the entries of problems without those of some mistakes of the program itself."""
    keys = {(prefix + _key(each), each.span) for each in held for prefix in ("", _HELP)}
    return Entries((each for each in entries.all if (each.key, each.span) not in keys), _EMPTY)


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
        is_branch=found.help is not None,
        file=found.file,
        line=line,
    )
    if found.help is not None:
        span = found.span if own else None
        yield Entry(
            f"{_HELP}{key}",
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


def count(analysis: Analysis) -> int:
    """Return how much there is."""
    return len(analysis.diagnostics)
