"""What hangs together in a graph as boxes and arrows of characters, at several sizes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

from rich.cells import cell_len, set_cell_size

from .styles import Line, Lines, Piece

if TYPE_CHECKING:
    from plastron_tui.output.graphs.layers import Columns

_UP, _DOWN, _LEFT, _RIGHT = 1, 2, 4, 8
_LINES = {
    _LEFT | _RIGHT: "─", _UP | _DOWN: "│", _LEFT | _DOWN: "╮", _LEFT | _UP: "╯",
    _RIGHT | _DOWN: "╭", _RIGHT | _UP: "╰", _LEFT | _RIGHT | _DOWN: "┬",
    _LEFT | _RIGHT | _UP: "┴", _UP | _DOWN | _RIGHT: "├", _UP | _DOWN | _LEFT: "┤",
    _UP | _DOWN | _LEFT | _RIGHT: "┼", _LEFT: "─", _RIGHT: "─", _UP: "│", _DOWN: "│",
}  # fmt: skip


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


class Place(NamedTuple):
    """Where a box is, in cells."""

    x: int
    y: int
    width: int
    height: int


class _Box:
    """A label at a size."""

    def __init__(self, label: Label, detail: Detail) -> None:
        self._label = label
        self._detail = detail
        self.name = _cut(label.name, detail.widest)
        self.rows = [self.name]
        if detail.has_caption:
            more = (_cut(label.caption, detail.widest), _cut(label.warning, detail.widest))
            self.rows += [row for row in more if row]
        elif label.warning:
            self.rows = [f"{self.name} !"]
        frame = 4 if detail.has_frame else 2
        self.width = max(map(cell_len, self.rows)) + frame
        self.height = len(self.rows) + (2 if detail.has_frame else 0)
        self.port = 1 if detail.has_frame else 0
        """The row at which lines reach it."""

    def draw(self, sheet: _Sheet, x: int, y: int) -> None:
        tone, is_hub = self._label.tone, self._label.is_hub
        if not self._detail.has_frame:
            self._draw_row(sheet, x, y, "()" if is_hub else "[]")
            return
        corners = "╭╮╰╯" if is_hub else "┌┐└┘"
        inner = self.width - 2
        sheet.put(x, y, corners[0] + "─" * inner + corners[1], tone)
        for number in range(len(self.rows)):
            sheet.put(x, y + 1 + number, "│" + " " * inner + "│", tone)
            self._draw_text(sheet, x + 2, y + 1 + number, number)
        sheet.put(x, y + self.height - 1, corners[2] + "─" * inner + corners[3], tone)

    def _draw_row(self, sheet: _Sheet, x: int, y: int, brackets: str) -> None:
        sheet.put(x, y, brackets[0], self._label.tone)
        sheet.put(x + self.width - 1, y, brackets[1], self._label.tone)
        self._draw_text(sheet, x + 1, y, 0)

    def _draw_text(self, sheet: _Sheet, x: int, y: int, number: int) -> None:
        text = self.rows[number]
        if number > 0:
            is_warning = bool(self._label.warning) and number == len(self.rows) - 1
            sheet.put(x, y, text, "warning" if is_warning else "quiet")
            return
        sheet.put(x, y, self.name, "strong")
        sheet.put(x + cell_len(self.name), y, text[len(self.name) :], "warning")


def _cut(text: str, widest: int) -> str:
    text = text if text.isprintable() else ascii(text)[1:-1]
    if cell_len(text) <= widest:
        return text
    return f"{set_cell_size(text, widest - 1).rstrip()}…"


class Plan:
    """Where everything of a part goes in a size; it is cheap to make, and to draw is not."""

    def __init__(
        self,
        labels: Sequence[Label],
        columns: Columns,
        order: Sequence[Sequence[int]],
        detail: Detail,
    ) -> None:
        """Place the boxes from left to right.

        Args:
            labels: all boxes; those of the part are used.
            columns: the boxes and turning points by column, and what is linked.
            order: the columns, each from top to bottom.
            detail: how large.
        """
        self._columns = columns
        self._detail = detail
        own = [item for column in order for item in column if item >= 0]
        self._boxes = boxes = {item: _Box(labels[item], detail) for item in own}
        rows = _rows(order, boxes, detail)
        self._rows = {
            item: row + (boxes[item].port if item in boxes else 0) for item, row in rows.items()
        }
        self._widths = [
            max((boxes[item].width for item in column if item >= 0), default=1) for column in order
        ]
        self._starts: list[int] = []
        self.places: dict[int, Place] = {}
        x = 0
        gaps = _gaps(order, columns, detail)
        for column, width, gap in zip(order, self._widths, [*gaps, 0], strict=True):
            self._starts.append(x)
            for item in column:
                if item >= 0:
                    box = boxes[item]
                    at = x + (width - box.width) // 2
                    self.places[item] = Place(at, rows[item], box.width, box.height)
            x += width + gap
        self.width = x
        self.height = max(
            row + (boxes[item].height if item in boxes else 1) for item, row in rows.items()
        )

    def drawn(self) -> Lines:
        """Draw it."""
        sheet = _Sheet()
        for item, box in self._boxes.items():
            box.draw(sheet, self.places[item].x, self.places[item].y)
        _draw_links(
            sheet, self.places, self._columns, self._rows, self._starts, self._widths, self._detail
        )
        return sheet.lines()


def _rows(
    order: Sequence[Sequence[int]], boxes: Mapping[int, _Box], detail: Detail
) -> dict[int, int]:
    """Return the first row of each item: columns are centred beside the highest one."""

    def height(item: int) -> int:
        return boxes[item].height if item >= 0 else 1

    gap = detail.between
    heights = [sum(height(item) + gap for item in column) - gap for column in order]
    highest = max(heights)
    row_of = {}
    for column, total in zip(order, heights, strict=True):
        row = (highest - total) // 2
        for item in column:
            row_of[item] = row
            row += height(item) + gap
    return row_of


def _gaps(order: Sequence[Sequence[int]], columns: Columns, detail: Detail) -> list[int]:
    """Return how far columns are apart: room for each line to turn in a track of its own."""
    gaps = []
    for number in range(len(order) - 1):
        left = set(order[number])
        tails = {one for one, _ in columns.segments if one in left}
        gaps.append(max(3 + detail.track, detail.track * len(tails) + 3))
    return gaps


def _draw_links(
    sheet: _Sheet,
    places: Mapping[int, Place],
    columns: Columns,
    rows: Mapping[int, int],
    starts: Sequence[int],
    widths: Sequence[int],
    detail: Detail,
) -> None:
    strokes: dict[tuple[int, int], int] = {}
    arrows: dict[tuple[int, int], str] = {}
    heads = {(route[-2], route[-1]) for link, route in columns.routes.items()
             if link not in columns.reversed}  # fmt: skip
    tails = {(route[0], route[1]) for link, route in columns.routes.items()
             if link in columns.reversed}  # fmt: skip
    tracks: dict[int, int] = {}
    used: dict[int, int] = {}
    for left, right in sorted(columns.segments, key=lambda pair: rows[pair[0]]):
        column = columns.column_of[left]
        if left not in tracks:
            tracks[left] = used.get(column, 0)
            used[column] = tracks[left] + 1
        turn = starts[column] + widths[column] + 1 + detail.track * tracks[left]
        place = places.get(left)
        begin = starts[column] if place is None else place.x + place.width
        end = places[right].x if right in places else starts[column + 1]
        _stroke(strokes, begin, turn, rows[left], rows[right], end)
        if (left, right) in heads and right >= 0:
            arrows[end - 1, rows[right]] = "▶"
        if (left, right) in tails and left >= 0:
            arrows[begin, rows[left]] = "◀"
    for (x, y), directions in strokes.items():
        sheet.put(x, y, arrows.get((x, y)) or _LINES[directions], "dim")
    for (x, y), arrow in arrows.items():
        sheet.put(x, y, arrow, "accent")


def _stroke(
    strokes: dict[tuple[int, int], int], begin: int, turn: int, row: int, other: int, end: int
) -> None:
    def add(x: int, y: int, directions: int) -> None:
        strokes[x, y] = strokes.get((x, y), 0) | directions

    for x in range(begin, turn):
        add(x, row, _LEFT | _RIGHT)
    add(turn, row, _LEFT)
    if row == other:
        add(turn, row, _RIGHT)
    else:
        down = other > row
        add(turn, row, _DOWN if down else _UP)
        low, high = sorted((row, other))
        for y in range(low + 1, high):
            add(turn, y, _UP | _DOWN)
        add(turn, other, (_UP if down else _DOWN) | _RIGHT)
    for x in range(turn + 1, end):
        add(x, other, _LEFT | _RIGHT)
