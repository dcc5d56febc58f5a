"""The graph as a listing for a terminal."""

from __future__ import annotations

import textwrap
from collections.abc import Iterable, Iterator

from plastron_tui.diagnostics.terminal import visible, width
from plastron_tui.model.graph import NOUNS, Graph, Hub

from .captions import ends_of, missing_text, node_text, type_text
from .robots.listing import robot_rows, robot_title

_WIDTH = 100
_MOST_PADDED = 40


def render(graph: Graph) -> str:
    """Return the nodes, then each topic and each service with the nodes that meet there.

    Then come the robots as trees: each link with the joint that holds it.

    Lines have at most 100 characters where the names allow it; there are no colour codes.
    """
    sections = [
        _section("nodes", _columns((visible(node.name), node_text(node)) for node in graph.nodes)),
        *(_section(f"{NOUNS[at]}s", _hubs(hubs)) for at, hubs in graph.at.items()),
        *(_section(robot_title(robot), _columns(robot_rows(robot))) for robot in graph.robots),
    ]
    return "\n".join(section for section in sections if section) or "nothing here yet\n"


def _section(title: str, lines: Iterable[str]) -> str:
    body = "".join(f"  {line}\n" for line in lines)
    return f"{title}\n{body}" if body else ""


def _hubs(hubs: Iterable[Hub]) -> Iterator[str]:
    for hub in hubs:
        head = f"{visible(hub.name)}  {type_text(hub.types)}"
        missing = missing_text(hub.missing)
        yield f"{head}  ({missing})" if missing else head
        rows = [(visible(node.name), verb, detail) for node, verb, detail in ends_of(hub)]
        yield from (f"  {line}" for line in _columns(rows))


def _columns(rows: Iterable[tuple[str, ...]]) -> Iterator[str]:
    """Yield the rows with their cells below each other; the last cell wraps below itself."""
    table = list(rows)
    if not table:
        return
    widths = [
        # One very long name does not push everybody else's cells away.
        max((width(row[at]) for row in table if width(row[at]) <= _MOST_PADDED), default=0)
        for at in range(len(table[0]) - 1)
    ]
    for row in table:
        *cells, last = row
        padded = zip(cells, widths, strict=True)
        head = "".join(cell + " " * (most - width(cell) + 2) for cell, most in padded)
        room = max(_WIDTH - 4 - width(head), 24)
        wrapped = textwrap.wrap(last, room, break_long_words=False, break_on_hyphens=False)
        yield (head + "".join(wrapped[:1])).rstrip()
        yield from (" " * width(head) + more for more in wrapped[1:])
