"""From a graph to columns: which box stands in which, with every link from left to right.

The method is that of Sugiyama, Tagawa and Toda (1981), with the cycles broken as by Eades, Lin
and Smyth (1993). Boxes are numbers; so are the turning points of long links, after the boxes.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import NamedTuple


class Link(NamedTuple):
    """A link between two boxes, one of which is a hub: a topic or a service."""

    tail: int
    head: int


class Net(NamedTuple):
    """The links of a hub in one direction: they share turning points, and may share a line."""

    hub: int
    from_hub: bool
    is_backward: bool


@dataclass(frozen=True, slots=True)
class Columns:
    """Boxes and turning points by column.

    Attributes:
        columns: from left to right; within a column in no order that means anything.
        column_of: the column of each box and each turning point.
        segments: pairs of neighbours in adjacent columns, the left one first.
        routes: for each link what it runs through, from left to right, its ends included.
        nets: the net of each link.
        reversed: the links that run from right to left.
    """

    columns: list[list[int]]
    column_of: dict[int, int]
    segments: list[tuple[int, int]]
    routes: dict[Link, list[int]]
    nets: dict[Link, Net]
    reversed: frozenset[Link]


def components(boxes: Sequence[int], links: Iterable[Link]) -> list[list[int]]:
    """Return the boxes that hang together, in the order of their first boxes."""
    neighbours: dict[int, list[int]] = {box: [] for box in boxes}
    for tail, head in links:
        neighbours[tail].append(head)
        neighbours[head].append(tail)
    seen: set[int] = set()
    found = []
    for first in boxes:
        if first in seen:
            continue
        seen.add(first)
        reached = [first]
        for box in reached:
            fresh = [near for near in dict.fromkeys(neighbours[box]) if near not in seen]
            seen.update(fresh)
            reached += fresh
        found.append(reached)
    return found


def columns_of(boxes: Sequence[int], links: Sequence[Link], hubs: frozenset[int]) -> Columns:
    """Put the boxes of one component into columns: nodes in even ones, hubs in odd ones."""
    rank = {box: at for at, box in enumerate(_acyclic_order(boxes, links))}
    backward = frozenset(link for link in links if rank[link.tail] > rank[link.head])
    forward = [(link.head, link.tail) if link in backward else link for link in links]
    column_of = _columns(sorted(boxes, key=rank.__getitem__), forward, hubs)
    return _with_turns(column_of, links, backward, hubs)


def _acyclic_order(boxes: Sequence[int], links: Sequence[Link]) -> list[int]:
    """Order the boxes so that few links run backward."""
    after: dict[int, set[int]] = {box: set() for box in boxes}
    before: dict[int, set[int]] = {box: set() for box in boxes}
    for tail, head in links:
        after[tail].add(head)
        before[head].add(tail)
    left: list[int] = []
    right: list[int] = []
    rest = dict.fromkeys(boxes)
    free = [box for box in boxes if not after[box] or not before[box]]
    while rest:
        box = free.pop() if free else max(rest, key=lambda box: len(after[box]) - len(before[box]))
        if box not in rest:
            continue
        del rest[box]
        (right if not after[box] else left).append(box)
        for near in after[box]:
            before[near].discard(box)
        for near in before[box]:
            after[near].discard(box)
        near_by = sorted(after[box] | before[box])
        free += [near for near in near_by if not after[near] or not before[near]]
    return left + right[::-1]


def _columns(
    order: Sequence[int], links: Iterable[tuple[int, int]], hubs: frozenset[int]
) -> dict[int, int]:
    """Return the column of each box: behind all that leads to it, near to what it leads to."""
    before: dict[int, list[int]] = {box: [] for box in order}
    after: dict[int, list[int]] = {box: [] for box in order}
    for left, right in links:
        before[right].append(left)
        after[left].append(right)
    column: dict[int, int] = {}
    for box in order:
        lowest = 1 if box in hubs else 0
        column[box] = max((column[near] + 1 for near in before[box]), default=lowest)
    for box in reversed(order):
        if after[box] and len(after[box]) > len(before[box]):
            column[box] = min(column[near] for near in after[box]) - 1
    first = min(column.values())
    return {box: at - first for box, at in column.items()}


def _with_turns(
    column_of: dict[int, int],
    links: Sequence[Link],
    backward: frozenset[Link],
    hubs: frozenset[int],
) -> Columns:
    """Cut links over several columns at turning points, which all links of a hub share."""
    next_turn = -1
    turns: dict[tuple[Net, int], int] = {}
    segments: dict[tuple[int, int], None] = {}
    routes = {}
    nets = {}
    for link in links:
        is_backward = link in backward
        left, right = (link.head, link.tail) if is_backward else link
        hub_is_tail = link.tail in hubs
        hub = link.tail if hub_is_tail else link.head
        net = nets[link] = Net(hub, hub_is_tail, is_backward)
        route = [left]
        for column in range(column_of[left] + 1, column_of[right]):
            turn = turns.get((net, column))
            if turn is None:
                turn = turns[net, column] = next_turn
                column_of[turn] = column
                next_turn -= 1
            route.append(turn)
        route.append(right)
        routes[link] = route
        segments.update(dict.fromkeys(pairwise(route)))
    columns: list[list[int]] = [[] for _ in range(max(column_of.values()) + 1)]
    for item, column in column_of.items():
        columns[column].append(item)
    return Columns(columns, column_of, list(segments), routes, nets, backward)


Between = dict[Net, tuple[list[int], list[int]]]
"""The nets between two columns, with the items that each joins on the left and on the right."""


def nets_between(columns: Columns) -> list[Between]:
    """Return the nets between each two columns, with the items that each joins there."""
    found: list[dict[Net, tuple[dict[int, None], dict[int, None]]]] = [
        {} for _ in range(len(columns.columns) - 1)
    ]
    for link, route in columns.routes.items():
        for left, right in pairwise(route):
            between = found[columns.column_of[left]]
            lefts, rights = between.setdefault(columns.nets[link], ({}, {}))
            lefts[left] = rights[right] = None
    return [
        {net: (list(lefts), list(rights)) for net, (lefts, rights) in between.items()}
        for between in found
    ]
