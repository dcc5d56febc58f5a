"""The graph of a program as a picture, in the size that fits where it is shown."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, NamedTuple

from rich.cells import cell_len

from plastron_tui.diagnostics import Span

from .drawing import DETAILS, Label, Plan
from .entry import HUBS, SIGNS, Entry, Subject
from .styles import Line, Lines, Piece

if TYPE_CHECKING:
    from plastron_tui.model.graph import Graph, Hub
    from plastron_tui.output.graphs.layers import Columns, Link
    from plastron_tui.output.graphs.wiring import Place

MOST_BOXES = 400
"""With more boxes than this nobody reads the picture."""

_MOST_CELLS = 400_000
"""A picture of more cells takes seconds to draw, and shows nothing but lines."""

_APART = 3
"""Columns between parts that stand beside each other."""

Parts = tuple[tuple["Columns", list[list[int]]], ...]
"""What hangs together: boxes in columns, and the order within the columns."""


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


@dataclass(frozen=True)
class Picture:
    """Boxes and what joins them, which can be drawn in several sizes.

    Attributes:
        entries: what each box is about, with its first statement.
        labels: what each box says; behind those of the entries, boxes that stand for several.
        parts: what hangs together, laid out.
        folds: what each of the boxes stands for that stand for several.
        folded: what hangs together, laid out with those boxes, for where there is little room.
        statements: where the statements are that are about a box, and which, in order.
        note: what is said in the place of a picture.
    """

    entries: tuple[Entry, ...] = ()
    labels: tuple[Label, ...] = ()
    parts: Parts = ()
    folds: Mapping[int, tuple[int, ...]] = field(default_factory=dict)
    folded: Parts = ()
    statements: tuple[tuple[Span, int], ...] = ()
    note: str = ""
    _fitted: dict[Size, Fitted] = field(default_factory=dict, compare=False, repr=False)
    _plans: dict[tuple[int, int, bool], list[Plan]] = field(
        default_factory=dict, compare=False, repr=False
    )

    def at(self, offset: int) -> int | None:
        """Return the box that the statement at an offset is about."""
        place = bisect_right(self.statements, offset, key=lambda one: one[0].start) - 1
        if place < 0:
            return None
        span, box = self.statements[place]
        return box if offset <= span.end else None

    def fitted(self, size: Size) -> Fitted:
        """Draw it as large as fits, or in the detail that is asked for; once for each size.

        Where it fits in no detail, one box stands for many nodes at a topic that are nowhere else.
        What then fits in none is as large as fits at least from side to side.
        """
        found = self._fitted.get(size)
        if found is None:
            found = self._fitted[size] = self._draw(size)
        return found

    def is_fitted(self, size: Size) -> bool:
        """Tell whether it is drawn in a size."""
        return size in self._fitted

    def _draw(self, size: Size) -> Fitted:
        if self.note:
            return _noted(self.note)
        if size.detail is not None:
            return self._packed(size.detail, size.width, is_folded=False)
        best, fits = self._best(size, is_folded=False)
        is_folded = not fits and bool(self.folds)
        if is_folded:
            best, _ = self._best(size, is_folded=True)
        return self._packed(best, size.width, is_folded=is_folded)

    def _best(self, size: Size, *, is_folded: bool) -> tuple[int, bool]:
        """Return the detail to draw in, and whether the picture fits then."""
        best = None
        for detail in range(len(DETAILS)):
            plans = self._planned(detail, size.width, is_folded=is_folded)
            least = [plan.least for plan in plans]
            if any(width >= size.width for width, _ in least):
                continue
            if best is not None and any(height > size.height for _, height in least):
                continue
            shelves = _shelves(plans, size.width)
            if max(map(_width, shelves)) <= size.width:
                best = detail if best is None else best
                if _height(shelves, detail) <= size.height:
                    return detail, True
        return len(DETAILS) - 1 if best is None else best, False

    def _packed(self, detail: int, width: int, *, is_folded: bool) -> Fitted:
        shelves = _shelves(self._planned(detail, width, is_folded=is_folded), width)
        if max(map(_width, shelves)) * _height(shelves, detail) > _MOST_CELLS:
            return _noted(f"{len(self.entries)} boxes are too far apart; the panels list them")
        made = _packed(shelves, detail)
        places = dict(made.places)
        for box, members in self.folds.items() if is_folded else ():
            place = places.pop(box)
            places.update(dict.fromkeys(members, place))
        return Fitted(made.lines, made.width, places, detail)

    def _planned(self, detail: int, width: int, *, is_folded: bool) -> list[Plan]:
        plans = self._plans.get((detail, width, is_folded))
        if plans is None:
            parts = self.folded if is_folded else self.parts
            plans = [
                Plan(self.labels, columns, order, DETAILS[detail], width - 1)
                for columns, order in parts
            ]
            self._plans[detail, width, is_folded] = plans
        return plans


def _noted(note: str) -> Fitted:
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


def picture_of(graph: Graph) -> Picture:
    """Lay a graph out, from left to right."""
    # A start of the studio does without.
    from plastron_tui.output.graphs.folding import folded_links, folds_of

    boxes = _Boxes(graph)
    count = len(boxes.labels)
    if not count:
        return Picture(note="nothing to draw yet")
    if count > MOST_BOXES:
        return Picture(note=f"{count} boxes are too many for a picture; the panels list them")
    links = list(boxes.links)
    hubs = frozenset(number for number, label in enumerate(boxes.labels) if label.is_hub)
    folds = folds_of(links, hubs)
    folded: Parts = ()
    if folds:
        hidden = {member for fold in folds for member in fold.members}
        shown = [box for box in range(count + len(folds)) if box not in hidden]
        folded = _parts(shown, folded_links(links, folds, count), hubs)
    for fold in folds:
        more = f"and {len(fold.members)} more"
        boxes.labels.append(Label(more, "", "primary", is_hub=False))
    return Picture(
        tuple(boxes.entries),
        tuple(boxes.labels),
        _parts(range(count), links, hubs),
        {at: fold.members for at, fold in enumerate(folds, count)},
        folded,
        tuple(sorted(boxes.statements)),
    )


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


class _Boxes:
    """The boxes of a graph, the links between them, and the statements about each."""

    def __init__(self, graph: Graph) -> None:
        self.labels: list[Label] = []
        self.entries: list[Entry] = []
        self.links: dict[Link, None] = {}
        self.statements: list[tuple[Span, int]] = []
        numbers: dict[str, int] = {}
        for node in graph.nodes:
            at = numbers[node.variable] = len(self.labels)
            caption = node.file.name if node.file is not None else node.library or ""
            self.labels.append(Label(node.name, caption, "primary", is_hub=False))
            self.statements.append((node.span, at))
            self.entries.append(
                Entry(
                    f"node {node.variable}", node.name, caption, span=node.span,
                    subject=Subject.NODE, node=node.variable, name=node.variable,
                )
            )  # fmt: skip
        for hub in graph.hubs:
            self._add_hub(hub, numbers)

    def _add_hub(self, hub: Hub, numbers: dict[str, int]) -> None:
        subject = HUBS[hub.interface]
        _, tone = SIGNS[subject]
        at = len(self.labels)
        warning = "" if hub.missing is None else f"no {hub.missing.facts.role}"
        kind = hub.type.name if hub.type is not None else "type unknown"
        self.labels.append(Label(hub.name, kind, tone, is_hub=True, warning=warning))
        from plastron_tui.output.graphs.layers import Link

        self.links.update({Link(numbers[end.node.variable], at): None for end in hub.tails})
        self.links.update({Link(at, numbers[end.node.variable]): None for end in hub.heads})
        spans = {end.span for end in hub.ends}
        spans.update(sent.span for end in hub.tails for sent in end.sendings)
        written = sorted(span for span in spans if span is not None)
        self.statements += [(span, at) for span in written]
        self.entries.append(
            Entry(
                f"{subject.value} {hub.name}", hub.name, kind, warning=warning,
                span=written[0] if written else None, subject=subject, name=hub.name,
            )
        )  # fmt: skip
