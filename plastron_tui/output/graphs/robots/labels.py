"""Where names stand in a view, so that none is over another."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import cos, pi, sin
from typing import Generic, NamedTuple, TypeVar

from plastron_tui.output.graphs.widths import text_width

from .polygons import stretches
from .views import Frame, Point

SIZE = 10.5
"""How large names are."""

_ABOVE, _BELOW = SIZE * 0.82, SIZE * 0.26
"""How far a line of text reaches from its baseline."""

_RINGS = (11.0, 20.0, 32.0, 48.0, 68.0, 92.0, 120.0)
"""How far a name may be from what it names."""

_DIRECTIONS = 16
_NEAR = 15.0
"""A name that is farther away than this has a line to what it names."""

_APART = 2.0
_CELL = 5.0
"""How finely it is known where bodies are."""

_BUCKET = 48.0
_FINE = 2.0
"""So many parts of a pixel are told apart where names may not stand."""

_OVER_A_BODY = 34.0
"""So much farther away a name may be for standing on nothing."""


class Label(NamedTuple):
    """A name, and where it stands.

    Attributes:
        text: the name.
        x: where its first letter begins.
        baseline: where its letters stand.
        leader: the line from it to what it names, None where it is near enough.
    """

    text: str
    x: float
    baseline: float
    leader: tuple[Point, Point] | None

    @property
    def frame(self) -> Frame:
        """What it takes up; y goes down here."""
        return _frame(self.x, self.baseline, text_width(self.text, SIZE))


T = TypeVar("T")


class _Buckets(Generic[T]):
    """Things by where they are: what is near is found without looking at all of them."""

    def __init__(self) -> None:
        self._buckets: dict[tuple[int, int], list[T]] = {}

    def add(self, frame: Frame, thing: T) -> None:
        for key in _keys(frame):
            self._buckets.setdefault(key, []).append(thing)

    def near(self, frame: Frame) -> Iterator[T]:
        """Yield what may meet a rectangle, some of it several times."""
        for key in _keys(frame):
            yield from self._buckets.get(key, ())


def _keys(frame: Frame) -> Iterator[tuple[int, int]]:
    for column in range(int(frame.left / _BUCKET), int(frame.right / _BUCKET) + 1):
        for row in range(int(frame.low / _BUCKET), int(frame.high / _BUCKET) + 1):
            yield column, row


class Sheet:
    """A view that names are put on, in pixels from its upper left corner."""

    def __init__(self, width: float, height: float) -> None:
        """Begin with an empty one."""
        self._whole = Frame(0.0, 0.0, width, height)
        self._taken = _Buckets[Frame]()
        self._kept: set[tuple[int, ...]] = set()
        self._leaders = _Buckets["tuple[Point, Point]"]()
        self._covered: set[tuple[int, int]] = set()
        self._rows = int(height / _CELL) + 1

    def cover(self, points: Sequence[Point]) -> None:
        """Say where a body is: names stand beside bodies where they can."""
        scaled = [(x / _CELL, y / _CELL) for x, y in points]
        most = int(self._whole.right / _CELL)
        for row, left, right in stretches(scaled, self._rows):
            self._covered.update(
                (column, row) for column in range(max(0, int(left)), min(most, int(right)) + 1)
            )

    def keep(self, frame: Frame) -> None:
        """Say where no name may stand."""
        # Of thousands of joints at one place each would be looked at for each name.
        about = tuple(round(_FINE * each) for each in frame)
        if about not in self._kept:
            self._kept.add(about)
            self._taken.add(frame, frame)

    def mark(self, point: Point, radius: float) -> None:
        """Say where something is that is named: no other name may stand there."""
        self.keep(Frame(point.x - radius, point.y - radius, point.x + radius, point.y + radius))

    def put(self, text: str, point: Point) -> Label | None:
        """Put a name near a point; None where there is no room for it."""
        best: tuple[float, Label] | None = None
        for distance, label in _places(text, point):
            if best is not None and distance >= best[0]:
                # Those that follow are farther away.
                break
            if not self._is_free(label, point):
                continue
            cost = distance + (_OVER_A_BODY if self._is_covered(label.frame) else 0.0)
            if best is None or cost < best[0]:
                best = cost, label
        if best is None:
            return None
        label = best[1]
        self.keep(label.frame)
        if label.leader is not None:
            self._leaders.add(_around(label.leader), label.leader)
        return label

    def _is_free(self, label: Label, point: Point) -> bool:
        frame = label.frame
        if not _holds(self._whole, frame):
            return False
        if any(_meet(frame, other) for other in self._taken.near(frame)):
            return False
        if any(_crosses(line, frame) for line in self._leaders.near(frame)):
            return False
        leader = label.leader
        if leader is None:
            return True
        around = _around(leader)
        return not (
            any(
                _crosses(leader, other)
                for other in self._taken.near(around)
                if not _has(other, point)
            )
            or any(_cross(leader, other) for other in self._leaders.near(around))
        )

    def _is_covered(self, frame: Frame) -> bool:
        columns = range(int(frame.left / _CELL), int(frame.right / _CELL) + 1)
        rows = range(int(frame.low / _CELL), int(frame.high / _CELL) + 1)
        return any((column, row) in self._covered for row in rows for column in columns)


def _places(text: str, point: Point) -> Iterator[tuple[float, Label]]:
    """Yield places for a name, the nearest first."""
    wide = text_width(text, SIZE)
    middle = (_ABOVE - _BELOW) / 2
    for ring in _RINGS:
        for number in range(_DIRECTIONS):
            # To the right first, then right above, right below, and so on around.
            turn = (number + 1) // 2 * (-1 if number % 2 else 1)
            angle = 2 * pi * turn / _DIRECTIONS
            across, down = cos(angle), sin(angle)
            end = Point(point.x + ring * across, point.y + ring * down)
            x = end.x - wide * (1 - across) / 2
            baseline = end.y + middle + down * SIZE / 2
            leader = (end, point) if ring > _NEAR else None
            yield ring + abs(turn) * 0.1, Label(text, x, baseline, leader)


def _frame(x: float, baseline: float, width: float) -> Frame:
    return Frame(
        x - _APART,
        baseline - _ABOVE - _APART / 2,
        x + width + _APART,
        baseline + _BELOW + _APART / 2,
    )


def _meet(one: Frame, other: Frame) -> bool:
    return (
        one.left < other.right
        and other.left < one.right
        and one.low < other.high
        and other.low < one.high
    )


def _around(line: tuple[Point, Point]) -> Frame:
    (x, y), (xx, yy) = line
    return Frame(min(x, xx), min(y, yy), max(x, xx), max(y, yy))


def _holds(outer: Frame, inner: Frame) -> bool:
    return (
        outer.left <= inner.left
        and inner.right <= outer.right
        and outer.low <= inner.low
        and inner.high <= outer.high
    )


def _has(frame: Frame, point: Point) -> bool:
    return frame.left <= point.x <= frame.right and frame.low <= point.y <= frame.high


def _crosses(line: tuple[Point, Point], frame: Frame) -> bool:
    """Tell whether a line goes through a rectangle."""
    start, end = line
    if _has(frame, start) or _has(frame, end):
        return True
    corners = (
        Point(frame.left, frame.low), Point(frame.right, frame.low),
        Point(frame.right, frame.high), Point(frame.left, frame.high),
    )  # fmt: skip
    return any(_cross(line, (corners[at - 1], corner)) for at, corner in enumerate(corners))


def _cross(one: tuple[Point, Point], other: tuple[Point, Point]) -> bool:
    """Tell whether two lines cross; that they end at the same point does not count."""
    (a, b), (c, d) = one, other
    return _side(a, b, c) * _side(a, b, d) < 0 and _side(c, d, a) * _side(c, d, b) < 0


def _side(start: Point, end: Point, at: Point) -> float:
    return (end.x - start.x) * (at.y - start.y) - (end.y - start.y) * (at.x - start.x)
