"""Where what is under the cursor is used, whatever it is: all places of the program."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.diagnostics import Span

from .name_uses import name_at, same_words, uses_of
from .names import variable_at
from .robot_parts import find_part, part_at

if TYPE_CHECKING:
    from collections.abc import Callable

    from plastron_tui.language import Document


class Uses(NamedTuple):
    """Where something is used: what it is called, and the places in order."""

    name: str
    places: tuple[Span, ...]


class UseLine(NamedTuple):
    """A line on which something is used: its number, from 1, its text, and the place in it."""

    number: int
    text: str
    place: Span


def uses_at(
    document: Document, offset: int, loaded_with: Callable[[str, str], set[str]]
) -> Uses | None:
    """Return where what is at an offset is used, None where nothing is that could be.

    Args:
        document: the program.
        offset: the place.
        loaded_with: returns the variables of nodes whose files have something, by what it is
            (`topic` and so on) and its name.
    """
    variable = variable_at(document, offset)
    if variable is None:
        part = part_at(document, offset)
        variable = None if part is None else find_part(document, part)
    if variable is not None:
        return Uses(variable.name, variable.places)
    name = name_at(document, offset)
    if name is not None:
        loaded = loaded_with(name.what, name.text)
        if name.owner:
            loaded &= {name.owner}
        return Uses(name.text, tuple(uses_of(document, name, loaded)))
    for kind in ("function", "type"):
        found = same_words(document, offset, kind)
        if found is not None:
            return Uses(*found)
    return None


def lines_of(text: bytes, places: tuple[Span, ...]) -> tuple[UseLine, ...]:
    """Return the lines that places are on, each line once, with its first place."""
    lines: dict[int, UseLine] = {}
    for place in sorted(places):
        start = text.rfind(b"\n", 0, place.start) + 1
        if start not in lines:
            end = text.find(b"\n", start)
            line = text[start : len(text) if end < 0 else end]
            number = text.count(b"\n", 0, start) + 1
            lines[start] = UseLine(number, line.decode("utf-8", "replace").strip(), place)
    return tuple(lines.values())
