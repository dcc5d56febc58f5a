"""What a program is told that writes no file."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plastron_tui.diagnostics import Diagnostic, Severity, codes

if TYPE_CHECKING:
    from plastron_tui.model.workspace import Workspace


def missing_statements(workspace: Workspace) -> tuple[str, ...]:
    """Return the statements that would write what a program makes; none where it makes nothing.

    A node that does nothing is left out, unless no other one is there; robots count where there
    are no nodes.
    """
    nodes = workspace.nodes
    busy = [name for name, node in nodes.items() if not node.is_idle]
    if nodes:
        return tuple(f"generate_node {name}" for name in busy or nodes)
    return tuple(f"generate_robot {name}" for name in workspace.robots)


def nothing_to_generate(workspace: Workspace) -> Diagnostic:
    """Return the warning for a program that makes no file."""
    message = "the program generates nothing"
    return Diagnostic(
        codes.NOTHING_TO_GENERATE,
        message,
        help=help_to_generate(workspace),
        severity=Severity.WARNING,
    )


def help_to_generate(workspace: Workspace) -> str:
    """Return what to write so that a program makes a file."""
    lines = missing_statements(workspace)
    if lines:
        return f"end it with `{lines[0]}`"
    return "end it with `generate_node` and the variable of a node, or `generate_package`, say"
