"""The lines of a drawn graph, followed character by character."""

from __future__ import annotations

import random
from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from machine import examples
from rich.cells import cell_len

from plastron_tui.output.graphs.folding import folded_links, folds_of
from plastron_tui.output.graphs.layers import Link, columns_of, components
from plastron_tui.output.graphs.ordering import ordered
from plastron_tui.output.graphs.wiring import Place
from plastron_tui.studio.panels.drawing import DETAILS, Label, Plan
from plastron_tui.studio.panels.styles import Lines
from plastron_tui.studio.panels.wires import CHARACTERS, CROSSING, DOWN, HEADS, LEFT, RIGHT, UP

Cell = tuple[int, int]

SIDES = {character: sides for sides, character in CHARACTERS.items() if sides.bit_count() > 1}
STEPS = {LEFT: (-1, 0), RIGHT: (1, 0), UP: (0, -1), DOWN: (0, 1)}
OPPOSITE = {LEFT: RIGHT, RIGHT: LEFT, UP: DOWN, DOWN: UP}
NAMES = (
    "talker",
    "a",
    "/robot/arm/joint_states_of_the_left_arm",
    "日本語のノード",
    "│─▶┼",
    "\x1b[2J\u202e",
)


def plans(boxes: int, links: Sequence[Link], first_hub: int, detail: int, room: int) -> list[Plan]:
    hubs = frozenset(range(first_hub, boxes))
    labels = [
        Label(NAMES[at % len(NAMES)], "String", "primary", at in hubs, "odd" if at % 5 == 3 else "")
        for at in range(boxes)
    ]
    made = []
    for part in components(range(boxes), links):
        columns = columns_of(part, [link for link in links if link.tail in part], hubs)
        made.append(Plan(labels, columns, ordered(columns), DETAILS[detail], room))
    return made


def cells_of(lines: Lines) -> dict[Cell, str]:
    found = {}
    for y, line in enumerate(lines):
        x = 0
        for character in "".join(piece.text for piece in line):
            found[x, y] = character
            x += cell_len(character)
    return found


def traced(cells: Mapping[Cell, str], places: Mapping[int, Place]) -> set[Link]:
    """Follow each line from each box that it leaves; return what joins what."""
    found = set()
    boxes = boxes_by_cell(places)
    for box, place in places.items():
        for y in range(place.y, place.y + place.height):
            right, left = (place.x + place.width, y), (place.x - 1, y)
            if SIDES.get(cells.get(right, " "), 0) & LEFT:
                found |= {Link(box, end) for end in heads(cells, boxes, right, RIGHT)}
            if SIDES.get(cells.get(left, " "), 0) & RIGHT:
                found |= {Link(box, end) for end in heads(cells, boxes, left, LEFT)}
    return found


def heads(
    cells: Mapping[Cell, str], boxes: Mapping[Cell, int], cell: Cell, towards: int
) -> Iterator[int]:
    """Yield the boxes that arrows lead to, from a cell that a line enters in some direction."""
    seen = set()
    rest = [(cell, towards)]
    while rest:
        (x, y), towards = step = rest.pop()
        if step in seen:
            continue
        seen.add(step)
        character = cells[x, y]
        if character in HEADS:
            assert towards == (RIGHT if character == HEADS[True] else LEFT)
            yield boxes[x + STEPS[towards][0], y]
            continue
        sides = SIDES[character]
        if character == CROSSING and towards in (LEFT, RIGHT):
            sides = LEFT | RIGHT
        assert sides & OPPOSITE[towards], (x, y, character)
        for side, (across, down) in STEPS.items():
            following = x + across, y + down
            if not sides & side or side == OPPOSITE[towards]:
                continue
            is_line = cells.get(following, " ") in SIDES or cells.get(following, " ") in HEADS
            if is_line and following not in boxes:
                rest.append((following, side))


def boxes_by_cell(places: Mapping[int, Place]) -> dict[Cell, int]:
    return {
        (x + right, y + down): box
        for box, (x, y, width, height) in places.items()
        for right in range(width)
        for down in range(height)
    }


def check_plan(plan: Plan, links: Sequence[Link], room: int) -> None:
    grid = plan.grid
    inside: set[Cell] = set()
    for x, y, width, height in grid.places.values():
        covered = {(x + right, y + down) for right in range(width) for down in range(height)}
        assert not covered & inside
        inside |= covered
    sides: dict[Cell, dict[object, int]] = {}
    for wire in grid.wires:
        for x, y, to_x, to_y in wire.runs:
            assert x == to_x or y == to_y
            for at in range(min(x, to_x), max(x, to_x)):
                join(sides, wire.net, (at, y), (at + 1, y), RIGHT)
            for at in range(min(y, to_y), max(y, to_y)):
                join(sides, wire.net, (x, at), (x, at + 1), DOWN)
    assert not sides.keys() & inside
    # Two nets share no run: where their lines meet, one passes level and the other upright.
    for cell, nets in sides.items():
        if len(nets) > 1:
            assert sorted(nets.values()) == [UP | DOWN, LEFT | RIGHT], cell
    cells = cells_of(plan.drawn())
    own = {link for link in links if link.tail in grid.places}
    assert traced(cells, grid.places) == own
    assert max(x for x, _ in cells) < grid.width
    assert max(y for _, y in cells) < grid.height
    if grid.width <= room:
        width, height = plan.least
        assert width <= room and height <= grid.height


