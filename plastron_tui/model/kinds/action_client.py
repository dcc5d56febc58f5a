"""Action clients: tasks that a node has others do."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.diagnostics import Span
from plastron_tui.language.statements import SendsGoal
from plastron_tui.ros.interfaces import InterfaceKind, InterfaceName

from .computed import check_computed

if TYPE_CHECKING:
    from ..run import Run
    from ..values import MessageValue


class ActionClient(NamedTuple):
    """An action that a node has done, with the goals that it sends, in order."""

    name: str
    type: InterfaceName | None
    goals: tuple[MessageValue, ...] = ()
    span: Span | None = None


def send_goal(run: Run, statement: SendsGoal) -> None:
    """Let a node send one more goal to an action."""
    node = run.checks.node(statement)
    name, type_ = run.interface(statement, node, "action", InterfaceKind.ACTION)
    goal = run.types.fit(statement, type_, run.checks.version_of(node))
    check_computed(run, statement, "input", node, goal)
    client = node.of(ActionClient).get(name)
    goals = (goal,) if client is None else (*client.goals, goal)
    span = statement.span if client is None else client.span
    run.add(statement, node, ActionClient(name, type_.name, goals, span))
