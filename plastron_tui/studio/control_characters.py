"""Nothing that a terminal would obey is in a line of the screen, wherever its text came from."""

from __future__ import annotations

import re

from rich.cells import cell_len
from rich.segment import Segment
from textual.color import Color
from textual.filter import LineFilter

# Controls (ECMA-48), separators, what turns the direction of a text or is invisible (Unicode,
# "Bidirectional controls", "Tags"), and halves of a character. What joins letters stays.
_OBEYED = re.compile(
    "[\x00-\x1f\x7f-\x9f\u061c\u200e\u200f\u2028-\u202e\u2060-\u206f\ufeff\ufff9-\ufffb"
    "\ud800-\udfff\U000e0000-\U000e007f]"
)
_REPLACEMENT = "�"


class OnlyText(LineFilter):
    """Takes out of a line what is no text, without moving what stands beside it."""

    def apply(self, segments: list[Segment], background: Color) -> list[Segment]:
        """Return the segments, those as they are that have nothing but text."""
        if all(segment.text.isprintable() for segment in segments):
            return segments
        return [_cleaned(segment) for segment in segments]


def _cleaned(segment: Segment) -> Segment:
    text = _OBEYED.sub(lambda match: _REPLACEMENT * cell_len(match.group()), segment.text)
    return segment if text == segment.text else segment._replace(text=text)


ONLY_TEXT = OnlyText()
