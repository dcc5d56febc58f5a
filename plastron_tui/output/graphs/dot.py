"""The graph in Graphviz's language."""

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

_NODE = 'shape=box, style="rounded,filled", fillcolor="#dbe7fb", color="#3b6fc4"'
_LINK = 'shape=box, style=filled, fillcolor="#e9edf2", color="#5b6675"'
_HUBS = {
    InterfaceKind.MESSAGE: 'shape=ellipse, style=filled, fillcolor="#d9f0e3", color="#2c8a5a"',
    InterfaceKind.SERVICE: 'shape=hexagon, style=filled, fillcolor="#fbe6cf", color="#b8691b"',
    InterfaceKind.ACTION: 'shape=octagon, style=filled, fillcolor="#e9e0fa", color="#7a52c7"',
}
_MISSING = 'style="filled,dashed", color="#c0392b"'


def render(graph: Graph) -> str:
    """Return a digraph: nodes are boxes, topics ellipses, services hexagons, actions octagons."""
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
    for identifier, hub in identified(graph):
        label = quoted(hub.name, hub_text(hub), missing_text(hub.missing))
        # A later attribute of the same name wins.
        marked = "" if hub.missing is None else f", {_MISSING}"
        yield f"  {identifier} [label={label}, {_HUBS[hub.interface]}{marked}];"
    for edge in edges_of(graph):
        start, end = edge.ends
        yield f"  {start} -> {end}{_style(edge.kind)};"
    for at, robot in enumerate(graph.robots):
        yield from _robot(f"r{at}", robot)
    yield "}"


def _robot(identifier: str, robot: GraphRobot) -> Iterator[str]:
    """Yield a robot as a cluster: links are boxes, and what joins them its joints."""
    yield f"  subgraph cluster_{identifier} {{"
    yield f"    label={quoted(robot_title(robot))};"
    for name, link in robot_links(identifier, robot):
        yield f"    {name} [label={quoted(link.name, link_text(link))}, {_LINK}];"
    for joint in robot_joints(identifier, robot):
        fixed = "" if joint.moves else ", style=dashed"
        label = quoted(joint.joint.name, joint_text(joint.joint))
        yield f"    {joint.parent} -> {joint.child} [label={label}{fixed}];"
    yield "  }"


def _style(kind: EndpointKind) -> str:
    """Return the style of an edge: of messages it is drawn through, of calls dashed."""
    if kind.facts.interface is InterfaceKind.MESSAGE:
        return ""
    label = f', label="{kind.facts.does}"' if kind.facts.sends else ""
    return f" [style=dashed{label}]"
