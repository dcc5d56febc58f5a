"""Which theme a terminal begins with, and which grounds a theme has for the text and around it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from textual.color import Color, ColorParseError

DEFAULT_THEME = "textual-dark"
_SMALL = "ansi-dark"
"""The theme of terminals that have only their own sixteen colours."""
_SMALL_TERMINALS = frozenset({"linux", "xterm", "screen", "rxvt", "ansi", "vt100", "vt220"})
_LIGHT = 0.5
"""The brightness from which on a ground is a light one."""


class Grounds(NamedTuple):
    """The grounds of a theme, as a style sheet has them.

    Attributes:
        text: that of the program's text.
        panels: that of the panels around it.
    """

    text: str
    panels: str


def usual_theme(environ: Mapping[str, str]) -> str:
    """Return the theme that is shown where nobody has chosen one."""
    term = environ.get("TERM", "")
    is_small = term in _SMALL_TERMINALS or term.endswith("-16color")
    return _SMALL if is_small and not environ.get("COLORTERM") else DEFAULT_THEME


def grounds_of(variables: Mapping[str, str]) -> Grounds:
    """Return the grounds of a theme: of a light one that of the text is the lightest.

    Textual's `surface` lies above its `background`, and is the brighter one in dark themes; in most
    of the light ones it is the darker one.
    """
    background, surface = variables["background"], variables["surface"]
    try:
        below, above = Color.parse(background), Color.parse(surface)
    except ColorParseError:
        return Grounds(surface, background)
    is_mixed = all(each.ansi is None and each.a == 1 for each in (below, above))
    if is_mixed and below.brightness > _LIGHT and above.brightness < below.brightness:
        return Grounds(background, surface)
    return Grounds(surface, background)


def with_grounds(variables: dict[str, str]) -> dict[str, str]:
    """Add the grounds to a theme's variables: `text-ground` and `panel-ground`."""
    text, panels = grounds_of(variables)
    variables.update({"text-ground": text, "panel-ground": panels})
    return variables
