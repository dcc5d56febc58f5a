"""Boxes and what joins them as lines of characters, in the size that fits."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING, NamedTuple, TypeVar

from rich.cells import cell_len

from .drawing import DETAILS, Label, Plan
from .styles import Line, Lines, Piece

if TYPE_CHECKING:
    from plastron_tui.output.graphs.layers import Columns, Link
    from plastron_tui.output.graphs.wiring import Place

_MOST_CELLS = 400_000
"""A picture of more cells takes seconds to draw, and shows nothing but lines."""

_MOST_SIZES = 8
"""A dock that is dragged has every width once; what is drawn for one is a whole picture."""
_MOST_PLANS = 48
"""So many plans are kept: a width takes one for each detail in each of four ways."""

_SCROLLED = 2
"""So many windows high is what is gone through as it is; what is higher is drawn smaller."""

_APART = 3
"""Columns between parts that stand beside each other."""

Parts = tuple[tuple["Columns", list[list[int]]], ...]
"""What hangs together: boxes in columns, and the order within the columns."""


_Key = TypeVar("_Key")
_Value = TypeVar("_Value")


class Size(NamedTuple):
    """Where a picture is shown: columns, rows, and the detail that is asked for, if one is."""

    width: int
    height: int
    detail: int | None = None


@dataclass(frozen=True, slots=True)
class Fitted:
    """A picture in one size: its lines, how wide it is, and where each box is."""

    lines: Lines
    width: int
    places: Mapping[int, Place]
    detail: int


class _Way(NamedTuple):
    """How a picture is made to fit: few lines from row to row, and boxes that stand for several."""

    few_lines: bool = False
    is_folded: bool = False


class Drawing:
    """Boxes and what joins them, laid out once, and drawn once in each size that is asked for."""

    def __init__(self, labels: Sequence[Label], links: Sequence[Link]) -> None:
        """Lay the boxes out, from left to right."""
        # A start of the studio does without.
        from plastron_tui.output.graphs.folding import folded_links, folds_of

        self._labels = list(labels)
        self._count = count = len(labels)
        hubs = frozenset(number for number, label in enumerate(labels) if label.is_hub)
        self._parts = _parts(range(count), links, hubs)
        folds = folds_of(links, hubs)
        self._folds = {at: fold.members for at, fold in enumerate(folds, count)}
        self._labels += [
            Label(f"and {len(fold.members)} more", "", "primary", is_hub=False) for fold in folds
        ]
        hidden = {member for fold in folds for member in fold.members}
        shown = [box for box in range(len(self._labels)) if box not in hidden]
        self._folded = _parts(shown, folded_links(links, folds, count), hubs) if folds else ()
        self._fitted: dict[Size, Fitted] = {}
        self._plans: dict[tuple[int, int, _Way], list[Plan]] = {}

    def fitted(self, size: Size) -> Fitted:
        """Draw it as large as fits, or in the detail that is asked for.

        A smaller picture is better than one with many lines from row to row, and such a one better
        than one where a box stands for many nodes at a topic that are nowhere else. What fits in no
        way fits from side to side, if that can be, and is low enough to scroll through.
        """
        found = self._fitted.get(size)
        if found is None:
            found = self._draw(size)
            _keep(self._fitted, size, found, _MOST_SIZES)
        return found

    def is_fitted(self, size: Size) -> bool:
        """Tell whether it is drawn in a size."""
        return size in self._fitted

    def _draw(self, size: Size) -> Fitted:
        if size.detail is not None:
            return self._packed(size.detail, size.width, _Way())
        ways = [_Way(few_lines=True), _Way()]
        if self._folds:
            ways += [way._replace(is_folded=True) for way in ways]
        for way in ways:
            detail = self._fitting(size, way)
            if detail is not None:
                return self._packed(detail, size.width, way)
        return self._packed(self._scrolled(size, ways[-1]), size.width, ways[-1])

    def _fitting(self, size: Size, way: _Way) -> int | None:
        """Return the largest detail that fits, None if none does."""
        for detail in range(len(DETAILS)):
            plans = self._planned(detail, size.width, way)
            least = [plan.least for plan in plans]
            if any(width >= size.width or height > size.height for width, height in least):
                continue
            shelves = _shelves(plans, size.width)
            is_narrow = max(map(_width, shelves)) <= size.width
            if is_narrow and _height(shelves, detail) <= size.height:
                return detail
        return None

    def _scrolled(self, size: Size, way: _Way) -> int:
        """Return the detail of what fits from side to side, the smallest if none does.

        It is the largest one of a few windows' height, or else the one with the fewest rows.
        """
        heights: dict[int, int] = {}
        for detail in range(len(DETAILS)):
            plans = self._planned(detail, size.width, way)
            if any(plan.least[0] >= size.width for plan in plans):
                continue
            shelves = _shelves(plans, size.width)
            if max(map(_width, shelves)) <= size.width:
                heights[detail] = _height(shelves, detail)
                if heights[detail] <= _SCROLLED * size.height:
                    return detail
        return min(heights, key=heights.__getitem__, default=len(DETAILS) - 1)

    def _packed(self, detail: int, width: int, way: _Way) -> Fitted:
        shelves = _shelves(self._planned(detail, width, way), width)
        if max(map(_width, shelves)) * _height(shelves, detail) > _MOST_CELLS:
            return noted(f"{self._count} boxes are too far apart; the panels list them")
        made = _packed(shelves, detail)
        places = dict(made.places)
        for box, members in self._folds.items() if way.is_folded else ():
            place = places.pop(box)
            places.update(dict.fromkeys(members, place))
        return Fitted(made.lines, made.width, places, detail)

    def _planned(self, detail: int, width: int, way: _Way) -> list[Plan]:
        plans = self._plans.get((detail, width, way))
        if plans is None:
            plans = [
                Plan(
                    self._labels,
                    columns,
                    order,
                    DETAILS[detail],
                    width - 1,
                    few_lines=way.few_lines,
                )
                for columns, order in (self._folded if way.is_folded else self._parts)
            ]
            _keep(self._plans, (detail, width, way), plans, _MOST_PLANS)
        return plans


def _keep(cache: dict[_Key, _Value], key: _Key, value: _Value, most: int) -> None:
    """Keep a value, and forget the oldest ones; the worker and the screen both draw."""
    cache[key] = value
    for old in list(cache)[:-most]:
        cache.pop(old, None)


@lru_cache(maxsize=4)
def drawing_of(labels: tuple[Label, ...], links: tuple[Link, ...]) -> Drawing:
    """Return the drawing of some boxes; of what was drawn lately, the same.

    Most of what is typed changes nothing in the graph, and what is laid out costs most.
    """
    return Drawing(labels, links)


def noted(note: str) -> Fitted:
    """Return words in the place of a picture."""
    return Fitted(((Piece(f" {note}", "quiet"),),), len(note) + 2, {}, 0)


def _shelves(plans: Sequence[Plan], width: int) -> list[list[Plan]]:
    """Put parts beside each other as far as there is room, in their order."""
    shelves: list[list[Plan]] = []
    for plan in plans:
        if shelves and _width(shelves[-1]) + _APART + plan.grid.width <= width:
            shelves[-1].append(plan)
        else:
            shelves.append([plan])
    return shelves


def _width(shelf: Sequence[Plan]) -> int:
    return 1 + sum(plan.grid.width for plan in shelf) + _APART * (len(shelf) - 1)


def _height(shelves: Sequence[Sequence[Plan]], detail: int) -> int:
    highest = sum(max(plan.grid.height for plan in shelf) for shelf in shelves)
    return highest + DETAILS[detail].between * (len(shelves) - 1)


def _packed(shelves: Sequence[Sequence[Plan]], detail: int) -> Fitted:
    """Draw parts beside and below each other."""
    lines: list[Line] = []
    places: dict[int, Place] = {}
    for shelf in shelves:
        if lines:
            lines += [()] * DETAILS[detail].between
        top, left = len(lines), 1
        rows = [[Piece(" ")] for _ in range(max(plan.grid.height for plan in shelf))]
        for plan in shelf:
            for box, place in plan.grid.places.items():
                places[box] = place._replace(x=place.x + left, y=place.y + top)
            drawn = plan.drawn()
            for at, row in enumerate(rows):
                line = drawn[at] if at < len(drawn) else ()
                row += line
                if plan is not shelf[-1]:
                    blank = plan.grid.width + _APART - sum(cell_len(piece.text) for piece in line)
                    row.append(Piece(" " * blank))
            left += plan.grid.width + _APART
        lines += map(_stripped, rows)
    return Fitted(tuple(lines), max(map(_width, shelves)), places, detail)


def _stripped(row: list[Piece]) -> Line:
    """Return a line without the blanks at its end."""
    while row and not row[-1].text.strip():
        row.pop()
    return tuple(row)


def _parts(shown: Sequence[int], links: Sequence[Link], hubs: frozenset[int]) -> Parts:
    """Lay out each group of boxes that hang together."""
    from plastron_tui.output.graphs.layers import columns_of, components
    from plastron_tui.output.graphs.ordering import ordered

    parts = []
    for part in components(shown, links):
        inside = set(part)
        columns = columns_of(part, [link for link in links if link.tail in inside], hubs)
        parts.append((columns, ordered(columns)))
    return tuple(parts)
