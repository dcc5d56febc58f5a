"""Contrast: whatever is to be read on the screen can be, in every theme.

Contrast and relative luminance are those of WCAG 2 (success criterion 1.4.3), which asks for 4.5
to 1 of text. `LEGIBLE` sees each line of the screen last, so no rule of a style sheet, of Textual's
or of ours, and no theme has to be right for that.
"""

from __future__ import annotations

import re
from bisect import bisect_left
from functools import lru_cache

from rich.color import Color as TerminalColor
from rich.color import ColorType
from rich.segment import Segment
from rich.style import Style
from textual.color import Color
from textual.filter import LineFilter

from .control_characters import ONLY_TEXT

LEAST = 4.5
"""The least contrast of text with what is behind it."""

_STEPS = 64
_EVEN_LUMINANCE = 0.179
"""The luminance of a background on which black and white have the same contrast."""
_WHITE, _BLACK = Color(255, 255, 255), Color(0, 0, 0)

# Lines, blocks and dots of a picture, and what shows a colour, are not read.
_READ = re.compile("[^\\s\u2500-\u25ff\u2800-\u28ff]")

_SIXTEEN = tuple(
    Color.parse(f"#{digits}")
    for digits in (
        *("000000", "cd0000", "00cd00", "cdcd00", "0000ee", "cd00cd", "00cdcd", "e5e5e5"),
        *("7f7f7f", "ff0000", "00ff00", "ffff00", "5c5cff", "ff00ff", "00ffff", "ffffff"),
    )
)
"""The sixteen colours of a terminal, as xterm has them by default; others differ a little."""


@lru_cache(4096)
def luminance(color: Color) -> float:
    """Return the relative luminance of a colour, from 0 to 1."""
    parts = (part / 255 for part in color.rgb)
    linear = [
        part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4 for part in parts
    ]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def contrast(one: Color, other: Color) -> float:
    """Return the contrast of two colours, from 1 to 21."""
    low, high = sorted((luminance(one), luminance(other)))
    return (high + 0.05) / (low + 0.05)


def legible(color: Color, background: Color) -> Color:
    """Move a colour towards white or black, as far as it takes to read it on the background."""
    if contrast(color, background) >= LEAST:
        return color
    target = _WHITE if luminance(background) < _EVEN_LUMINANCE else _BLACK

    def is_enough(step: int) -> bool:
        return contrast(color.blend(target, step / _STEPS, 1), background) >= LEAST

    step = bisect_left(range(_STEPS), True, key=is_enough)
    return color.blend(target, step / _STEPS, 1)


@lru_cache(4096)
def legible_style(style: Style, background: Color) -> Style | None:
    """Return a style whose text can be read, None where it can be as it is.

    Of the terminal's own colours nothing is known but the sixteen that have a number.

    Args:
        style: the style of some text.
        background: what is behind text of a style that says nothing of it.
    """
    front, back = style.color, style.bgcolor
    behind = None if background.ansi is not None or background.a < 1 else background
    letters, cells = _seen(front), behind if back is None else _seen(back)
    if cells is not None and back is not None and _is_default(front) and not style.reverse:
        # Letters of the terminal's own colour go with its own ground, and with no other.
        letters = _WHITE if luminance(cells) < _EVEN_LUMINANCE else _BLACK
        return style + Style(color=_told(letters, back))
    if letters is None or cells is None:
        return None
    # In reverse the letters have the colour of the background; that one is moved then.
    if style.reverse:
        moved = legible(cells, letters)
        return None if moved == cells else style + Style(bgcolor=_told(moved, back))
    moved = legible(letters, cells)
    return None if moved == letters else style + Style(color=_told(moved, front))


def _is_default(color: TerminalColor | None) -> bool:
    return color is None or color.is_default


def _seen(color: TerminalColor | None) -> Color | None:
    """Return what a colour looks like, None where only the terminal knows."""
    if color is None:
        return None
    if color.triplet is not None:
        return Color(*color.triplet)
    if color.type is ColorType.STANDARD and color.number is not None:
        return _SIXTEEN[color.number]
    return None


def _told(moved: Color, before: TerminalColor | None) -> TerminalColor:
    """Return a colour for the terminal: of its own sixteen, where the one before it was."""
    if before is None or before.type is not ColorType.STANDARD:
        return moved.rich_color
    is_light = luminance(moved) >= _EVEN_LUMINANCE
    return TerminalColor.parse("bright_white" if is_light else "black")


class Legible(LineFilter):
    """Gives the text of a line as much contrast as it takes to read it."""

    def apply(self, segments: list[Segment], background: Color) -> list[Segment]:
        """Return the segments, those as they are that can be read."""
        return [_read(segment, background) for segment in segments]


def _read(segment: Segment, background: Color) -> Segment:
    text, style, control = segment
    if style is None:
        return segment
    better = legible_style(style, background)
    if better is None or not _READ.search(text):
        return segment
    return Segment(text, better, control)


LEGIBLE = Legible()


class LegibleText(LineFilter):
    """Lets nothing in a line be obeyed, and all of it be read; makes a line anew once for both."""

    def apply(self, segments: list[Segment], background: Color) -> list[Segment]:
        """Return the segments, those as they are that need no change."""
        return LEGIBLE.apply(ONLY_TEXT.apply(segments, background), background)


LEGIBLE_TEXT = LegibleText()
