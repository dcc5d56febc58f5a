"""The line above everything, and the line about the statement at the cursor."""

from __future__ import annotations

from typing import ClassVar

from rich.segment import Segment
from textual.strip import Strip

from plastron_tui.diagnostics.terminal import visible

from ..editor.statement_help import GAP
from .styles import Toned

_KEPT_BEFORE, _KEPT_AFTER = 2, 4
"""Words of a sentence that stay around the part at hand, however little room there is."""
_LONG_HELP = 45
"""From so many characters on a help can be cut: it says what all of the statement is for."""


class Bar(Toned):
    """A line with text at its left and at its right."""

    COMPONENT_CLASSES: ClassVar[set[str]] = {"bar--strong", "bar--quiet", "bar--here"}

    def __init__(self, *, id: str) -> None:  # noqa: A002 - Textual's word
        super().__init__(id=id)
        self.left: tuple[tuple[str, str], ...] = ()
        self.right: tuple[tuple[str, str], ...] = ()

    def show(
        self, left: tuple[tuple[str, str], ...], right: tuple[tuple[str, str], ...] = ()
    ) -> None:
        """Show pieces of text, each with the name of a component or ""."""
        left, right = _visible(left), _visible(right)
        if (left, right) != (self.left, self.right):
            self.left, self.right = left, right
            self.refresh()

    @property
    def text(self) -> str:
        """What the bar says."""
        return "".join(text for text, _ in (*self.left, *self.right))

    def _segments(self, pieces: tuple[tuple[str, str], ...]) -> list[Segment]:
        base = self.rich_style
        return [
            Segment(
                text,
                base + self.tone(tone, "bar"),
            )
            for text, tone in pieces
        ]

    def render_line(self, y: int) -> Strip:
        """Draw the line; the right side gives way to the left one."""
        width = self.size.width
        base = self.rich_style
        left = Strip([Segment(" ", base), *self._segments(self.left)])
        right = Strip([*self._segments(self.right), Segment(" ", base)])
        room = width - right.cell_length - 1
        if left.cell_length > room and right.cell_length > width // 2:
            right, room = Strip([]), width
        if left.cell_length > room:
            pieces = _shortened(self.left, left.cell_length - room)
            left = Strip([Segment(" ", base), *self._segments(pieces)])
        if left.cell_length > room:
            left = Strip([*left.crop(0, max(0, room - 1)), Segment("…", base)])
        left = left.extend_cell_length(width - right.cell_length, base)
        return Strip([*left, *right]).crop(0, width)


def _visible(pieces: tuple[tuple[str, str], ...]) -> tuple[tuple[str, str], ...]:
    return tuple((visible(text), tone) for text, tone in pieces)


def _shortened(pieces: tuple[tuple[str, str], ...], excess: int) -> tuple[tuple[str, str], ...]:
    """Leave out words around the part at hand, as many cells as are needed.

    Those between the first word and the part at hand go first, then those between it and its help;
    a few on both sides stay, without which the rest is no sentence.
    """
    if len(pieces) != 4:
        return pieces
    (before, tone), here, (after, after_tone), about = pieces
    first, _, between = before.partition(" ")
    if between:
        rest = between[excess + 2 :].partition(" ")[2]
        kept = max(rest, " ".join(between.split(" ")[-_KEPT_BEFORE - 1 :]), key=len)
        shown = f"{first} … {kept}"
        if len(shown) < len(before):
            excess -= len(before) - len(shown)
            before = shown
    if after and excess > 0:
        rest = after[: max(0, len(after) - excess - 2)].rpartition(" ")[0]
        near = " ".join(after.split(" ")[: _KEPT_AFTER + 1])
        kept = max(rest, near if len(about[0]) >= _LONG_HELP else "", key=len)
        after = min(f"{kept} …", after, key=len)
    return ((before, tone), here, (after, after_tone), about)


def help_pieces(text: str) -> tuple[tuple[str, str], ...]:
    """Return the line about a statement: what stands between `‹` and `›` is the part at hand."""
    before, mark, rest = text.partition("‹")
    if not mark:
        return ((text, "quiet"),)
    here, _, rest = rest.partition("›")
    after, gap, about = rest.partition(GAP)
    return ((before, "quiet"), (here, "here"), (after, "quiet"), (gap + about, "quiet"))
