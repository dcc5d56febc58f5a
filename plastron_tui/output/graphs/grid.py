"""Where everything goes in a picture of characters: boxes in columns, lines in lanes.

The columns stand in one row, or in several where the picture would be too wide; then lines lead
from the end of a row to the next one as a paragraph is read. Lengths are in cells, y grows
downward. Two nets share no run: where their lines meet, they cross.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from .breaks import Strip, breaks_of, rows_between
from .coordinates import Spacing, placed
from .lanes import Turn, lanes_of
from .layers import Net
from .ordering import neighbours_of
from .port_rows import PortRows
from .sheet import BEFORE, BEHIND, MOST_CARRIED, Sheet, estimate, strip_of
from .wiring import Frame, Gap, Place, Wire, wires_of

_TRIES = 4


@dataclass(frozen=True, slots=True)
class Grid:
    """A picture's size, the places of its boxes, and its lines."""

    width: int
    height: int
    places: Mapping[int, Place]
    wires: tuple[Wire, ...]


def grid_of(sheet: Sheet, room: int, most_carried: int = MOST_CARRIED) -> Grid:
    """Lay a picture out, in several rows where one would be wider than there is room.

    A picture that cannot be broken so that at most some lines lead from row to row stays in one.
    """
    cuts = estimate(sheet, room, most_carried).cuts
    excess = 0
    for _ in range(_TRIES):
        made = _Layout(sheet, cuts)
        if made.width <= room:
            return made.grid()
        # Lanes are counted before rows are known, and may become more.
        excess += made.width - room if cuts else 0
        cuts = breaks_of(made.strip(), room - excess, most_carried) or ()
        if not cuts:
            break
    return _Layout(sheet, ()).grid()


