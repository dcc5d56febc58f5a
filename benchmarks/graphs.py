"""How long pictures of graphs take, against finding their columns, and with their number."""

from __future__ import annotations

import random
from collections.abc import Iterator, Sequence

from plastron_tui.output.graphs.boxes import Box, Shape
from plastron_tui.output.graphs.grid import Grid, grid_of
from plastron_tui.output.graphs.layers import Link, columns_of, components
from plastron_tui.output.graphs.layout import Layout, layout
from plastron_tui.output.graphs.ordering import ordered
from plastron_tui.output.graphs.sheet import Measure, Sheet

from .row import Row, paired

_RUNS = 9
_ROOM = 199


def rows() -> Iterator[Row]:
    links = _crowd(60)
    drawn, found, ratio = paired(
        lambda: _in_cells(60, links, _ROOM), lambda: _columns(60, links), _RUNS
    )
    yield Row(
        "60 nodes at 60 topics in characters, 200 wide / their columns and order",
        ratio,
        8,
        detail=f"{drawn * 1e3:.1f} ms / {found * 1e3:.1f} ms",
    )
    long, short, ratio = paired(
        lambda: _in_cells(80, _chain(80), _ROOM),
        lambda: [_in_cells(10, _chain(10), _ROOM) for _ in range(8)],
        _RUNS,
    )
    yield Row(
        "a chain of 80 nodes in rows of characters / of 10 nodes, eight times",
        ratio,
        2.5,
        detail=f"{long * 1e3:.1f} ms / {short * 1e3:.1f} ms",
    )
    large, small, ratio = paired(
        lambda: _in_pixels(240, _chain(240)),
        lambda: [_in_pixels(30, _chain(30)) for _ in range(8)],
        5,
    )
    yield Row(
        "a chain of 240 nodes in rows of pixels / of 30 nodes, eight times",
        ratio,
        4,
        detail=f"{large * 1e3:.0f} ms / {small * 1e3:.0f} ms",
    )


def _chain(length: int) -> list[Link]:
    links = [Link(at, length + at) for at in range(length)]
    return links + [Link(length + at, at + 1) for at in range(length - 1)]


def _crowd(count: int) -> list[Link]:
    """Nodes that speak and listen at random, each twice."""
    chance = random.Random(5)
    links: dict[Link, None] = {}
    for _ in range(2 * count):
        node, topic = chance.randrange(count), count + chance.randrange(count)
        links[Link(node, topic) if chance.random() < 0.5 else Link(topic, node)] = None
    return list(links)


def _columns(nodes: int, links: Sequence[Link]) -> list[Sheet]:
    """Return what `nodes` nodes and as many topics are in columns, one sheet for each part."""
    hubs = frozenset(range(nodes, 2 * nodes))
    sheets = []
    for part in components(range(2 * nodes), links):
        inside = set(part)
        columns = columns_of(part, [link for link in links if link.tail in inside], hubs)
        measures = {box: Measure(14, 2, 1) for box in part}
        sheets.append(Sheet(columns, ordered(columns), measures, 1, 0))
    return sheets


def _in_cells(nodes: int, links: Sequence[Link], room: int) -> list[Grid]:
    return [grid_of(sheet, room) for sheet in _columns(nodes, links)]


def _in_pixels(nodes: int, links: Sequence[Link]) -> Layout:
    shapes = [Shape.NODE] * nodes + [Shape.TOPIC] * nodes
    return layout([Box(shape, 120.0, 46.0) for shape in shapes], links)
