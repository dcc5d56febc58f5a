"""Coloured text as data: a tone is the name of a colour, which the theme gives."""

from __future__ import annotations

from typing import NamedTuple

from rich.style import Style
from textual.widget import Widget

TONES = (
    "quiet",
    "strong",
    "primary",
    "secondary",
    "accent",
    "success",
    "warning",
    "error",
    "keyword",
    "string",
    "number",
    "name",
    "builtin",
    "added",
    "removed",
    "dim",
)
"""The tones; `studio.tcss` gives each its colour, as the component `tone--NAME`."""

COMPONENTS = frozenset(f"tone--{tone}" for tone in TONES)


class Piece(NamedTuple):
    """Some characters of a line, and their tone."""

    text: str
    tone: str = ""


Line = tuple[Piece, ...]
Lines = tuple[Line, ...]


def tone_style(widget: Widget, tone: str) -> Style:
    """Return the style of a tone in a widget that has `COMPONENTS`."""
    if not tone:
        return Style.null()
    return widget.get_component_rich_style(f"tone--{tone}", partial=True)
