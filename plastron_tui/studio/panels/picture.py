"""The graph of a program as a picture, in the size that fits where it is shown."""

from __future__ import annotations

from bisect import bisect_right
from dataclasses import dataclass
from typing import TYPE_CHECKING

from plastron_tui.diagnostics import Span

from .drawing import Label
from .entry import Entry, Subject
from .entry_signs import HUBS, SIGNS
from .fitting import Drawing, Fitted, Size, drawing_of, noted

if TYPE_CHECKING:
    from plastron_tui.model.graph import Graph, Hub
    from plastron_tui.output.graphs.layers import Link

MOST_BOXES = 400
"""With more boxes than this nobody reads the picture."""


@dataclass(frozen=True)
class Picture:
    """A drawing, and what its boxes are about.

    Attributes:
        entries: what each box is about, with its first statement.
        statements: where the statements are that are about a box, and which, in order.
        drawing: the boxes and what joins them, None where there is none.
        note: what is said in the place of a picture.
    """

    entries: tuple[Entry, ...] = ()
    statements: tuple[tuple[Span, int], ...] = ()
    drawing: Drawing | None = None
    note: str = ""

    def at(self, offset: int) -> int | None:
        """Return the box that the statement at an offset is about."""
        place = bisect_right(self.statements, offset, key=lambda one: one[0].start) - 1
        if place < 0:
            return None
        span, box = self.statements[place]
        return box if offset <= span.end else None

    def fitted(self, size: Size) -> Fitted:
        """Draw it as large as fits, or in the detail that is asked for."""
        return noted(self.note) if self.drawing is None else self.drawing.fitted(size)

    def is_fitted(self, size: Size) -> bool:
        """Tell whether it is drawn in a size."""
        return bool(self.note) if self.drawing is None else self.drawing.is_fitted(size)


def picture_of(graph: Graph) -> Picture:
    """Lay a graph out, from left to right."""
    boxes = _Boxes(graph)
    count = len(boxes.labels)
    if not count:
        return Picture(note="nothing to draw yet")
    if count > MOST_BOXES:
        return Picture(note=f"{count} boxes are too many for a picture; the panels list them")
    return Picture(
        tuple(boxes.entries),
        tuple(sorted(boxes.statements)),
        drawing_of(tuple(boxes.labels), tuple(boxes.links)),
    )


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
