"""What a program is told that writes no file."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plastron_tui.diagnostics import Diagnostic, Severity, codes

if TYPE_CHECKING:
    from plastron_tui.model.workspace import Workspace


def nothing_to_generate(workspace: Workspace) -> Diagnostic:
    """Return the warning for a program that makes no file."""
    help_ = "end it with `generate_node` and the variable of a node, or `generate_package`, say"
    if workspace.robots and not workspace.nodes:
        help_ = f"end it with `generate_robot {next(iter(workspace.robots))}`"
    message = "the program generates nothing"
    return Diagnostic(codes.NOTHING_TO_GENERATE, message, help=help_, severity=Severity.WARNING)
