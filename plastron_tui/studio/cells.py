"""Texts in the cells of the studio's screen, as Textual counts them."""

from __future__ import annotations

from rich.cells import cell_len, get_character_cell_size, set_cell_size


def cut(text: str, cells: int) -> str:
    """Return as much of a text as so many cells take; one that is longer ends in `…`."""
    if cell_len(text) <= cells:
        return text
    return set_cell_size(text, cells - 1).rstrip() + "…" if cells > 0 else ""


def fitted(text: str, cells: int) -> str:
    """Return a text in just so many cells, with blanks behind it where it is shorter."""
    return set_cell_size(cut(text, cells), cells)


def end_of(text: str, cells: int) -> str:
    """Return as much of the end of a text as so many cells take; a longer one begins with `…`."""
    if cell_len(text) <= cells:
        return text
    start, room = len(text), cells - 1
    while start and (room := room - get_character_cell_size(text[start - 1])) >= 0:
        start -= 1
    return f"…{text[start:]}" if cells > 0 else ""
