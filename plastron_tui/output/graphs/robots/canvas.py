"""What a picture in characters is drawn on: two pixels a character, and characters over them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from math import ceil, floor, sqrt

from .polygons import Stretch, middles, stretches
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
        self._written: list[dict[int, Run]] = [{} for _ in range(rows)]

    def is_free(self, column: int, row: int, length: int, *, over_pixels: bool) -> bool:
        """Tell whether there is room for a text."""
        if not 0 <= row < self.rows:
            return False
        cells = range(max(column, 0), min(column + length, self.columns))
        written = self._written[row]
        if written and not written.keys().isdisjoint(cells):
            return False
        return over_pixels or not any(any(self._pair(at, row)) for at in cells)

    def write(self, column: int, row: int, text: str, role: str) -> None:
        """Write a text of narrow characters over what is drawn; what is outside is left out."""
        for at, char in enumerate(text, column):
            if 0 <= at < self.columns and 0 <= row < self.rows:
                behind = self._pair(at, row)[1]
                color = contrast(behind) if behind else ""
                self._written[row][at] = Run(char, role, color, behind)

    def fill(self, points: Sequence[tuple[float, float]], color: str) -> None:
        """Fill a convex polygon: pixels whose middles are in it, at least one in each row."""
        if self.ascii_only:
            points = [(x, y / 2) for x, y in points]
        self._fill_rows(stretches(points, len(self._pixels)), color)

    def line(self, start: Point, end: Point, color: str) -> None:
        """Draw a line, a pixel wide."""
        flat = 2 if self.ascii_only else 1
        across, down = end.x - start.x, (end.y - start.y) / flat
        count = min(ceil(max(abs(across), abs(down))), self.columns + len(self._pixels))
        for step in range(count + 1):
            part = step / count if count else 0.0
            column = floor(start.x + across * part)
            row = floor(start.y / flat + down * part)
            if 0 <= column < self.columns and 0 <= row < len(self._pixels):
                self._pixels[row][column] = color

    def fill_circle(self, middle: Point, radius: float, color: str) -> None:
        """Fill a circle."""
        flat = 2 if self.ascii_only else 1
        found = []
        for row, at in middles(
            (middle.y - radius) / flat, (middle.y + radius) / flat, len(self._pixels)
        ):
            half = sqrt(max(0.0, radius**2 - (at * flat - middle.y) ** 2))
            found.append((row, middle.x - half, middle.x + half))
        self._fill_rows(found, color)

    def _fill_rows(self, found: Iterable[Stretch], color: str) -> None:
        """Fill what is in each row; as there are many, without `min` and `max`."""
        pixels, columns = self._pixels, self.columns
        for row, left, right in found:
            start, end = ceil(left - 0.5), floor(right + 0.5)
            if start >= end:
                # It is thinner than a pixel.
                start = floor((left + right) / 2)
                end = start + 1
            if start < 0:
                start = 0
            if end > columns:
                end = columns
            if end > start:
                pixels[row][start:end] = [color] * (end - start)

    def lines(self) -> RunLines:
        """Return what is drawn."""
        return tuple(tuple(self._line(row)) for row in range(self.rows))

    def _line(self, row: int) -> Iterator[Run]:
        if self.ascii_only:
            uppers = lowers = self._pixels[row]
        else:
            uppers, lowers = self._pixels[2 * row : 2 * row + 2]
        written = self._written[row]
        start = 0
        while start < self.columns:
            run = written.get(start)
            end = start + 1
            if run is not None:
                text = run.text
                while (more := written.get(end)) is not None and more[1:] == run[1:]:
                    text += more.text
                    end += 1
                yield run._replace(text=text)
            else:
                upper, lower = uppers[start], lowers[start]
                while (
                    end < self.columns
                    and uppers[end] == upper
                    and lowers[end] == lower
                    and end not in written
                ):
                    end += 1
                yield self._blocks(upper, lower, end - start)
            start = end

    def _blocks(self, upper: str, lower: str, count: int) -> Run:
        if self.ascii_only:
            return Run((upper or " ") * count)
        if upper == lower:
            return Run(" " * count, behind=upper)
        if not upper:
            return Run(_LOWER * count, color=lower)
        return Run(_UPPER * count, color=upper, behind=lower)

    def _pair(self, column: int, row: int) -> tuple[str, str]:
        if self.ascii_only:
            return self._pixels[row][column], ""
        return self._pixels[2 * row][column], self._pixels[2 * row + 1][column]
