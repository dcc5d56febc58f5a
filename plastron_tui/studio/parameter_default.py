"""Where a program says which value a parameter has that none is set for."""

from __future__ import annotations

from collections.abc import Container

from plastron_tui.diagnostics import Span
from plastron_tui.language.statements import HasParameter, NoLongerHasParameter

from .analysis import Analysis


def default_span(analysis: Analysis, node: str, parameter: str) -> Span | None:
    """Return where the default of a running node's parameter stands, None for nowhere.

    Args:
        analysis: what the program means.
        node: the full name of the node that runs; a launch file may have given it a namespace.
        parameter: the parameter's name.
    """
    last = node.rpartition("/")[2]
    nodes = [each.variable for each in analysis.workspace.nodes.values() if each.name == last]
    found = _last_of(nodes, parameter, analysis)
    return None if found is None else found.span_of("default")


def _last_of(nodes: Container[str], parameter: str, analysis: Analysis) -> HasParameter | None:
    """Return the statement that gives a node a parameter, if none takes it away again."""
    found = None
    for each in analysis.program.statements:
        match each:
            case HasParameter() if each.node in nodes and each.parameter == parameter:
                found = each
            case NoLongerHasParameter() if each.node in nodes and each.parameter == parameter:
                found = None
    return found
