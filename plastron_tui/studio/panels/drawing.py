"""What hangs together in a graph as boxes and arrows of characters, at several sizes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, NamedTuple

from rich.cells import cell_len

from plastron_tui.diagnostics.terminal import visible

from ..cells import cut
from .styles import Line, Lines, Piece
from .wires import HEADS, line_characters

if TYPE_CHECKING:
    from plastron_tui.output.graphs.grid import Grid
    from plastron_tui.output.graphs.layers import Columns
    from plastron_tui.output.graphs.sheet import Measure
    from plastron_tui.output.graphs.wiring import Place


class _Sheet:
    """Characters with tones, by place; it grows as it is drawn on."""

    def __init__(self) -> None:
        self.rows: list[dict[int, tuple[str, str]]] = []

    def put(self, x: int, y: int, text: str, tone: str = "") -> None:
        while len(self.rows) <= y:
            self.rows.append({})
        for character in text:
            width = max(1, cell_len(character))
            self.rows[y].update({x + more: ("", tone) for more in range(1, width)})
            self.rows[y][x] = (character, tone)
            x += width

    def lines(self) -> Lines:
        return tuple(self._line(row) for row in self.rows)

    @staticmethod
    def _line(row: dict[int, tuple[str, str]]) -> Line:
        pieces: list[Piece] = []
        text, tone = "", ""
        for at in range(max(row, default=-1) + 1):
            character, here = row.get(at, (" ", tone))
            if here != tone:
                pieces.append(Piece(text, tone))
                text, tone = "", here
            text += character
        pieces.append(Piece(text, tone))
        return tuple(piece for piece in pieces if piece.text)


class Detail(NamedTuple):
    """How large a picture is drawn.

    Attributes:
        title: what the size is called.
        has_caption: whether a box says more than its name.
        has_frame: whether a box has lines around it; else it is one row, in brackets.
        widest: the most cells of a name.
        track: how far lines that turn between the same columns are apart.
        between: the rows between two boxes.
    """

    title: str
    has_caption: bool
    has_frame: bool
    widest: int
    track: int
    between: int


DETAILS = (
    Detail("full", True, True, 26, 2, 1),
    Detail("names", False, True, 26, 1, 0),
    Detail("cut", False, True, 12, 1, 0),
    Detail("lines", False, False, 26, 1, 0),
    Detail("short", False, False, 11, 1, 0),
)
"""From the largest to the smallest."""


@dataclass(frozen=True, slots=True)
class Label:
    """What a box says: a node, a topic, a service or an action.

    Attributes:
        name: its name.
        caption: more about it.
        tone: the tone of its frame.
        is_hub: whether it is a topic, a service or an action.
        warning: what is wrong with it.
    """

    name: str
    caption: str
    tone: str
    is_hub: bool
    warning: str = ""


class _Box:
    """A label at a size."""

    def __init__(self, label: Label, detail: Detail) -> None:
        self._label = label
        self._detail = detail
        self.name = cut(visible(label.name), detail.widest)
        self.rows = [self.name]
        if detail.has_caption:
            texts = (label.caption, label.warning)
            more = (cut(visible(text), detail.widest) for text in texts)
            self.rows += [row for row in more if row]
        elif label.warning:
            self.rows = [f"{self.name} !"]

    @property
    def measure(self) -> Measure:
        """How large the box has to be."""
        from plastron_tui.output.graphs.sheet import Measure

        frame = 1 if self._detail.has_frame else 0
        return Measure(max(map(cell_len, self.rows)) + 2 + 2 * frame, len(self.rows), frame)

    def draw(self, sheet: _Sheet, place: Place) -> None:
        """Draw it; a place that is higher than the text, for many lines, has it in its middle."""
        x, y, width, height = place
        tone = self._label.tone
        inner = width - 2
        if not self._detail.has_frame and height == 1:
            brackets = "()" if self._label.is_hub else "[]"
            sheet.put(x, y, brackets[0] + " " * inner + brackets[1], tone)
            self._draw_text(sheet, x + 1, y, 0)
            return
        corners = "╭╮╰╯" if self._label.is_hub else "┌┐└┘"
        sheet.put(x, y, corners[0] + "─" * inner + corners[1], tone)
        for row in range(y + 1, y + height - 1):
            sheet.put(x, row, "│" + " " * inner + "│", tone)
        sheet.put(x, y + height - 1, corners[2] + "─" * inner + corners[3], tone)
        if not self._detail.has_frame:
            # Several lines come to it: the name is in its frame, where there is no row between.
            self._draw_text(sheet, x + 1, y + (height - 1) // 2, 0)
            return
        first = y + 1 + (height - 2 - len(self.rows)) // 2
        for number in range(len(self.rows)):
            self._draw_text(sheet, x + 2, first + number, number)

    def _draw_text(self, sheet: _Sheet, x: int, y: int, number: int) -> None:
        text = self.rows[number]
        if number > 0:
            is_warning = bool(self._label.warning) and number == len(self.rows) - 1
            sheet.put(x, y, text, "warning" if is_warning else "quiet")
            return
        sheet.put(x, y, self.name, "strong")
        sheet.put(x + cell_len(self.name), y, text[len(self.name) :], "warning")


class Plan:
    """A part in a size: how high it is at least is known at once, the rest is laid out if asked."""

    def __init__(
        self,
        labels: Sequence[Label],
        columns: Columns,
        order: Sequence[Sequence[int]],
        detail: Detail,
        room: int,
        *,
        few_lines: bool = False,
    ) -> None:
        """Measure the boxes.

        Args:
            labels: all boxes; those of the part are used.
            columns: the boxes and turning points by column, and what is linked.
            order: the columns, each from top to bottom.
            detail: how large.
            room: how wide it may be; what is longer is broken into rows if it can be.
            few_lines: whether only few lines may lead from row to row.
        """
        from plastron_tui.output.graphs.sheet import FEW_CARRIED, MOST_CARRIED, Sheet

        own = [item for column in order for item in column if item >= 0]
        self._boxes = {item: _Box(labels[item], detail) for item in own}
        measures = {item: box.measure for item, box in self._boxes.items()}
        self._sheet = Sheet(columns, order, measures, detail.track, detail.between)
        self._room = room
        self._most_carried = FEW_CARRIED if few_lines else MOST_CARRIED

    @cached_property
    def least(self) -> tuple[int, int]:
        """A width that is more than the room if it cannot fit, and its least height if it does."""
        from plastron_tui.output.graphs.sheet import estimate

        _, width, height = estimate(self._sheet, self._room, self._most_carried)
        return width, height

    @cached_property
    def grid(self) -> Grid:
        """Where everything is."""
        from plastron_tui.output.graphs.grid import grid_of

        return grid_of(self._sheet, self._room, self._most_carried)

    def drawn(self) -> Lines:
        """Draw it."""
        sheet = _Sheet()
        for item, box in self._boxes.items():
            box.draw(sheet, self.grid.places[item])
        for (x, y), character in line_characters(self.grid.wires).items():
            sheet.put(x, y, character, "accent" if character in HEADS else "dim")
        return sheet.lines()
