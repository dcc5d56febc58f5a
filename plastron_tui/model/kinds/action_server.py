"""Action servers: tasks that a node does for others."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.diagnostics import Span, codes
from plastron_tui.language.statements import ProvidesAction
from plastron_tui.ros.interfaces import InterfaceKind, InterfaceName
from plastron_tui.ros.names import spelled

if TYPE_CHECKING:
    from ..run import Run
    from ..workspace import Node


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
    check_unserved(run, statement, node)
    check_executor(run, statement, node, type_.name)
    run.add(statement, node, ActionServer(name, type_.name, statement.function, statement.span))


def check_unserved(run: Run, statement: ProvidesAction, node: Node) -> None:
    """Check that a node does not provide an action yet."""
    if spelled(statement.action) in node.of(ActionServer):
        what = f"`{node.variable}` provides the action"
        raise run.checks.exists_already(statement, "action", node, codes.ALREADY_SERVING, what)


def check_executor(
    run: Run, statement: ProvidesAction, node: Node, type_: InterfaceName | None
) -> None:
    """Check that a function may do the tasks of a type, None for one that is not known."""
    from . import EndpointKind  # which imports this file

    run.checks.function(statement, node, EndpointKind.ACTION_SERVER, type_)
