"""How an entry is drawn in a line of so many cells, and what stands where there is none."""

from __future__ import annotations

from rich.cells import cell_len, set_cell_size

from .broken_lines import broken
from .entry import Entry
from .styles import Line, Lines, Piece


def entry_line(entry: Entry, width: int, *, is_folded: bool, remark: str | None) -> Line:
    """Return an entry as a line: its sign and text, its detail, what is wrong with it.

    What is wrong goes before the detail where there is no room for both, and its sign before the
    end of the text.

    Args:
        entry: the entry.
        width: the cells that there are.
        is_folded: whether what belongs to it is out of sight.
        remark: what is wrong with it besides its own warning.
    """
    parts = [
        Piece(" " + "  " * entry.depth, ""),
        Piece(f"{entry.sign} " if entry.sign else "", entry.tone),
    ]
    fold = "…" if entry.is_branch and is_folded else ""
    parts.append(Piece(entry.text + fold, "strong" if entry.depth == 0 else ""))
    room = width - sum(cell_len(text) for text, _ in parts) - 1
    said = remark or entry.warning
    sign = " ⚑" if entry.edits else " ⚠" if said else ""
    warning = f"{sign} {said}" if sign else ""
    if cell_len(warning) > room:
        warning = sign
        if cell_len(sign) > room:
            text, tone = parts.pop()
            size = max(1, cell_len(text) + room - cell_len(sign) - 1)
            parts.append(Piece(set_cell_size(text, size).rstrip() + "…", tone))
            room = 0
    room -= cell_len(warning)
    if entry.detail and room > 3:
        detail = entry.detail
        if cell_len(detail) + 1 > room:
            detail = set_cell_size(detail, room - 2).rstrip() + "…"
        parts.append(Piece(f" {detail}", "quiet"))
    parts.append(Piece(warning, "success" if entry.edits else "warning"))
    return tuple(part for part in parts if part.text)


def empty_rows(text: str, width: int) -> Lines:
    """Return what a list without entries says, in rows of at most so many cells."""
    first, *rest = text.split("\n")
    lines = [Piece(f" {first}", "quiet"), *(Piece(f" {line}", "dim") for line in rest)]
    return tuple(row for line in lines for row in broken((line,), width, 1))
