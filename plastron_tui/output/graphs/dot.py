"""The graph in Graphviz's language."""

from __future__ import annotations

from collections.abc import Iterator

from plastron_tui.diagnostics.terminal import visible
from plastron_tui.model.graph import Graph, Missing

from .captions import missing_text, node_text, topic_text, type_text
from .identifiers import Role, edges_of

_NODE = 'shape=box, style="rounded,filled", fillcolor="#dbe7fb", color="#3b6fc4"'
_TOPIC = 'shape=ellipse, style=filled, fillcolor="#d9f0e3", color="#2c8a5a"'
_SERVICE = 'shape=hexagon, style=filled, fillcolor="#fbe6cf", color="#b8691b"'
_MISSING = 'style="filled,dashed", color="#c0392b"'
_EDGES = {
    Role.PUBLISHES: "",
    Role.LISTENS: "",
    Role.CALLS: ' [style=dashed, label="calls"]',
    Role.PROVIDES: " [style=dashed]",
}


def render(graph: Graph) -> str:
    """Return a digraph: nodes are boxes, topics ellipses, services hexagons."""
    return "".join(f"{line}\n" for line in _lines(graph))


def quoted(*lines: str) -> str:
    r"""Return a label in double quotes, its lines broken by `\n`.

    A label has escapes (`\N`, `\l`) and character entities of its own, beside the quotes of
    the language; so backslashes and ampersands are escaped as well.
    Source: graphviz.org, "The DOT Language" and "escString".
    """
    return '"' + "\\n".join(_escaped(visible(line)) for line in lines if line) + '"'


def _escaped(text: str) -> str:
    return text.replace("\\", "\\\\").replace('"', '\\"').replace("&", "&amp;")


def _lines(graph: Graph) -> Iterator[str]:
    yield "digraph ros {"
    yield '  graph [rankdir=LR, charset="UTF-8"];'
    yield '  node [fontname="Helvetica,Arial,sans-serif", fontsize=11];'
    yield '  edge [fontname="Helvetica,Arial,sans-serif", fontsize=9, color="#5b6675"];'
    for number, node in enumerate(graph.nodes):
        yield f"  n{number} [label={quoted(node.name, node_text(node))}, {_NODE}];"
    for number, topic in enumerate(graph.topics):
        label = quoted(topic.name, topic_text(topic), missing_text(topic.missing))
        yield f"  t{number} [label={label}, {_with_mark(_TOPIC, topic.missing)}];"
    for number, service in enumerate(graph.services):
        label = quoted(service.name, type_text(service.types), missing_text(service.missing))
        yield f"  s{number} [label={label}, {_with_mark(_SERVICE, service.missing)}];"
    for edge in edges_of(graph):
        start, end = edge.ends
        yield f"  {start} -> {end}{_EDGES[edge.role]};"
    yield "}"


def _with_mark(style: str, missing: Missing | None) -> str:
    # A later attribute of the same name wins.
    return style if missing is None else f"{style}, {_MISSING}"
