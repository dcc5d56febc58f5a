"""What a terminal shows: how wide a text is, whether in colour, and nothing that it would obey."""

from __future__ import annotations

import os
import re
from collections.abc import Mapping
from functools import lru_cache
from typing import TextIO
from unicodedata import category, east_asian_width

# "Select graphic rendition" (ECMA-48, 8.3.117): colours and weights, which end with the line.
_COLOUR = re.compile("(\x1b\\[[0-9;:]*m)")
_RESET = "\x1b[0m"


def wants_colour(stream: TextIO, environ: Mapping[str, str] = os.environ) -> bool:
    """Tell whether to write colours to a stream.

    `NO_COLOR` says no and `FORCE_COLOR` yes, in that order; else a terminal has them, unless it
    is a dumb one. A variable that is empty says nothing (no-color.org, force-color.org).
    """
    if environ.get("NO_COLOR"):
        return False
    if environ.get("FORCE_COLOR"):
        return True
    try:
        return environ.get("TERM") != "dumb" and stream.isatty()
    except ValueError:  # it is closed
        return False


def width(text: str) -> int:
    """Return how many cells of a terminal a text takes."""
    return len(text) if text.isascii() else sum(map(_cells, text))


@lru_cache(maxsize=4096)
def _cells(character: str) -> int:
    if category(character) in {"Mn", "Me"}:
        return 0
    return 2 if east_asian_width(character) in {"W", "F"} else 1


def visible(text: str) -> str:
    r"""Return a text in one line, with what is invisible escaped: `\n`, `\x1b`, `\u202e`."""
    if text.isprintable():
        return text
    return "".join(each if each.isprintable() else ascii(each)[1:-1] for each in text)


def visible_line(text: str, *, in_colour: bool) -> str:
    r"""Return a line of a program's output with what a terminal would obey escaped.

    Tabs and the spaces of all scripts stay; colours stay where they are wanted, and end with the
    line.
    """
    if text.isprintable():
        return text
    parts = _COLOUR.split(text)
    plain, colours = parts[::2], parts[1::2]
    shown = ["".join(map(_visible, part)) for part in plain]
    if not in_colour or not colours:
        return "".join(shown)
    pairs = zip(shown, [*colours, _RESET], strict=True)
    return "".join(part + colour for part, colour in pairs)


def _visible(character: str) -> str:
    is_space = character == "\t" or category(character) == "Zs"
    return character if is_space else visible(character)
