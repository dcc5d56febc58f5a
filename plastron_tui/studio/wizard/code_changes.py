"""What a statement changes in the code that it becomes: which lines are new, and where to look."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from difflib import SequenceMatcher
from typing import NamedTuple

from ..panels.styles import Line, Lines, Piece


class Code(NamedTuple):
    """The code that is shown.

    Attributes:
        name: of the file.
        lines: coloured; those that change are marked.
        change: the lines to be looked at, empty where nothing changes.
    """

    name: str
    lines: Lines
    change: range = range(0)


def marked(before: Lines, after: Lines) -> tuple[Lines, range]:
    """Return a file's lines with marks of a diff, and the most marked ones that hang together.

    Args:
        before: its lines without the change.
        after: its lines with it.
    """
    rows: list[Line] = []
    found = range(0)
    for kind, old, old_end, new, new_end in _opcodes(before, after):
        start = len(rows)
        if kind == "equal":
            rows += ((Piece(" "), *line) for line in after[new:new_end])
            continue
        rows += _changed("-", "removed", before[old:old_end])
        rows += _changed("+", "added", after[new:new_end])
        if len(rows) - start > len(found):
            found = range(start, len(rows))
    return tuple(rows), found


def changed_rows(before: Lines, after: Lines) -> range:
    """Return the rows of a file that are new, the most that hang together; empty for none."""
    found = [range(new, end) for kind, _, _, new, end in _opcodes(before, after) if kind != "equal"]
    return max(found, key=len, default=range(0))


def _opcodes(before: Lines, after: Lines) -> Sequence[tuple[str, int, int, int, int]]:
    old, new = (
        ["".join(piece.text for piece in line) for line in each] for each in (before, after)
    )
    return SequenceMatcher(None, old, new, autojunk=False).get_opcodes()


def _changed(mark: str, tone: str, lines: Lines) -> Iterator[Line]:
    """Yield lines on the ground of their tone, to the edge."""
    for line in lines:
        text = "".join(piece.text for piece in line)
        yield Piece(mark + text, tone), Piece("", tone)


def place_of(rows: range, height: int) -> int:
    """Return the first row in sight, so that others are: in the middle, or from their start on.

    Args:
        rows: what is to be looked at; empty for the start of the file.
        height: how many rows are in sight.
    """
    if not rows:
        return 0
    middle = rows.start + min(len(rows), height) // 2
    return max(0, middle - height // 2)
