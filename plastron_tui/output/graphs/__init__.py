"""The graph of a program, drawn in one of several formats.

A format is a module of this package that is named after it, with a `render(graph)` that returns
the whole document, its last newline included.
"""

from __future__ import annotations

from importlib import import_module

from plastron_tui.model.graph import Graph

FORMATS = ("text", "json", "mermaid", "dot", "svg")
"""Every format there is; the first is the default."""


def render(graph: Graph, format_: str) -> str:
    """Return the graph in one of `FORMATS`; raise ValueError for another."""
    if format_ not in FORMATS:
        raise ValueError(format_)
    # A module is loaded when it is first asked for: most commands draw nothing.
    text: str = import_module(f"{__name__}.{format_}").render(graph)
    return text
