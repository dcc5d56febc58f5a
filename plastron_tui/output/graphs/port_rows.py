"""Where lines reach the boxes of a picture of characters."""

from __future__ import annotations

from collections.abc import Mapping

from .boxes import Ports
from .layers import Net
from .sheet import Sheet


class PortRows:
    """The rows of boxes at which nets reach them, in the order of what they lead to.

    Beside a text of several lines they begin at the first, which has the name, so that boxes
    with and without a warning stand in one line; else they are in the middle.
    """

    def __init__(self, sheet: Sheet, middles: Mapping[int, float]) -> None:
        self._columns = sheet.columns
        self._heights = sheet.heights
        self._rows: dict[tuple[int, bool, Net], int] = {}
        ports = Ports(sheet.columns, middles, lambda _: 1.0)
        sides: dict[tuple[int, bool], dict[Net, float]] = {}
        for link, route in sheet.columns.routes.items():
            net = sheet.columns.nets[link]
            for item, is_left in ((route[0], False), (route[-1], True)):
                offset = ports.offset(net, item, is_left=is_left)
                sides.setdefault((item, is_left), {})[net] = offset
        for (item, is_left), offsets in sides.items():
            measure = sheet.measures[item]
            inner = sheet.heights[item] - 2 * measure.frame
            first = (inner - len(offsets)) // 2 if inner > measure.rows else 0
            for at, net in enumerate(sorted(offsets, key=offsets.__getitem__)):
                self._rows[item, is_left, net] = measure.frame + first + at

    def row(self, net: Net, item: int, *, is_left: bool) -> int:
        """Return the row of an item, counted from its first, at which a net reaches it."""
        return 0 if item < 0 else self._rows[item, is_left, net]

    def by_neighbour(self) -> dict[tuple[int, int], float]:
        """Return for each box and what it is joined with next how far off its middle that is."""
        found = {}
        for link, route in self._columns.routes.items():
            net = self._columns.nets[link]
            ends = ((route[0], route[1], False), (route[-1], route[-2], True))
            for item, near, is_left in ends:
                row = self._rows[item, is_left, net]
                found[item, near] = row + 0.5 - self._heights[item] / 2
        return found
