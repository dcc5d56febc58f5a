"""Pictures in characters: lines of text in colours that who shows them turns into a terminal's."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple, TypeAlias

from plastron_tui.diagnostics.terminal import width

ROLES = ("", "title", "link", "joint", "quiet", "axis", "marked")
"""What a text is, which says how it looks in a theme.

Plain, a heading, the name of a link, that of a joint, what is said besides, an axis in a view,
what is pointed out.
"""


class Run(NamedTuple):
    """Some characters that look alike.

    Attributes:
        text: the characters.
        role: what they are, one of `ROLES`.
        color: their colour as `#rrggbb`, "" for that of the role.
        behind: the colour behind them, "" for that of the terminal.
    """

    text: str
    role: str = ""
    color: str = ""
    behind: str = ""


RunLine: TypeAlias = tuple[Run, ...]
RunLines: TypeAlias = tuple[RunLine, ...]


def text_of(line: RunLine) -> str:
    """Return a line without its colours."""
    return "".join(run.text for run in line)


def fitted(line: RunLine, room: int, dots: str = "…") -> RunLine:
    """Return a line with just so many cells: cut off with dots, or filled up with blanks."""
    if room <= 0:
        return ()
    total = sum(width(run.text) for run in line)
    if total <= room:
        return (*line, Run(" " * (room - total))) if total < room else line
    return tuple(_cut(line, room, dots))


def _cut(line: RunLine, room: int, dots: str) -> Iterator[Run]:
    left = room - 1
    for run in line:
        kept = ""
        for char in run.text:
            cells = width(char)
            if cells > left:
                yield run._replace(text=f"{kept}{dots}{' ' * left}")
                return
            kept += char
            left -= cells
        if kept:
            yield run._replace(text=kept)
