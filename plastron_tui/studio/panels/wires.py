"""The lines of a graph as characters."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from plastron_tui.output.graphs.layers import Net
    from plastron_tui.output.graphs.wiring import Wire

UP, DOWN, LEFT, RIGHT = 1, 2, 4, 8
CHARACTERS = {
    LEFT | RIGHT: "─", UP | DOWN: "│", LEFT | DOWN: "╮", LEFT | UP: "╯",
    RIGHT | DOWN: "╭", RIGHT | UP: "╰", LEFT | RIGHT | DOWN: "┬",
    LEFT | RIGHT | UP: "┴", UP | DOWN | RIGHT: "├", UP | DOWN | LEFT: "┤",
    UP | DOWN | LEFT | RIGHT: "┼", LEFT: "─", RIGHT: "─", UP: "│", DOWN: "│",
}  # fmt: skip
"""The character that joins some sides of a cell: a line that ends is drawn to the cell's edge."""

HEADS = "◀▶"
"""Arrow heads, to the left and to the right."""

CROSSING = "│"
"""Where two nets cross, the level line passes below the upright one, as a road below a bridge.

So `┼` is left for where four pieces of one net meet.
"""


def line_characters(wires: Iterable[Wire]) -> dict[tuple[int, int], str]:
    """Return the character in each cell that a line runs through."""
    cells: dict[tuple[int, int], dict[Net, int]] = {}
    heads: dict[tuple[int, int], str] = {}
    for wire in wires:
        for x, y, to_x, to_y in wire.runs:
            if (x, y) == (to_x, to_y):
                cells.setdefault((x, y), {}).setdefault(wire.net, 0)
            for at in range(min(x, to_x), max(x, to_x)):
                _join(cells, wire.net, (at, y), (at + 1, y), RIGHT, LEFT)
            for at in range(min(y, to_y), max(y, to_y)):
                _join(cells, wire.net, (x, at), (x, at + 1), DOWN, UP)
        heads.update({(head.x, head.y): HEADS[head.to_right] for head in wire.heads})
    drawn = {
        cell: CROSSING if len(nets) > 1 else CHARACTERS.get(next(iter(nets.values())), "─")
        for cell, nets in cells.items()
    }
    return drawn | heads


def _join(
    cells: dict[tuple[int, int], dict[Net, int]],
    net: Net,
    one: tuple[int, int],
    other: tuple[int, int],
    side: int,
    opposite: int,
) -> None:
    for cell, towards in ((one, side), (other, opposite)):
        nets = cells.setdefault(cell, {})
        nets[net] = nets.get(net, 0) | towards
