"""What a terminal shows: how wide a text is, whether in colour, and nothing that it would obey."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Mapping
from functools import lru_cache
from typing import Any, TextIO
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


def cut(text: str, cells: int) -> str:
    """Return as much of a text as so many cells take; one that is longer ends in `…`."""
    if width(text) <= cells:
        return text
    used, kept = 0, []
    for character in text:
        used += width(character)
        if used > cells - 1:
            break
        kept.append(character)
    return "".join(kept).rstrip() + "…"


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
    shown = ["".join(map(visible_character, part)) for part in plain]
    if not in_colour or not colours:
        return "".join(shown)
    last = "" if colours[-1] == _RESET else _RESET
    pairs = zip(shown, [*colours, last], strict=True)
    return "".join(part + colour for part, colour in pairs)


def is_only_colour(text: str) -> bool:
    """Tell whether a line of a program's output has nothing but colours."""
    return bool(text) and not _COLOUR.sub("", text)


def visible_text(text: str, *, in_colour: bool = False) -> str:
    """Return a text of several lines with what a terminal would obey escaped, as in each line."""
    if text.isprintable():
        return text
    return "\n".join(visible_line(line, in_colour=in_colour) for line in text.split("\n"))


class EscapingStream:
    """A terminal to write texts to: what it would obey is escaped, except for colours.

    It is the last of two guards: what quotes a file's text or name escapes colours too. Bytes
    that are written to its `buffer` pass as they are.

    Attributes:
        terminal: the stream itself, for who draws on it.
    """

    def __init__(self, terminal: TextIO) -> None:
        self.terminal = terminal

    def write(self, text: str) -> int:
        """Write a text."""
        self.terminal.write(visible_text(text, in_colour=True))
        return len(text)

    def writelines(self, lines: Iterable[str]) -> None:
        """Write texts one after the other."""
        for line in lines:
            self.write(line)

    def __getattr__(self, name: str) -> Any:
        return getattr(self.terminal, name)


def drawn_on(stream: TextIO) -> TextIO:
    """Return a stream without the guard, for what escapes all that it writes by itself."""
    return stream.terminal if isinstance(stream, EscapingStream) else stream


def visible_character(character: str) -> str:
    """Return a character escaped, but for tabs and the spaces of all scripts."""
    is_space = character == "\t" or category(character) == "Zs"
    return character if is_space else visible(character)
