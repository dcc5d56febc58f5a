"""The graph as an SVG picture that needs nothing else: no program, no font, no style sheet."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise
from math import copysign
from xml.sax.saxutils import escape

from plastron_tui.diagnostics.terminal import visible
from plastron_tui.diagnostics.wording import counted
from plastron_tui.model.graph import NOUNS, Graph, Hub
from plastron_tui.ros.interfaces import InterfaceKind

from .boxes import BEVEL, CUT, Box, Point, Shape, inset
from .captions import ends_of, hub_text, missing_text, node_text, type_text
from .identifiers import Edge, edges_of, identified
from .layers import Link
from .layout import Layout, layout
from .robots.svg import robot_svg
from .robots.svg_style import STYLE as ROBOT_STYLE
from .style import ARROW, LEGEND_HEIGHT, MARGIN, STYLE, legend, legend_width, number
from .widths import broken, drawable, text_width

_ROOM = 230.0
_ROUNDING = 9.0
_NAME_SIZE = 13.0
_CAPTION_SIZE = 10.5
_LEADING = {_NAME_SIZE: 17.0, _CAPTION_SIZE: 14.0}
_PADDING = {Shape.NODE: 14.0, Shape.TOPIC: 6.0, Shape.SERVICE: 8.0, Shape.ACTION: 8.0}
_NARROWEST = {Shape.NODE: 96.0, Shape.TOPIC: 84.0, Shape.SERVICE: 84.0, Shape.ACTION: 84.0}


@dataclass(frozen=True, slots=True)
class _Line:
    """A line of text in a box."""

    text: str
    size: float
    kind: str

    @property
    def width(self) -> float:
        return text_width(self.text, self.size, bold=self.kind == "name bold")


@dataclass(frozen=True, slots=True)
class _Label:
    """What is in a box, and what it is called in full."""

    identifier: str
    box: Box
    lines: tuple[_Line, ...]
    title: str
    is_missing: bool


def render(graph: Graph) -> str:
    """Return a picture: boxes in columns, messages from left to right.

    Robots stand below it, or alone where there is no node. It is the same for the same graph, has
    its own background in light and in dark, and says everything in `title` and `desc` elements too.
    """
    labels = list(_labels(graph))
    numbers = {label.identifier: at for at, label in enumerate(labels)}
    edges = list(edges_of(graph))
    links = {edge: Link(*(numbers[end] for end in edge.ends)) for edge in edges}
    made = layout([label.box for label in labels], list(links.values()))
    return "".join(f"{line}\n" for line in _document(graph, labels, links, made))


def _document(
    graph: Graph, labels: list[_Label], links: dict[Edge, Link], made: Layout
) -> Iterator[str]:
    robots = [robot_svg(each) for each in graph.robots]
    # A program of robots alone has no graph.
    has_graph = not robots or bool(graph.nodes)
    drawn = made.height + MARGIN + LEGEND_HEIGHT if has_graph else 0.0
    widths = [max(made.width, legend_width(graph))] if has_graph else []
    width = max([*widths, *(each.width for each in robots)]) + 2 * MARGIN
    height = drawn + MARGIN + sum(each.height + MARGIN for each in robots)
    size = f'width="{number(width)}" height="{number(height)}"'
    box = f'viewBox="0 0 {number(width)} {number(height)}"'
    yield (
        f'<svg xmlns="http://www.w3.org/2000/svg" {size} {box} role="img" '
        'aria-labelledby="title desc">'
    )
    titles = [_title(graph)] if has_graph else []
    described = [_description(graph)] if has_graph else []
    titles += [each.title for each in robots]
    described += [each.description for each in robots]
    yield f'<title id="title">{_escaped("; ".join(titles))}</title>'
    yield f'<desc id="desc">{_escaped("; ".join(described))}</desc>'
    yield STYLE
    if robots:
        yield ROBOT_STYLE
    yield f'<rect class="paper" {size} rx="10"/>'
    if has_graph:
        yield f'<g transform="translate({number((width - made.width) / 2)} {number(MARGIN)})">'
        for edge, link in links.items():
            yield from _edge(graph, edge, made.lines[link])
        for label, placed in zip(labels, made.boxes, strict=True):
            yield from _box(label, placed)
        yield "</g>"
        yield from legend(graph, drawn + MARGIN - LEGEND_HEIGHT)
    top = drawn + MARGIN
    for robot in robots:
        yield f'<g transform="translate({number(MARGIN)} {number(top)})">'
        yield from robot.lines
        yield "</g>"
        top += robot.height + MARGIN
    yield "</svg>"


def _title(graph: Graph) -> str:
    counts = [(len(graph.nodes), "node")]
    counts += [(len(hubs), NOUNS[at]) for at, hubs in graph.at.items()]
    parts = [counted(count, word) for count, word in counts]
    return f"A ROS graph of {', '.join(parts[:-1])} and {parts[-1]}"


def _description(graph: Graph) -> str:
    return "; ".join(map(_sentence, graph.hubs)) or _title(graph)


def _sentence(hub: Hub) -> str:
    parts = [f"{node.name} {verb}" for node, verb, _ in ends_of(hub)]
    if hub.missing is not None:
        parts.append(missing_text(hub.missing))
    return f"{hub.name} ({type_text(hub.types)}): {', '.join(parts)}"


def _labels(graph: Graph) -> Iterator[_Label]:
    for at, node in enumerate(graph.nodes):
        title = f"node {node.name} ({node_text(node)})"
        texts = (node.name, node_text(node), "")
        yield _label(f"n{at}", Shape.NODE, texts, title)
    for identifier, hub in identified(graph):
        texts = (hub.name, hub_text(hub), missing_text(hub.missing))
        yield _label(identifier, Shape(hub.noun), texts, f"{hub.noun} {_sentence(hub)}")


def _label(identifier: str, shape: Shape, texts: tuple[str, str, str], title: str) -> _Label:
    name, caption, missing = (drawable(text) for text in texts)
    bold = shape is Shape.NODE
    kind = "name bold" if bold else "name"
    lines = [
        _Line(text, _NAME_SIZE, kind) for text in broken(name, _NAME_SIZE, _ROOM, 3, bold=bold)
    ]
    lines += [
        _Line(text, _CAPTION_SIZE, "caption") for text in broken(caption, _CAPTION_SIZE, _ROOM, 2)
    ]
    if missing:
        lines.append(_Line(missing, _CAPTION_SIZE, "alarm"))
    height = sum(_LEADING[line.size] for line in lines) + 14.0
    # Where an outline curves inward, a line of text in its corner needs a wider box.
    widths = [
        line.width + 2 * (inset(shape, height, _reach(top, line, height)) + _PADDING[shape])
        for top, line in _tops(lines, height)
    ]
    box = Box(shape, max(_NARROWEST[shape], *widths), height)
    return _Label(identifier, box, tuple(lines), title, bool(missing))


def _tops(lines: list[_Line] | tuple[_Line, ...], height: float) -> Iterator[tuple[float, _Line]]:
    """Yield the lines with their upper edges in a box of some height."""
    top = (height - sum(_LEADING[line.size] for line in lines)) / 2
    for line in lines:
        yield top, line
        top += _LEADING[line.size]


def _reach(top: float, line: _Line, height: float) -> float:
    """Return how far a line of text reaches from the middle of its box, up or down."""
    return max(abs(top - height / 2), abs(top + _LEADING[line.size] - height / 2))


def _box(label: _Label, box: Box) -> Iterator[str]:
    missing = " missing" if label.is_missing else ""
    yield f'<g class="{box.shape.value}{missing}" id="{label.identifier}">'
    yield f"<title>{_escaped(label.title)}</title>"
    yield _outline(box)
    for top, line in _tops(label.lines, box.height):
        baseline = box.y + top + _LEADING[line.size] * 0.5 + line.size * 0.35
        yield (
            f'<text class="{line.kind}" x="{number(box.x + box.width / 2)}" '
            f'y="{number(baseline)}">{_escaped(line.text)}</text>'
        )
    yield "</g>"


def _outline(box: Box) -> str:
    x, y, width, height = (number(value) for value in (box.x, box.y, box.width, box.height))
    if box.shape is Shape.SERVICE:
        right, middle, bottom = box.x + box.width, box.middle, box.y + box.height
        corners = (
            (box.x, middle),
            (box.x + CUT, box.y),
            (right - CUT, box.y),
            (right, middle),
            (right - CUT, bottom),
            (box.x + CUT, bottom),
        )
        points = " ".join(f"{number(one)},{number(other)}" for one, other in corners)
        return f'<polygon class="shape" points="{points}"/>'
    if box.shape is Shape.ACTION:
        across, down = number(box.width - 2 * BEVEL), number(box.height - 2 * BEVEL)
        corner = number(BEVEL)
        return (
            f'<path class="shape" d="M{number(box.x + BEVEL)} {y}h{across}l{corner} {corner}v{down}'
            f'l-{corner} {corner}h-{across}l-{corner} -{corner}v-{down}z"/>'
        )
    radius = number(box.height / 2 if box.shape is Shape.TOPIC else 8.0)
    return f'<rect class="shape" x="{x}" y="{y}" width="{width}" height="{height}" rx="{radius}"/>'


def _edge(graph: Graph, edge: Edge, lines: tuple[tuple[Point, ...], ...]) -> Iterator[str]:
    title = f"{graph.nodes[edge.node].name} {edge.kind.facts.does} {edge.hub_in(graph).name}"
    kinds = _LINES[edge.hub_in(graph).interface]
    start, end = edge.ends
    yield f'<g class="edge" data-from="{start}" data-to="{end}">'
    yield f"<title>{_escaped(title)}</title>"
    for kind, line in zip(kinds, lines, strict=True):
        yield f'<path class="{kind}" d="{_path(line)}"/>'
        yield f'<path class="head {kind}-head" d="{_head(line)}"/>'
    yield "</g>"


_LINES = {
    InterfaceKind.MESSAGE: ("message",),
    InterfaceKind.SERVICE: ("request", "response"),
    InterfaceKind.ACTION: ("goal", "result"),
}


def _path(line: tuple[Point, ...]) -> str:
    """Draw a line up to the foot of its arrow head."""
    tip = line[-1]
    points = [*line[:-1], Point(tip.x - ARROW * _direction(line), tip.y)]
    drawn = [f"M{number(points[0].x)} {number(points[0].y)}"]
    for at, (start, end) in enumerate(pairwise(points)):
        following = points[at + 2] if at + 2 < len(points) else None
        if start.x != end.x and start.y != end.y:
            half = number((start.x + end.x) / 2)
            drawn.append(
                f"C{half} {number(start.y)} {half} {number(end.y)} {number(end.x)} {number(end.y)}"
            )
        elif following is not None and _is_corner(start, end, following):
            before, behind = _towards(end, start), _towards(end, following)
            drawn.append(f"L{number(before.x)} {number(before.y)}")
            drawn.append(f"Q{number(end.x)} {number(end.y)} {number(behind.x)} {number(behind.y)}")
        elif start.y == end.y:
            drawn.append(f"H{number(end.x)}")
        else:
            drawn.append(f"V{number(end.y)}")
    return "".join(drawn)


def _is_corner(start: Point, corner: Point, end: Point) -> bool:
    """Tell whether a level piece meets an upright one."""
    return (start.y == corner.y and corner.x == end.x) or (
        start.x == corner.x and corner.y == end.y
    )


def _towards(corner: Point, other: Point) -> Point:
    """Return where the rounding of a corner ends, on the way to another point."""
    across, down = other.x - corner.x, other.y - corner.y
    reach = min(_ROUNDING, max(abs(across), abs(down)) / 2)
    return Point(
        corner.x + copysign(min(reach, abs(across)), across),
        corner.y + copysign(min(reach, abs(down)), down),
    )


def _head(line: tuple[Point, ...]) -> str:
    tip = line[-1]
    foot = number(tip.x - ARROW * _direction(line))
    upper, lower = number(tip.y - ARROW * 0.5), number(tip.y + ARROW * 0.5)
    return f"M{number(tip.x)} {number(tip.y)}L{foot} {upper}V{lower}Z"


def _direction(line: tuple[Point, ...]) -> float:
    return 1.0 if line[-1].x > line[-2].x else -1.0


def _escaped(text: str) -> str:
    return escape(visible(text))
