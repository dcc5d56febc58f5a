"""One line of the editor's screen, as a strip."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import NamedTuple

from rich.cells import cell_len
from rich.segment import Segment
from rich.style import Style
from textual.strip import Strip

from plastron_tui.diagnostics import Severity

from ..cells import cut, fitted
from .columns import Line
from .highlights import RowPaint
from .marks import Mark
from .palette import Palette, combined

SIGNS = {Severity.ERROR: "●", Severity.WARNING: "▲", Severity.NOTE: "·"}
_GAP = 3
_GOES_ON = "↪"
"""What stands in the place of the number where a long line goes on."""


class Layer(NamedTuple):
    """A style over a range of byte columns of a row; it may reach one beyond the row's end."""

    start: int
    end: int
    style: Style


class Row(NamedTuple):
    """All that decides how a row looks, positions in byte columns.

    Attributes:
        line: its text.
        number: counted from 1.
        here: whether the cursor's row is to be told apart.
        paint: the highlights.
        marks: the mistakes that start in the row, with their places.
        layers: what lies over the text: selection, matches, brackets, cursor.
    """

    line: Line
    number: int
    here: bool
    paint: RowPaint
    marks: Sequence[tuple[int, int, Mark]]
    layers: Sequence[Layer]


class Canvas(NamedTuple):
    """What a row is drawn on: colours, width of gutter and text in cells, first cell shown."""

    palette: Palette
    gutter: int
    width: int
    left: int


def has_room(line: Line, message: str, width: int) -> bool:
    """Tell whether a message fits beside a line."""
    return line.width + _GAP + 2 + cell_len(message) <= width


def gutter(
    row: Row, canvas: Canvas, *, is_first: bool = True, goes_on: bool = False
) -> list[Segment]:
    """Return the sign and the number of a row, or that a line `goes_on` that did not fit."""
    palette = canvas.palette
    if canvas.gutter == 0:
        return []
    worst = min((mark for _, _, mark in row.marks), key=_rank, default=None)
    base = palette.text
    number = str(row.number) if is_first else _GOES_ON if goes_on else ""
    if worst is None or not is_first:
        sign = Segment(" ", base)
    else:
        sign = Segment(SIGNS[worst.severity], combined(base, _style_of(worst, palette)))
    style = palette.gutter_here if row.here else palette.gutter
    return [sign, Segment(number.rjust(canvas.gutter - 2) + " ", combined(base, style))]


def _rank(mark: Mark) -> int:
    return 0 if mark.severity is Severity.ERROR else 1


def _style_of(mark: Mark, palette: Palette) -> Style:
    return palette.error if mark.severity is Severity.ERROR else palette.warning


def draw(row: Row, canvas: Canvas, start: int, end: int, *, message: Mark | None) -> Strip:
    """Draw the bytes of a row from `start` to `end`, with a message beside it if there is one."""
    palette, line = canvas.palette, row.line
    base = combined(palette.text, palette.line_here) if row.here else palette.text
    first_cell = line.cell(start)
    left = canvas.left + first_cell
    from_byte = max(start, line.column(left))
    to_byte = min(end, line.next_stop(line.column(left + canvas.width)))
    segments = _pieces(row, palette, base, from_byte, to_byte, is_end=end == line.size)
    strip = Strip(segments).crop(left - line.cell(from_byte))
    used = strip.cell_length
    if used > canvas.width:
        strip = strip.crop(0, canvas.width)
    elif message is not None and canvas.width - used > _GAP + 2:
        strip = Strip([*strip, *_beside(message, palette, base, canvas.width - used)])
    rest = canvas.width - strip.cell_length
    padding = [Segment(" " * rest, base)] if rest > 0 else []
    is_first = start == 0
    return Strip([*gutter(row, canvas, is_first=is_first, goes_on=True), *strip, *padding])


def below(row: Row, canvas: Canvas, message: Mark) -> Strip:
    """Draw the screen line below a row that holds its message."""
    palette = canvas.palette
    text = fitted(f"  └ {message.message}", canvas.width)
    style = combined(palette.text, _style_of(message, palette))
    return Strip(
        [
            *gutter(row, canvas, is_first=False),
            Segment(text, style),
        ]
    )


def _beside(message: Mark, palette: Palette, base: Style, room: int) -> list[Segment]:
    text = cut(f"{SIGNS[message.severity]} {message.message}", room - _GAP)
    return [Segment(" " * _GAP, base), Segment(text, combined(base, _style_of(message, palette)))]


def _pieces(
    row: Row, palette: Palette, base: Style, start: int, end: int, *, is_end: bool
) -> list[Segment]:
    """Cut a row where a style begins or ends, and lay the styles over each other."""
    layers = _layers(row, palette, start, end)
    cuts = {start, end}
    for begin, until, _ in layers:
        cuts.add(min(max(begin, start), end))
        cuts.add(min(max(until, start), end))
    places = sorted(cuts)
    segments = []
    for begin, until in pairwise(places):
        styles = [layer.style for layer in layers if layer.start <= begin and layer.end >= until]
        text = row.line.piece(begin, until)
        if text:
            segments.append(Segment(text, combined(base, *styles)))
    if is_end and end == row.line.size:
        beyond = [layer.style for layer in layers if layer.start <= end < layer.end]
        if beyond:
            segments.append(Segment(" ", combined(base, *beyond)))
    return segments


def _layers(row: Row, palette: Palette, start: int, end: int) -> list[Layer]:
    captures = palette.captures
    layers = [
        Layer(painted.start, painted.end, captures[painted.capture])
        for painted in row.paint
        if painted.end > start and painted.start < end and painted.capture in captures
    ]
    size = row.line.size
    layers += [Layer(at, at + 1, palette.tab) for at in row.line.tabs]
    for begin, until, mark in row.marks:
        style = palette.error_line if mark.severity is Severity.ERROR else palette.warning_line
        layers.append(Layer(begin, max(until, min(begin, size) + 1), style))
    layers.extend(row.layers)
    return layers
