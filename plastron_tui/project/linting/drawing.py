"""A workspace that was read, as something that graphs show."""

from __future__ import annotations

from pathlib import Path

from plastron_tui.diagnostics import Span
from plastron_tui.lint.runs import RunningNode, runs_of
from plastron_tui.lint.tree import SourceTree
from plastron_tui.model.loading import add_found
from plastron_tui.model.source import FileSet, SourceUnit
from plastron_tui.model.workspace import Node, Workspace


def drawn(tree: SourceTree, launch: Path | None = None) -> Workspace:
    """Return the nodes of a workspace, with the names that its launch files give them.

    What several launch files start under one name is there once, as is what none starts. Tests
    are no part of the robot.

    Args:
        tree: the workspace.
        launch: the launch file whose nodes are meant alone, None for those of all and the others.
    """
    whole = Workspace()
    seen: set[tuple[object, ...]] = set()
    runs = runs_of(tree)
    if launch is not None:
        runs = tuple(run for run in runs if run.launch is not None and run.launch.path == launch)
    for run in runs:
        for running in run.nodes:
            key = (running.unit.path, running.node.span, running.full_name, running.names)
            if key not in seen and not running.unit.is_test:
                seen.add(key)
                node = _node(running, whole)
                whole.nodes[node.variable] = node
    return whole


def _node(running: RunningNode, whole: Workspace) -> Node:
    unit, name = running.unit, running.name or running.unit.path.stem
    full = running.names.full_node(name)
    variable, count = full.lstrip("/"), 1
    while variable in whole.nodes:
        count += 1
        variable = f"{full.lstrip('/')}_{count}"
    source = SourceUnit(
        unit.path, FileSet.single(unit.path.suffix, b""), unit.library, (running.node,)
    )
    shown = full if running.names.namespace else name
    node = Node(
        shown, variable, Span(0, 0), unit.library, source, is_managed=running.node.is_managed
    )
    for endpoint in running.node.endpoints:
        if endpoint.label is not None and endpoint.kind.facts.interface is not None:
            add_found(node, endpoint, running.names.resolved(name, endpoint.label))
    return node