def join(
    sides: dict[Cell, dict[object, int]], net: object, one: Cell, other: Cell, side: int
) -> None:
    for cell, towards in ((one, side), (other, OPPOSITE[side])):
        nets = sides.setdefault(cell, {})
        nets[net] = nets.get(net, 0) | towards


@st.composite
def graphs(draw: st.DrawFn) -> tuple[int, int, list[Link]]:
    nodes, hubs = draw(st.integers(1, 9)), draw(st.integers(1, 8))
    joints = st.tuples(
        st.integers(0, nodes - 1), st.integers(nodes, nodes + hubs - 1), st.booleans()
    )
    joined = draw(st.lists(joints, max_size=26, unique=True))
    return nodes, hubs, [Link(at, hub) if sends else Link(hub, at) for at, hub, sends in joined]


@settings(max_examples=examples(400), deadline=None)
@given(graphs(), st.integers(0, len(DETAILS) - 1), st.integers(20, 160))
def test_lines_can_be_followed_whatever_the_graph(
    graph: tuple[int, int, list[Link]], detail: int, room: int
) -> None:
    nodes, hubs, links = graph
    made = plans(nodes + hubs, links, nodes, detail, room)
    for plan in made:
        check_plan(plan, links, room)
    again = plans(nodes + hubs, links, nodes, detail, room)
    assert [plan.grid for plan in again] == [plan.grid for plan in made]


def chain(length: int) -> list[Link]:
    """Nodes of which each passes something on to the next one."""
    links = [Link(at, length + at) for at in range(length)]
    return links + [Link(length + at, at + 1) for at in range(length - 1)]


def ring(length: int) -> list[Link]:
    return [*chain(length), Link(2 * length - 1, 0)]


def hub(count: int) -> list[Link]:
    return [Link(0, count), *(Link(count, at) for at in range(1, count))]


def crowd(count: int) -> list[Link]:
    chance = random.Random(5)
    links = {}
    for _ in range(2 * count):
        node, topic = chance.randrange(count), count + chance.randrange(count)
        links[Link(node, topic) if chance.random() < 0.5 else Link(topic, node)] = None
    return list(links)


SHAPES = {"chain": chain(30), "ring": ring(14), "crowd": crowd(60)}


@pytest.mark.parametrize("links", SHAPES.values(), ids=SHAPES)
def test_lines_of_large_graphs_can_be_followed(links: list[Link]) -> None:
    nodes = 1 + max(min(link) for link in links)
    boxes = 1 + max(max(link) for link in links)
    for plan in plans(boxes, links, nodes, 3, 120):
        check_plan(plan, links, 120)


@pytest.mark.parametrize("count", [10, 12, 30])
@pytest.mark.parametrize("room", [60, 78, 118])
def test_chains_go_on_in_a_new_row(count: int, room: int) -> None:
    (plan,) = plans(2 * count, chain(count), count, 3, room)
    places = plan.grid.places
    assert plan.grid.width <= room
    in_order = [places[at] for pair in enumerate(range(count, 2 * count)) for at in pair]
    for one, other in pairwise(in_order):
        assert (other.x > one.x and other.y == one.y) or (other.x < room / 2 and other.y > one.y)
    rows = sorted({place.y for place in in_order})
    assert {lower - upper for upper, lower in pairwise(rows)} == {2}


def test_a_short_chain_stays_in_one_row() -> None:
    (plan,) = plans(6, chain(3), 3, 3, 118)
    assert plan.grid.height == 1


def test_a_row_is_as_long_as_there_is_room_for() -> None:
    lengths = {}
    for room in (60, 118, 200):
        (plan,) = plans(60, chain(30), 30, 4, room)
        lengths[room] = plan.grid.height
    assert list(lengths.values()) == sorted(lengths.values(), reverse=True)
    assert len(set(lengths.values())) == 3


def test_nodes_that_only_listen_at_one_topic_can_be_folded() -> None:
    links = hub(31)
    links.append(Link(7, 32))
    folds = folds_of(links, frozenset({31, 32}))
    (fold,) = folds
    assert len(fold.members) == 30 - 1 - 5 and 7 not in fold.members
    after = folded_links(links, folds, 33)
    assert Link(31, 33) in after
    assert {end for link in after for end in link}.isdisjoint(fold.members)
    assert folds_of(hub(7), frozenset({7})) == []