class _Layout:
    """The columns in rows, whose last columns are `cuts` and the last one."""

    def __init__(self, sheet: Sheet, cuts: Sequence[int]) -> None:
        self._sheet = sheet
        self._cuts = frozenset(cuts)
        self._rows = rows_between(cuts, len(sheet.order))
        self._nets, self._heights = sheet.nets, sheet.heights
        self._top: dict[int, int] = {}
        self._place_items()
        self._gaps = [self._gap(column) for column in range(len(sheet.order) - 1)]
        self._place_columns()

    def strip(self) -> Strip:
        """Return how wide everything is."""
        gaps = [self._gap_width(column) for column in range(len(self._gaps))]
        return strip_of(self._sheet, gaps)

    def _place_items(self) -> None:
        """Set the first row of each item: near to its neighbours, within the row's height."""
        sheet = self._sheet
        neighbours = neighbours_of(sheet.columns, self._cuts)
        spacing = Spacing(sheet.between, 0)
        heights = {item: float(height) for item, height in self._heights.items()}
        middles = placed(neighbours, sheet.order, heights, {}, spacing)
        self._ports = PortRows(sheet, middles)
        middles = placed(neighbours, sheet.order, heights, self._ports.by_neighbour(), spacing)
        self._ports = PortRows(sheet, middles)
        for row in self._rows:
            top = min(middles[at] - heights[at] / 2 for column in row for at in sheet.order[column])
            highest = max(sheet.column_heights[column] for column in row)
            for column in row:
                wanted = {at: middles[at] - heights[at] / 2 - top for at in sheet.order[column]}
                if column - 1 in row:
                    self._straighten(column - 1, wanted)
                self._fit(sheet.order[column], wanted, highest)
                if column - 1 in row:
                    self._part(column - 1)
        self._stack()

    def _straighten(self, column: int, wanted: dict[int, float]) -> None:
        """Want items behind a column where a line from there runs straight, if that is near."""
        for net, (lefts, rights) in self._nets[column].items():
            for left in lefts:
                row = self._row_of(net, left, is_left=False)
                for right in rights:
                    straight = row - self._ports.row(net, right, is_left=True)
                    if abs(straight - wanted[right]) <= 1:
                        wanted[right] = straight

    def _fit(self, items: Sequence[int], wanted: Mapping[int, float], height: int) -> None:
        """Place a column's items near to the wanted rows, within a height that is enough."""
        least = 0
        for at, item in enumerate(items):
            self._top[item] = max(round(wanted[item]), least)
            following = items[at + 1] if at + 1 < len(items) else item
            least = self._top[item] + self._heights[item] + self._sheet.apart(item, following)
        most = height
        for at in range(len(items) - 1, -1, -1):
            item = items[at]
            self._top[item] = min(self._top[item], most - self._heights[item])
            above = items[at - 1] if at else item
            most = self._top[item] - self._sheet.apart(above, item)

    def _part(self, column: int) -> None:
        """Move items behind a column down until lanes can be found: rows apart solve any circle."""
        while circle := lanes_of(self._turns(column)).circle:
            joined = list(self._nets[column].values())
            ends = [item for number in circle for item in joined[number][1]]
            items = self._sheet.order[column + 1]
            for item in items[min(map(items.index, ends)) :]:
                self._top[item] += 1

    def _stack(self) -> None:
        """Put the rows below each other, with a row of cells for each line from one to the next."""
        top = 0
        self._channels: dict[int, int] = {}
        for row in self._rows:
            items = [item for column in row for item in self._sheet.order[column]]
            highest = min(self._top[item] for item in items)
            for item in items:
                self._top[item] += top - highest
            top = max(self._top[item] + self._heights[item] for item in items)
            last = row[-1]
            if last in self._cuts:
                self._channels[last] = top
                top += len(self._nets[last])
        self.height = top

    def _row_of(self, net: Net, item: int, *, is_left: bool) -> int:
        """Return the row at which a net reaches an item, at its left or its right."""
        return self._top[item] + self._ports.row(net, item, is_left=is_left)

    def _turns(self, column: int) -> list[Turn]:
        """Return the rows at which the nets behind a column are joined."""
        return [
            Turn(
                tuple([self._row_of(net, item, is_left=False) for item in lefts]),
                tuple([self._row_of(net, item, is_left=True) for item in rights]),
            )
            for net, (lefts, rights) in self._nets[column].items()
        ]

    def _gap(self, column: int) -> Gap:
        """Return the nets between two columns."""
        nets, turns = self._nets[column], self._turns(column)
        lanes = (0,) * len(turns) if column in self._cuts else lanes_of(turns).numbers
        return Gap(tuple(nets), tuple(turns), tuple(nets.values()), lanes)

    def _gap_width(self, column: int) -> int:
        lanes = max(self._gaps[column].lanes, default=0) + 1
        return BEHIND + lanes * self._sheet.track + BEFORE

    def _place_columns(self) -> None:
        """Set where each column begins."""
        track = self._sheet.track
        carried = max((len(self._nets[cut]) for cut in self._cuts), default=0)
        self._indent = carried * track + BEFORE if carried else 0
        self._starts: dict[int, int] = {}
        self.width = 0
        for row in self._rows:
            x = self._indent
            for column in row:
                self._starts[column] = x
                x += self._sheet.widths[column]
                if column != row[-1]:
                    x += self._gap_width(column)
            if row[-1] in self._cuts:
                x += BEHIND + len(self._nets[row[-1]]) * track
            self.width = max(self.width, x)

    def grid(self) -> Grid:
        """Return the picture."""
        sheet = self._sheet
        places = {}
        for column, items in enumerate(sheet.order):
            for item in items:
                if item >= 0:
                    width = sheet.measures[item].width
                    x = self._starts[column] + (sheet.widths[column] - width) // 2
                    places[item] = Place(x, self._top[item], width, sheet.heights[item])
        frame = Frame(
            sheet, places, self._top, self._starts, self._indent, tuple(self._gaps), self._channels
        )
        return Grid(self.width, self.height, places, tuple(wires_of(frame)))
