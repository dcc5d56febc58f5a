"""What changes in a source file, as lines in the colours of its language, with their numbers."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

from plastron_tui.output.diff import file_diff, text_diff, visible_patch
from plastron_tui.output.plan import PlannedFile

from .source_lines import coloured
from .styles import Line, Lines, Piece

_HUNK = re.compile(r"@@ -(\d+)(?:,\d+)? \+(\d+)(?:,\d+)? @@")

_GROUNDS = {"+": "added", "-": "removed"}

_FILE_NAMES = ("diff --git", "index ", "--- ", "+++ ")
"""What the rows begin with that name a patch's file: who looks at a diff knows it."""


def difference(before: bytes, after: bytes, path: Path) -> Lines:
    """Return how two texts of a file differ."""
    patch = visible_patch(text_diff(before, after))
    return diff_lines(patch, _coloured(before, path), _coloured(after, path))


def planned_diff(file: PlannedFile) -> Lines:
    """Return what writing a file changes in it."""
    before, after = _coloured(file.before or b"", file.path), _coloured(file.text, file.path)
    return diff_lines(visible_patch(file_diff(file)), before, after)


def diff_lines(patch: str, before: Lines, after: Lines) -> Lines:
    """Return the rows of a patch: a line's number, its sign, and its text in colours.

    A line that goes has the number that it had, every other one the number that it will have.

    Args:
        patch: the patch of one file, as `visible_patch` shows it.
        before: the file's lines, coloured.
        after: the lines that it will have, coloured.
    """
    digits = max(3, len(str(max(len(before), len(after)))))
    lines = list(_rows(patch, before, after, digits))
    while lines and not "".join(piece.text for piece in lines[-1]).strip():
        lines.pop()
    return tuple(lines)


def _rows(patch: str, before: Lines, after: Lines, digits: int) -> Iterator[Line]:
    old = new = 0
    is_in_hunk = False
    for row in patch.split("\n"):
        hunk = _HUNK.match(row)
        if hunk is not None:
            old, new = int(hunk[1]), int(hunk[2])
            if is_in_hunk or new > 1:
                # The numbers beside the lines say which are left out.
                yield (Piece(f"{'⋯':>{digits}}", "quiet"),)
            is_in_hunk = True
        elif not is_in_hunk:
            if not row.startswith(_FILE_NAMES):
                yield (Piece(row),)
        elif row[:1] == "-":
            yield _row(row, old, before, digits)
            old += 1
        elif row[:1] in ("+", " "):
            yield _row(row, new, after, digits)
            new += 1
            old += row[0] == " "
        else:
            yield (Piece(row, "quiet"),)


def _row(row: str, number: int, lines: Lines, digits: int) -> Line:
    """Return a row of a patch; `number` is that of its line in the file, from 1."""
    sign, text = row[0], row[1:].expandtabs(4)
    ground = _GROUNDS.get(sign, "")
    line = lines[number - 1] if 0 < number <= len(lines) else ()
    if "".join(piece.text for piece in line) != text:
        # What the patch shows escaped has other columns: no colours are better than wrong ones.
        line = (Piece(text),)
    on = f" on {ground}" if ground else ""
    pieces = [Piece(f"{number:>{digits}} ", f"dim{on}"), Piece(sign, ground)]
    pieces += [Piece(piece.text, f"{piece.tone}{on}") for piece in line if piece.text]
    return (*pieces, Piece("", ground)) if ground else tuple(pieces)


def _coloured(text: bytes, path: Path) -> Lines:
    return coloured(text.decode("utf-8", "replace"), path)
