"""The graph as a Mermaid flowchart, which GitHub and GitLab draw in a Markdown file."""

from __future__ import annotations

from collections.abc import Iterator

from plastron_tui.diagnostics.terminal import visible
from plastron_tui.model.graph import Graph, GraphRobot
from plastron_tui.model.kinds import EndpointKind
from plastron_tui.ros.interfaces import InterfaceKind

from .captions import hub_text, missing_text, node_text
from .identifiers import edges_of, identified
from .robots.captions import joint_text, link_text
from .robots.listing import robot_joints, robot_links, robot_title

_PLAIN = frozenset(" /_-.,()")
_SHAPES = {
    InterfaceKind.MESSAGE: ("([", "])"),
    InterfaceKind.SERVICE: ("{{", "}}"),
    InterfaceKind.ACTION: ("[[", "]]"),
}


def render(graph: Graph) -> str:
    """Return a flowchart: nodes are boxes, topics rounded, services hexagons, actions barred."""
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
    for identifier, hub in identified(graph):
        left, right = _SHAPES[hub.interface]
        label = quoted(hub.name, hub_text(hub), missing_text(hub.missing))
        yield f"  {identifier}{left}{label}{right}:::{'missing' if hub.missing else hub.noun}"
    for edge in edges_of(graph):
        start, end = edge.ends
        yield f"  {start} {_arrow(edge.kind)} {end}"
    for at, robot in enumerate(graph.robots):
        yield from _robot(f"r{at}", robot)
    yield "  classDef node fill:#dbe7fb,stroke:#3b6fc4,color:#12233f"
    yield "  classDef topic fill:#d9f0e3,stroke:#2c8a5a,color:#0f2c1e"
    yield "  classDef service fill:#fbe6cf,stroke:#b8691b,color:#3b2208"
    yield "  classDef action fill:#e9e0fa,stroke:#7a52c7,color:#291650"
    yield "  classDef missing fill:#fff,stroke:#c0392b,color:#5c1710,stroke-dasharray:5 4"
    if graph.robots:
        yield "  classDef link fill:#e9edf2,stroke:#5b6675,color:#1d2733"


def _robot(identifier: str, robot: GraphRobot) -> Iterator[str]:
    """Yield a robot as a subgraph: links are boxes, and what joins them its joints."""
    yield f"  subgraph {identifier}[{quoted(robot_title(robot))}]"
    for name, link in robot_links(identifier, robot):
        yield f"    {name}[{quoted(link.name, link_text(link))}]:::link"
    for joint in robot_joints(identifier, robot):
        label = quoted(joint.joint.name, joint_text(joint.joint))
        line = f"== {label} ==>" if joint.moves else f"-- {label} -->"
        yield f"    {joint.parent} {line} {joint.child}"
    yield "  end"


def _arrow(kind: EndpointKind) -> str:
    """Return the arrow of an edge: of messages it is drawn through, of calls dashed."""
    if kind.facts.interface is InterfaceKind.MESSAGE:
        return "-->"
    return f"-. {kind.facts.does} .->" if kind.facts.sends else "-.->"
