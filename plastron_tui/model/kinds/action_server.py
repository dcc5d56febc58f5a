"""Action servers: tasks that a node does for others."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.diagnostics import Span
from plastron_tui.language.statements import ProvidesAction
from plastron_tui.ros.interfaces import InterfaceKind, InterfaceName

if TYPE_CHECKING:
    from ..run import Run


class ActionServer(NamedTuple):
    """An action that a node provides; without a `callback` the target names one."""

    name: str
    type: InterfaceName | None
    callback: str | None = None
    span: Span | None = None


def provide_action(run: Run, statement: ProvidesAction) -> None:
    """Let a node provide an action."""
    node = run.checks.node(statement)
    name, type_ = run.interface(statement, node, "action", InterfaceKind.ACTION)
    run.checks.absent(statement, node)
    run.checks.function(statement, node, type_.name)
    run.add(statement, node, ActionServer(name, type_.name, statement.function, statement.span))
