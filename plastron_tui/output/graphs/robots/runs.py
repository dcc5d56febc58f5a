"""Pictures in characters: lines of text in colours that who shows them turns into a terminal's."""

from __future__ import annotations

from typing import NamedTuple, TypeAlias

ROLES = ("", "title", "link", "quiet", "axis", "marked")
"""What a text is, which says how it looks in a theme.

Plain, a heading, the sign of a link, what is said besides, the axis of a joint or its name, what is
pointed out.
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
