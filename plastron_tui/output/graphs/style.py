"""Colours, sizes and the legend of the SVG picture."""

from __future__ import annotations

from collections.abc import Iterator

from plastron_tui.model.graph import Graph
from plastron_tui.ros.interfaces import InterfaceKind

from .widths import FONT, text_width

ARROW = 8.0
MARGIN = 28.0
LEGEND_HEIGHT = 34.0
_LEGEND_SIZE = 10.5

# Rules are written out for both schemes: not every viewer knows custom properties.
STYLE = f"""<style>
text{{font-family:{FONT};text-anchor:middle}}
.name{{font-size:13px;fill:#1d2733}} .bold{{font-weight:600}}
.caption,.key{{font-size:10.5px;fill:#5d6b7a}} .key{{text-anchor:start}}
.alarm{{font-size:10.5px;fill:#b3362a}}
.paper{{fill:#fbfcfd}}
.shape{{stroke-width:1.4}}
.node .shape{{fill:#e3ecfa;stroke:#4a78c2}}
.topic .shape{{fill:#def3e7;stroke:#38946a}}
.service .shape{{fill:#fdebd3;stroke:#c07a2b}}
.action .shape{{fill:#ece4fb;stroke:#7a52c7}}
.missing .shape{{stroke:#c9473a;stroke-dasharray:5 3.5}}
.message,.request,.response,.goal,.result{{fill:none;stroke-width:1.5}}
.message{{stroke:#5fa886}} .message-head{{fill:#38946a}}
.request{{stroke:#cf9550}} .request-head{{fill:#c07a2b}}
.response{{stroke:#cf9550;stroke-dasharray:3 3}} .response-head{{fill:#c07a2b}}
.goal{{stroke:#9a7ad6}} .goal-head{{fill:#7a52c7}}
.result{{stroke:#9a7ad6;stroke-dasharray:3 3}} .result-head{{fill:#7a52c7}}
.edge:hover path{{stroke-width:2.6}}
@media (prefers-color-scheme:dark){{
.name{{fill:#e8edf3}} .caption,.key{{fill:#9dabba}} .alarm{{fill:#ff8f80}}
.paper{{fill:#161b22}}
.node .shape{{fill:#1d3154;stroke:#6c9be6}}
.topic .shape{{fill:#173c2c;stroke:#54bd8c}}
.service .shape{{fill:#463013;stroke:#e0a052}}
.action .shape{{fill:#33254f;stroke:#b08cf0}}
.missing .shape{{stroke:#ff7b6b}}
.message{{stroke:#4a9b75}} .message-head{{fill:#54bd8c}}
.request,.response{{stroke:#b9853f}} .request-head,.response-head{{fill:#e0a052}}
.goal,.result{{stroke:#8a6bc4}} .goal-head,.result-head{{fill:#b08cf0}}
}}
</style>"""


_PAIRS = {"calls": ("request", "response"), "goals": ("goal", "result")}


def number(value: float) -> str:
    """Return a length with at most one decimal."""
    return f"{value:.1f}".removesuffix(".0")


def _entries(graph: Graph) -> list[tuple[str, str]]:
    entries = []
    if graph.nodes:
        entries.append(("node", "node"))
    if graph.topics:
        entries.append(("topic", "topic"))
    if graph.services:
        entries += [("service", "service"), ("calls", "request and response")]
    if graph.at[InterfaceKind.ACTION]:
        entries += [("action", "action"), ("goals", "goal and result")]
    if any(hub.missing for hub in graph.hubs):
        entries.append(("missing", "nobody at the other end"))
    return entries or [("", "nothing here yet")]


def _advance(text: str) -> float:
    return 30.0 + text_width(text, _LEGEND_SIZE) + 16.0


def legend_width(graph: Graph) -> float:
    """Return the width of the legend."""
    return sum(_advance(text) for _, text in _entries(graph))


def legend(graph: Graph, top: float) -> Iterator[str]:
    """Yield the legend: what each shape in the picture is."""
    x = MARGIN
    yield '<g class="legend" aria-hidden="true">'
    for kind, text in _entries(graph):
        yield from _sample(kind, x, top + 8)
        yield f'<text class="key" x="{number(x + 30)}" y="{number(top + 12)}">{text}</text>'
        x += _advance(text)
    yield "</g>"


def _sample(kind: str, x: float, middle: float) -> Iterator[str]:
    left, top = number(x), number(middle - 6)
    if kind in _PAIRS:
        there, back = _PAIRS[kind]
        upper, lower = number(middle - 3), number(middle + 3)
        yield f'<path class="{there}" d="M{left} {upper}h22"/>'
        yield f'<path class="{back}" d="M{left} {lower}h22"/>'
    elif kind == "service":
        yield (
            f'<g class="service"><path class="shape" d="M{left} {number(middle)}'
            'l5 -6h12l5 6l-5 6h-12z"/></g>'
        )
    elif kind == "action":
        yield (
            f'<g class="action"><path class="shape" d="M{number(x + 4)} {top}'
            'h14l4 4v4l-4 4h-14l-4 -4v-4z"/></g>'
        )
    elif kind:
        shape = "topic missing" if kind == "missing" else kind
        radius = "3" if kind == "node" else "6"
        yield (
            f'<g class="{shape}"><rect class="shape" x="{left}" y="{top}" width="22" '
            f'height="12" rx="{radius}"/></g>'
        )
