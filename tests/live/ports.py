"""Bringing a file of the other client library to that of a graph."""

from __future__ import annotations

from pathlib import Path

from graph import Graph
from processes import Process, plastron


def run_ported(graph: Graph, file: Path, text: str) -> Process:
    """Bring a file of the other client library to that of the graph, and start what comes out."""
    file.write_text(text)
    program = file.with_name("port.plastron")
    program.write_text(f"load {file.stem} as node\ngenerate_node node using {graph.target}\n")
    done = plastron("generate", program)
    assert done.returncode == 0, done.stderr
    assert "port-by-hand" not in done.stderr
    return graph.run(file.parent / "output" / file.name)
