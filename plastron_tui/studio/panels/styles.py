"""Coloured text as data: a tone is the name of a colour, which the theme gives."""

from __future__ import annotations

from typing import NamedTuple

from rich.style import Style
from textual.geometry import Region
from textual.strip import Strip

from ..textual_private import StyledLate

TONES = (
    "quiet",
    "strong",
    "primary",
    "secondary",
    "accent",
    "success",
    "warning",
    "error",
    "added",
    "removed",
    "dim",
)
"""The tones; `studio.tcss` gives each its colour, as the component `tone--NAME`.

What has a colour of its own says it in the place of a tone, as `#3060ff` or `#3060ff on #ffffff`.
`keyword on added` has the letters of one tone on the ground of another, ` on added` plain letters.
"""

_SAME = {
    "keyword": "primary",
    "string": "accent",
    "number": "error",
    "name": "warning",
    "builtin": "secondary",
}
"""What source files need has the colour of a tone: each component costs time at every start."""

COMPONENTS = frozenset(f"tone--{tone}" for tone in TONES)


class Piece(NamedTuple):
    """Some characters of a line, and their tone."""

    text: str
    tone: str = ""


Line = tuple[Piece, ...]
"""A last piece without characters gives its tone to the rest of the row, to the edge."""
Lines = tuple[Line, ...]


def rest_of(line: Line) -> Line:
    """Return what the rest of a row has its tone of; nothing where it has none."""
    return line[-1:] if line and not line[-1].text else ()


def tone_style(widget: StyledLate, tone: str, prefix: str = "tone") -> Style:
    """Return the style of a tone in a widget that has `COMPONENTS`.

    A colour that lets the background through is mixed with it: a terminal cannot.
    """
    if not tone:
        return Style.null()
    letters, _, cells = tone.partition(" on ")
    if "#" in tone:
        return Style(color=letters or None, bgcolor=cells or None)
    if cells:
        ground = tone_style(widget, cells, prefix)
        # Where the ground has no colour of its own, the letters alone tell what it stands for.
        own = tone_style(widget, letters, prefix)
        return ground if ground.bgcolor is None else Style(bgcolor=ground.bgcolor) + own
    if prefix == "tone":
        tone = _SAME.get(tone, tone)
    styles = widget.component(f"{prefix}--{tone}")
    how = styles.text_style
    color, background = styles.color, styles.background
    behind = widget.background_colors[1]
    if color.ansi is not None:
        how += Style(color=color.rich_color, dim=color.a < 1 or None)
    elif styles.has_rule("color"):
        how += Style(color=behind.blend(color, color.a, 1).rich_color)
    if background.a and background.ansi is None and styles.has_rule("background"):
        how += Style(bgcolor=behind.blend(background, background.a, 1).rich_color)
    return how


class Toned(StyledLate):
    """A widget that remembers its tones until its style changes."""

    def __init__(self, *, id: str | None = None) -> None:  # noqa: A002 - Textual's word
        super().__init__(id=id)
        self._tones: dict[tuple[str, str], Style] = {}
        self._base: Style | None = None

    @property
    def rich_style(self) -> Style:
        """The style of its background; looked up once for all lines that are drawn in one go."""
        if self._base is None:
            return super().rich_style
        return self._base

    def render_lines(self, crop: Region) -> list[Strip]:
        """Draw lines."""
        self._base = super().rich_style
        try:
            return super().render_lines(crop)
        finally:
            self._base = None

    def tone(self, name: str, prefix: str = "tone") -> Style:
        """Return the style of a tone."""
        key = name, prefix
        style = self._tones.get(key)
        if style is None:
            style = self._tones[key] = tone_style(self, name, prefix)
        return style

    def notify_style_update(self) -> None:
        """Forget the tones: the theme is another one."""
        super().notify_style_update()
        self._tones = {}
