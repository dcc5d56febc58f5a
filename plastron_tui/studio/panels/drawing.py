"""The graph of a program as boxes and arrows of characters."""

from __future__ import annotations

from plastron_tui.model.graph import Graph
from plastron_tui.output.graphs.layers import Columns, Link, columns_of, components
from plastron_tui.output.graphs.ordering import ordered

from .tones import Line, Lines, Piece

MOST_BOXES = 400
"""With more boxes than this nobody reads the picture."""

_WIDEST = 26
_UP, _DOWN, _LEFT, _RIGHT = 1, 2, 4, 8
_LINES = {
    _LEFT | _RIGHT: "─", _UP | _DOWN: "│", _LEFT | _DOWN: "╮", _LEFT | _UP: "╯",
    _RIGHT | _DOWN: "╭", _RIGHT | _UP: "╰", _LEFT | _RIGHT | _DOWN: "┬",
    _LEFT | _RIGHT | _UP: "┴", _UP | _DOWN | _RIGHT: "├", _UP | _DOWN | _LEFT: "┤",
    _UP | _DOWN | _LEFT | _RIGHT: "┼", _LEFT: "─", _RIGHT: "─", _UP: "│", _DOWN: "│",
}  # fmt: skip


class _Sheet:
    """Characters with tones, by place; it grows as it is drawn on."""

    def __init__(self) -> None:
        self.rows: list[dict[int, tuple[str, str]]] = []

    def put(self, x: int, y: int, text: str, tone: str = "") -> None:
        while len(self.rows) <= y:
            self.rows.append({})
        for at, character in enumerate(text, x):
            self.rows[y][at] = (character, tone)

    def lines(self) -> Lines:
        return tuple(self._line(row) for row in self.rows)

    @staticmethod
    def _line(row: dict[int, tuple[str, str]]) -> Line:
        pieces: list[Piece] = []
        text, tone = "", ""
        for at in range(max(row, default=-1) + 1):
            character, here = row.get(at, (" ", tone))
            if here != tone:
                pieces.append(Piece(text, tone))
                text, tone = "", here
            text += character
        pieces.append(Piece(text, tone))
        return tuple(piece for piece in pieces if piece.text)


class _Box:
    """A node, a topic or a service: what is written in it, and how it is drawn."""

    def __init__(self, name: str, caption: str, tone: str, *, is_hub: bool, warning: str) -> None:
        self.name = _cut(name)
        self.caption = _cut(caption)
        self.tone = tone
        self.is_hub = is_hub
        self.warning = _cut(warning)
        self.rows = [row for row in (self.name, self.caption, self.warning) if row]
        self.width = max(map(len, self.rows)) + 4
        self.height = len(self.rows) + 2

    def draw(self, sheet: _Sheet, x: int, y: int) -> None:
        corners = "╭╮╰╯" if self.is_hub else "┌┐└┘"
        inner = self.width - 2
        sheet.put(x, y, corners[0] + "─" * inner + corners[1], self.tone)
        for number, row in enumerate(self.rows, 1):
            sheet.put(x, y + number, "│", self.tone)
            tone = "strong" if number == 1 else "warning" if row == self.warning else "quiet"
            sheet.put(x + 1, y + number, f" {row:<{inner - 2}} ", tone)
            sheet.put(x + self.width - 1, y + number, "│", self.tone)
        sheet.put(x, y + self.height - 1, corners[2] + "─" * inner + corners[3], self.tone)


def _cut(text: str) -> str:
    text = text if text.isprintable() else ascii(text)[1:-1]
    return text if len(text) <= _WIDEST else f"{text[: _WIDEST - 1]}…"


def drawn(graph: Graph) -> Lines:
    """Draw a graph, from left to right; parts that do not hang together below each other."""
    boxes, links = _boxes_and_links(graph)
    if not boxes:
        return ((Piece(" nothing to draw yet", "quiet"),),)
    if len(boxes) > MOST_BOXES:
        text = f" {len(boxes)} boxes are too many for a picture; the panels list them"
        return ((Piece(text, "quiet"),),)
    hubs = frozenset(number for number, box in enumerate(boxes) if box.is_hub)
    sheet = _Sheet()
    top = 0
    for part in components(len(boxes), links):
        inside = set(part)
        own = [link for link in links if link.tail in inside]
        top = _draw_part(sheet, top, boxes, columns_of(part, own, hubs)) + 1
    return sheet.lines()


def _boxes_and_links(graph: Graph) -> tuple[list[_Box], list[Link]]:
    boxes: list[_Box] = []
    links: dict[Link, None] = {}
    numbers: dict[str, int] = {}
    for node in graph.nodes:
        numbers[node.variable] = len(boxes)
        caption = node.file.name if node.file is not None else node.library or ""
        boxes.append(_Box(node.name, caption, "primary", is_hub=False, warning=""))
    for topic in graph.topics:
        hub = len(boxes)
        warning = "" if topic.missing is None else f"no {topic.missing.value}"
        kind = topic.type.name if topic.type is not None else "type unknown"
        boxes.append(_Box(topic.name, kind, "success", is_hub=True, warning=warning))
        for publisher in topic.publishers:
            links[Link(numbers[publisher.node.variable], hub)] = None
        for subscriber in topic.subscribers:
            links[Link(hub, numbers[subscriber.node.variable])] = None
    for service in graph.services:
        hub = len(boxes)
        warning = "" if service.missing is None else f"no {service.missing.value}"
        kind = service.type.name if service.type is not None else "type unknown"
        boxes.append(_Box(service.name, kind, "warning", is_hub=True, warning=warning))
        for client in service.clients:
            links[Link(numbers[client.node.variable], hub)] = None
        for provider in service.providers:
            links[Link(hub, numbers[provider.node.variable])] = None
    return boxes, list(links)


