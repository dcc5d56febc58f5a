from __future__ import annotations

import random
import re
import xml.etree.ElementTree as ET
from itertools import combinations, pairwise

import pytest
from graph_workspaces import TOPICS, Maker, tour, workspaces
from hypothesis import given, settings
from machine import examples

from plastron_tui.model.graph import graph_of
from plastron_tui.model.workspace import Workspace
from plastron_tui.output.graphs.boxes import Box, Shape
from plastron_tui.output.graphs.identifiers import edges_of
from plastron_tui.output.graphs.layers import Link, columns_of
from plastron_tui.output.graphs.layout import Layout, layout
from plastron_tui.output.graphs.ordering import crossings, neighbours_of, ordered
from plastron_tui.output.graphs.svg import render
from plastron_tui.output.graphs.widths import broken, drawable, text_width

_SVG = "{http://www.w3.org/2000/svg}"
_SIZES = {"name bold": 13.0, "name": 13.0, "caption": 10.5, "alarm": 10.5}


def many(count: int, seed: int = 7) -> Workspace:
    """Nodes that talk at random, with cycles of every length."""
    chance = random.Random(seed)
    make = Maker()
    nodes = [make.node(f"node_{at}") for at in range(count)]
    for _ in range(count * 2):
        node, topic = chance.choice(nodes), f"topic_{chance.randrange(count)}"
        if chance.random() < 0.5:
            make.publish(node, topic, ("m", 10.0))
        else:
            make.subscribe(node, topic)
    for _ in range(count // 3):
        make.call(chance.choice(nodes), f"service_{chance.randrange(count // 5 + 1)}", {})
        make.provide(chance.choice(nodes), f"service_{chance.randrange(count // 5 + 1)}")
    return make.workspace


def laid_out(workspace: Workspace) -> Layout:
    graph = graph_of(workspace)
    places = [*graph.topics, *graph.services]
    shapes = [Shape.TOPIC] * len(graph.topics) + [Shape.SERVICE] * len(graph.services)
    boxes = [Box(Shape.NODE, 100.0 + 7 * (at % 9), 46.0) for at in range(len(graph.nodes))]
    boxes += [Box(shape, 90.0 + 11 * (at % 7), 48.0) for at, shape in enumerate(shapes)]
    first = {"n": 0, "t": len(graph.nodes), "s": len(graph.nodes) + len(graph.topics)}
    links = [Link(*(first[end[0]] + int(end[1:]) for end in edge.ends)) for edge in edges_of(graph)]
    assert len(places) + len(graph.nodes) == len(boxes)
    return layout(boxes, links)


def check_layout(made: Layout) -> None:
    for one, other in combinations(made.boxes, 2):
        apart_x = one.x + one.width < other.x or other.x + other.width < one.x
        apart_y = one.y + one.height < other.y or other.y + other.height < one.y
        assert apart_x or apart_y, (one, other)
    for box in made.boxes:
        assert box.x >= -0.01 and box.x + box.width <= made.width + 0.01
        assert box.y >= -0.01 and box.y + box.height <= made.height + 0.01
    for link, lines in made.lines.items():
        tail, head = made.boxes[link.tail], made.boxes[link.head]
        is_service = Shape.SERVICE in (tail.shape, head.shape)
        assert len(lines) == (2 if is_service else 1)
        for line, (start, end) in zip(lines, ((tail, head), (head, tail)), strict=False):
            assert _touches(line[0], start)
            assert _touches(line[-1], end)
            # The arrow head needs a level end.
            assert abs(line[-1].x - line[-2].x) >= 8 and line[-1].y == line[-2].y


def check_clearance(made: Layout) -> None:
    """No line runs through a box: neither a level piece nor a curve."""
    for link, lines in made.lines.items():
        for number, box in enumerate(made.boxes):
            own = number in link
            for line in lines:
                for start, end in pairwise(line):
                    left, right = sorted((start.x, end.x))
                    top, bottom = sorted((start.y, end.y))
                    inside = (
                        right > box.x + 0.01
                        and left < box.x + box.width - 0.01
                        and bottom > box.y
                        and top < box.y + box.height
                    )
                    # A line may start inside the corner that an outline cuts off.
                    assert not inside or (own and top == bottom), (link, box)


def check_runs(made: Layout) -> None:
    """Lines of different hubs, or of different directions, share no level and no upright piece."""
    runs: dict[tuple[bool, float], list[tuple[float, float, object]]] = {}
    for link, lines in made.lines.items():
        hub = max(link)
        for at, line in enumerate(lines):
            net = hub, link.tail == hub, at
            for start, end in pairwise(line):
                if start == end or (start.x != end.x and start.y != end.y):
                    continue
                is_level = start.y == end.y
                place = start.y if is_level else start.x
                low, high = sorted((start.x, end.x) if is_level else (start.y, end.y))
                others = runs.setdefault((is_level, round(place, 1)), [])
                for other_low, other_high, other in others:
                    assert other == net or high <= other_low or low >= other_high, (net, other)
                others.append((low, high, net))


def _touches(point, box: Box) -> bool:
    dy = point.y - box.middle
    inset = box.inset(dy)
    sides = (box.x + inset, box.x + box.width - inset)
    return abs(dy) <= box.height / 2 and min(abs(point.x - side) for side in sides) < 0.01


@settings(max_examples=examples(60), deadline=None)
@given(workspaces())
def test_boxes_stand_apart_and_lines_join_them(workspace: Workspace) -> None:
    made = laid_out(workspace)
    check_layout(made)
    check_clearance(made)
    check_runs(made)


@pytest.mark.parametrize("count", [1, 5, 40])
def test_pictures_of_any_size(count: int) -> None:
    workspace = many(count)
    made = laid_out(workspace)
    check_layout(made)
    check_clearance(made)
    check_runs(made)
    check_document(render(graph_of(workspace)), workspace)


def chain(length: int, *, of_services: bool = False) -> Workspace:
    """Nodes of which each passes something on to the next one, the first from the last."""
    make = Maker()
    nodes = [make.node(f"node_{at}") for at in range(length)]
    for at, node in enumerate(nodes):
        if of_services:
            make.call(node, f"to_{at}", {})
            make.provide(node, f"to_{at - 1}")
            continue
        make.publish(node, f"to_{at}", ("m", 10.0))
        make.subscribe(node, f"to_{(at or length) - 1}")
    return make.workspace


@pytest.mark.parametrize("count", [10, 14, 30])
@pytest.mark.parametrize("of_services", [False, True])
def test_a_long_chain_is_broken_into_rows(count: int, of_services: bool) -> None:
    made = laid_out(chain(count, of_services=of_services))
    check_layout(made)
    check_clearance(made)
    check_runs(made)
    assert 1.0 < made.width / made.height < 2.6
    assert len({round(box.middle) for box in made.boxes}) > 1


def test_a_picture_of_500_nodes() -> None:
    workspace = many(500)
    check_document(render(graph_of(workspace)), workspace)


def check_document(text: str, workspace: Workspace) -> None:
    graph = graph_of(workspace)
    root = ET.fromstring(text)
    assert root.tag == f"{_SVG}svg"
    assert root.find(f"{_SVG}title") is not None and root.find(f"{_SVG}desc") is not None
    identifiers = [group.get("id") for group in root.iter(f"{_SVG}g") if group.get("id")]
    wanted = [f"n{at}" for at in range(len(graph.nodes))]
    wanted += [f"t{at}" for at in range(len(graph.topics))]
    wanted += [f"s{at}" for at in range(len(graph.services))]
    assert identifiers == wanted
    joined = [
        (group.get("data-from"), group.get("data-to"))
        for group in root.iter(f"{_SVG}g")
        if group.get("class") == "edge"
    ]
    assert joined == [edge.ends for edge in edges_of(graph)]
    for group in root.iter(f"{_SVG}g"):
        if group.get("id"):
            check_texts(group)


def check_texts(group: ET.Element) -> None:
    """Every text stays within the outline of its box at its own height."""
    shape, (left, top, width, height) = _outline(group)
    middle = top + height / 2
    texts = group.findall(f"{_SVG}text")
    assert texts
    for text in texts:
        kind = text.get("class") or ""
        size = _SIZES[kind]
        wide = text_width(text.text or "", size, bold=kind == "name bold")
        x, baseline = float(text.get("x") or 0), float(text.get("y") or 0)
        for y in (baseline - 0.75 * size, baseline + 0.25 * size):
            assert top <= y <= top + height
            inset = Box(shape, width, height).inset(y - middle)
            assert x - wide / 2 >= left + inset
            assert x + wide / 2 <= left + width - inset


def _outline(group: ET.Element) -> tuple[Shape, tuple[float, float, float, float]]:
    rect = group.find(f"{_SVG}rect")
    if rect is not None:
        shape = Shape.TOPIC if (group.get("class") or "").startswith("topic") else Shape.NODE
        x, y, width, height = (float(rect.get(key) or 0) for key in ("x", "y", "width", "height"))
        return shape, (x, y, width, height)
    polygon = group.find(f"{_SVG}polygon")
    assert polygon is not None
    points = [tuple(map(float, pair.split(","))) for pair in (polygon.get("points") or "").split()]
    xs, ys = [x for x, _ in points], [y for _, y in points]
    return Shape.SERVICE, (min(xs), min(ys), max(xs) - min(xs), max(ys) - min(ys))


@settings(max_examples=examples(60), deadline=None)
@given(workspaces())
def test_a_picture_shows_each_thing_once_whatever_the_names(workspace: Workspace) -> None:
    check_document(render(graph_of(workspace)), workspace)


def test_arrow_heads_touch_the_boxes() -> None:
    text = render(graph_of(tour()))
    root = ET.fromstring(text)
    outlines = {
        group.get("id"): _outline(group) for group in root.iter(f"{_SVG}g") if group.get("id")
    }
    for group in root.iter(f"{_SVG}g"):
        if group.get("class") != "edge":
            continue
        heads = [path for path in group.iter(f"{_SVG}path") if "head" in (path.get("class") or "")]
        ends = (group.get("data-to"), group.get("data-from"))
        for path, end in zip(heads, ends, strict=False):
            tip = re.match(r"M(\S+) ([\d.]+)L", path.get("d") or "")
            assert tip is not None
            shape, (left, top, width, height) = outlines[end]
            x, dy = float(tip[1]), float(tip[2]) - top - height / 2
            inset = Box(shape, width, height).inset(dy)
            assert min(abs(x - left - inset), abs(x - left - width + inset)) < 0.5


def test_a_picture_is_legible_in_the_dark_and_needs_nothing_else() -> None:
    text = render(graph_of(tour()))
    assert "prefers-color-scheme:dark" in text
    assert not re.search("https?://(?!www.w3.org/2000/svg)|@import|url\\(|<script|<image", text)
    assert "nobody listens" in text and "driver_node.py" in text


def test_an_empty_program_has_a_picture_too() -> None:
    assert "nothing here yet" in render(graph_of(Workspace()))


def test_a_chain_runs_from_left_to_right() -> None:
    make = Maker()
    talker, relay, listener = make.node("talker"), make.node("relay"), make.node("listener")
    make.publish(talker, "a", ("m", 1.0))
    make.subscribe(relay, "a")
    make.publish(relay, "b", ("m", 1.0))
    make.subscribe(listener, "b")
    made = laid_out(make.workspace)
    talks, relays, listens, first, second = (box.x for box in made.boxes)
    assert talks < first < relays < second < listens
    assert len({box.middle for box in made.boxes}) == 1


def test_columns_hold_nodes_or_hubs_and_a_cycle_turns_one_link() -> None:
    links = [Link(0, 2), Link(2, 1), Link(1, 3), Link(3, 0)]
    columns = columns_of([0, 1, 2, 3], links, frozenset({2, 3}))
    assert len(columns.reversed) == 1
    assert [columns.column_of[box] % 2 for box in range(4)] in ([0, 0, 1, 1], [1, 1, 0, 0])


def test_crossings_that_need_not_be_are_not() -> None:
    count = len(TOPICS)
    links = [Link(at, 2 * count - 1 - at) for at in range(count)]
    links += [Link(at, 2 * count - 2 - at) for at in range(count - 1)]
    columns = columns_of(list(range(2 * count)), links, frozenset(range(count, 2 * count)))
    columns.columns[0].sort()
    columns.columns[1].sort()
    _, right = neighbours_of(columns)
    assert crossings([list(column) for column in columns.columns], right) > 0
    assert crossings(ordered(columns), right) == 0


@pytest.mark.parametrize(
    ("text", "room", "most", "lines"),
    [
        ("/chatter", 200, 3, ["/chatter"]),
        ("/robot/arm/joint", 60, 3, ["/robot/", "arm/joint"]),
        ("", 60, 3, [""]),
    ],
)
def test_names_break_at_their_parts(text: str, room: float, most: int, lines: list[str]) -> None:
    assert broken(text, 13.0, room, most) == lines


def test_a_name_that_is_too_long_keeps_its_start_and_its_end() -> None:
    name = "start" + "x" * 500 + "finish"
    lines = broken(name, 13.0, 150.0, 3)
    assert len(lines) == 3
    assert lines[0].startswith("start") and lines[1].startswith("…")
    assert lines[-1].endswith("finish")
    assert all(text_width(line, 13.0) <= 150.0 for line in lines)


def test_what_no_table_knows_is_escaped() -> None:
    assert drawable("a é 日 \u202e\U0001f600\n") == "a é 日 \\u202e\\U0001f600\\n"
