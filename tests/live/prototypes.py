"""Nodes that show what is to be generated, one for each client library."""

from __future__ import annotations

from pathlib import Path

from graph import Graph

PROTOTYPES = Path(__file__).parents[1] / "nodes" / "prototypes"


def prototype(graph: Graph, name: str) -> Path:
    """Return the file of a node for the graph's client library."""
    return PROTOTYPES / graph.target / f"{name}.py"
