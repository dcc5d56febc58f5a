"""What a picture in characters is drawn on: two pixels a character, and characters over them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import ceil, floor, sqrt

from .runs import Run, RunLines
from .shades import contrast
from .views import Point

_UPPER, _LOWER = "▀", "▄"


class Canvas:
    """Pixels in colours, which are about as wide as high, and characters over them."""

    def __init__(self, columns: int, rows: int, *, ascii_only: bool = False) -> None:
        """Begin with nothing drawn.

        Args:
            columns: how wide it is, in characters.
            rows: how high, in characters.
            ascii_only: whether a pixel is a character, for terminals that have no blocks; what is
                drawn then are characters in the place of colours.
        """
        self.columns, self.rows = columns, rows
        self.ascii_only = ascii_only
        self._pixels = [[""] * columns for _ in range(rows if ascii_only else 2 * rows)]
        self._written: dict[tuple[int, int], Run] = {}

    def is_free(self, column: int, row: int, length: int, *, over_pixels: bool) -> bool:
        """Tell whether there is room for a text."""
        if not (0 <= row < self.rows and column >= 0 and column + length <= self.columns):
            return False
        cells = range(column, column + length)
        if any((at, row) in self._written for at in cells):
            return False
        return over_pixels or not any(any(self._pair(at, row)) for at in cells)

    def write(self, column: int, row: int, text: str, role: str) -> None:
        """Write a text of narrow characters over what is drawn; what is outside is left out."""
        for at, char in enumerate(text, column):
            if 0 <= at < self.columns and 0 <= row < self.rows:
                behind = self._pair(at, row)[1]
                color = contrast(behind) if behind else ""
                self._written[at, row] = Run(char, role, color, behind)

    def fill(self, points: Sequence[Point], color: str) -> None:
        """Fill a convex polygon: pixels whose middles are in it, at least one in each row."""
        if self.ascii_only:
            points = [Point(x, y / 2) for x, y in points]
        xs, ys = [point.x for point in points], [point.y for point in points]
        first, last = max(0, floor(min(ys))), min(len(self._pixels) - 1, ceil(max(ys)) - 1)
        if min(ys) == max(ys):
            last = first
        for row in range(first, last + 1):
            # A body that is thinner than a pixel is seen all the same.
            middle = min(max(row + 0.5, min(ys)), max(ys))
            self._fill_row(row, *_span(points, middle, min(xs), max(xs)), color)

    def fill_circle(self, middle: Point, radius: float, color: str) -> None:
        """Fill a circle."""
        flat = 2 if self.ascii_only else 1
        low, high = (middle.y - radius) / flat, (middle.y + radius) / flat
        for row in range(max(0, floor(low)), min(len(self._pixels), ceil(high) or 1)):
            at = min(max(row + 0.5, low), high) * flat
            half = sqrt(max(0.0, radius**2 - (at - middle.y) ** 2))
            self._fill_row(row, middle.x - half, middle.x + half, color)

    def _fill_row(self, row: int, left: float, right: float, color: str) -> None:
        start = max(0, round(left))
        end = min(self.columns, max(round(right), start + 1))
        if 0 <= row < len(self._pixels) and end > start:
            self._pixels[row][start:end] = [color] * (end - start)

    def lines(self) -> RunLines:
        """Return what is drawn."""
        return tuple(tuple(_joined(self._row(row))) for row in range(self.rows))

    def _row(self, row: int) -> Iterator[Run]:
        for column in range(self.columns):
            written = self._written.get((column, row))
            yield written or self._block(*self._pair(column, row))

    def _block(self, upper: str, lower: str) -> Run:
        if self.ascii_only:
            return Run(upper or " ")
        if not upper and not lower:
            return Run(" ")
        if upper == lower:
            return Run(" ", behind=upper)
        if not upper:
            return Run(_LOWER, color=lower)
        return Run(_UPPER, color=upper, behind=lower)

    def _pair(self, column: int, row: int) -> tuple[str, str]:
        if self.ascii_only:
            return self._pixels[row][column], ""
        return self._pixels[2 * row][column], self._pixels[2 * row + 1][column]


def _span(points: Sequence[Point], at: float, lowest: float, highest: float) -> tuple[float, float]:
    """Return from where to where a convex polygon goes at a height."""
    left, right = highest, lowest
    for number, end in enumerate(points):
        start = points[number - 1]
        if not min(start.y, end.y) <= at <= max(start.y, end.y):
            continue
        if start.y == end.y:
            found: tuple[float, ...] = (start.x, end.x)
        else:
            found = (start.x + (end.x - start.x) * (at - start.y) / (end.y - start.y),)
        left, right = min(left, *found), max(right, *found)
    return left, right


def _joined(runs: Iterator[Run]) -> Iterator[Run]:
    """Yield the characters with those that look alike as one."""
    last: Run | None = None
    for run in runs:
        if last is not None and last[1:] == run[1:]:
            last = last._replace(text=last.text + run.text)
            continue
        if last is not None:
            yield last
        last = run
    if last is not None:
        yield last