def _draw_part(sheet: _Sheet, top: int, boxes: list[_Box], columns: Columns) -> int:
    """Draw what hangs together, and return the row below it."""
    order = ordered(columns)
    row_of = _rows(order, boxes)
    rows: dict[int, int] = {}
    starts: list[int] = []
    x = 1
    widths = [
        max((boxes[item].width for item in column if item >= 0), default=1) for column in order
    ]
    gaps = _gaps(order, columns)
    for width, gap in zip(widths, [*gaps, 0], strict=True):
        starts.append(x)
        x += width + gap
    for number, column in enumerate(order):
        for item in column:
            if item >= 0:
                box = boxes[item]
                at = starts[number] + (widths[number] - box.width) // 2
                box.draw(sheet, at, top + row_of[item])
                rows[item] = top + row_of[item] + 1
            else:
                rows[item] = top + row_of[item]
    _draw_links(sheet, boxes, columns, rows, starts, widths, gaps)
    return max(
        top + row_of[item] + (boxes[item].height if item >= 0 else 1)
        for column in order
        for item in column
    )


def _rows(order: list[list[int]], boxes: list[_Box]) -> dict[int, int]:
    """Return the first row of each item: columns are centred beside the highest one."""

    def height(item: int) -> int:
        return boxes[item].height if item >= 0 else 1

    heights = [sum(height(item) + 1 for item in column) - 1 for column in order]
    highest = max(heights)
    row_of = {}
    for column, total in zip(order, heights, strict=True):
        row = (highest - total) // 2
        for item in column:
            row_of[item] = row
            row += height(item) + 1
    return row_of


def _gaps(order: list[list[int]], columns: Columns) -> list[int]:
    """Return how far columns are apart: room for each line to turn in a track of its own."""
    gaps = []
    for number in range(len(order) - 1):
        left = set(order[number])
        tails = {one for one, _ in columns.segments if one in left}
        gaps.append(max(5, 2 * len(tails) + 3))
    return gaps


def _draw_links(
    sheet: _Sheet,
    boxes: list[_Box],
    columns: Columns,
    rows: dict[int, int],
    starts: list[int],
    widths: list[int],
    gaps: list[int],
) -> None:
    strokes: dict[tuple[int, int], int] = {}
    arrows: dict[tuple[int, int], str] = {}
    heads = {(route[-2], route[-1]) for link, route in columns.routes.items()
             if link not in columns.reversed}  # fmt: skip
    tails = {(route[0], route[1]) for link, route in columns.routes.items()
             if link in columns.reversed}  # fmt: skip
    tracks: dict[int, int] = {}
    used: dict[int, int] = {}
    for left, right in sorted(columns.segments, key=lambda pair: rows[pair[0]]):
        column = columns.column_of[left]
        if left not in tracks:
            tracks[left] = used.get(column, 0)
            used[column] = tracks[left] + 1
        turn = starts[column] + widths[column] + 1 + 2 * tracks[left]
        begin = _edge(left, boxes, starts[column], widths[column], right_side=True)
        end = _edge(right, boxes, starts[column + 1], widths[column + 1], right_side=False)
        _stroke(strokes, begin, turn, rows[left], rows[right], end)
        if (left, right) in heads and right >= 0:
            arrows[end - 1, rows[right]] = "▶"
        if (left, right) in tails and left >= 0:
            arrows[begin, rows[left]] = "◀"
    for (x, y), directions in strokes.items():
        sheet.put(x, y, arrows.get((x, y)) or _LINES[directions], "dim")
    for (x, y), arrow in arrows.items():
        sheet.put(x, y, arrow, "accent")


def _edge(item: int, boxes: list[_Box], start: int, width: int, *, right_side: bool) -> int:
    """Return where a line leaves an item to the right, or the cell before which it ends."""
    if item < 0:
        return start
    own = boxes[item].width
    at = start + (width - own) // 2
    return at + own if right_side else at


def _stroke(
    strokes: dict[tuple[int, int], int], begin: int, turn: int, row: int, other: int, end: int
) -> None:
    def add(x: int, y: int, directions: int) -> None:
        strokes[x, y] = strokes.get((x, y), 0) | directions

    for x in range(begin, turn):
        add(x, row, _LEFT | _RIGHT)
    add(turn, row, _LEFT)
    if row == other:
        add(turn, row, _RIGHT)
    else:
        down = other > row
        add(turn, row, _DOWN if down else _UP)
        low, high = sorted((row, other))
        for y in range(low + 1, high):
            add(turn, y, _UP | _DOWN)
        add(turn, other, (_UP if down else _DOWN) | _RIGHT)
    for x in range(turn + 1, end):
        add(x, other, _LEFT | _RIGHT)
