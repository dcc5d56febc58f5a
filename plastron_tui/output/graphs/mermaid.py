"""The graph as a Mermaid flowchart, which GitHub and GitLab draw in a Markdown file."""

from __future__ import annotations

from collections.abc import Iterator

from plastron_tui.diagnostics.terminal import visible
from plastron_tui.model.graph import Graph

from .captions import missing_text, node_text, topic_text, type_text
from .identifiers import Role, edges_of

_PLAIN = frozenset(" /_-.,()")
_ARROWS = {
    Role.PUBLISHES: "-->",
    Role.LISTENS: "-->",
    Role.CALLS: "-. calls .->",
    Role.PROVIDES: "-.->",
}


def render(graph: Graph) -> str:
    """Return a flowchart: nodes are boxes, topics rounded, services hexagons."""
    return "".join(f"{line}\n" for line in _lines(graph))


def quoted(*lines: str) -> str:
    """Return a label in double quotes, its lines broken by `<br/>`.

    All but letters, digits and a few marks is written as Mermaid's `#number;`, so that no name
    can close the label, start markup, or be taken for a directive or a comment.
    """
    return '"' + "<br/>".join(_escaped(visible(line)) for line in lines if line) + '"'


def _escaped(text: str) -> str:
    return "".join(char if char.isalnum() or char in _PLAIN else f"#{ord(char)};" for char in text)


def _lines(graph: Graph) -> Iterator[str]:
    yield "flowchart LR"
    for number, node in enumerate(graph.nodes):
        yield f"  n{number}[{quoted(node.name, node_text(node))}]:::node"
    for number, topic in enumerate(graph.topics):
        style = "missing" if topic.missing else "topic"
        label = quoted(topic.name, topic_text(topic), missing_text(topic.missing))
        yield f"  t{number}([{label}]):::{style}"
    for number, service in enumerate(graph.services):
        style = "missing" if service.missing else "service"
        label = quoted(service.name, type_text(service.types), missing_text(service.missing))
        yield f"  s{number}{{{{{label}}}}}:::{style}"
    for edge in edges_of(graph):
        start, end = edge.ends
        yield f"  {start} {_ARROWS[edge.role]} {end}"
    yield "  classDef node fill:#dbe7fb,stroke:#3b6fc4,color:#12233f"
    yield "  classDef topic fill:#d9f0e3,stroke:#2c8a5a,color:#0f2c1e"
    yield "  classDef service fill:#fbe6cf,stroke:#b8691b,color:#3b2208"
    yield "  classDef missing fill:#fff,stroke:#c0392b,color:#5c1710,stroke-dasharray:5 4"
