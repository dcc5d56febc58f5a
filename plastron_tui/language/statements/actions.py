"""The statements about actions."""

from __future__ import annotations

from ..declaration import SlotKind, Statement, slot, statement
from ..inputs import Input
from .shared import CALLBACK_HELP

ACTION_HELP = "the action, a name that nodes share"


@statement(
    "provides_action_statement",
    "{node} provides_action {action} of action_type {type} [calling {function}]",
    summary="Let a node do a task for others, and tell how it goes.",
    example="counter provides_action 'count' of action_type Fibonacci",
    purpose="do a task that takes its time",
    ros_term="action",
    about="Others send a goal, hear of the progress, may cancel it, and get a result.",
)
class ProvidesAction(Statement):
    """Let a node do a task for others, and tell how it goes."""

    node: str = slot(SlotKind.NODE, "the node that does the task")
    action: str = slot(SlotKind.ACTION, ACTION_HELP)
    type: str = slot(SlotKind.ACTION_TYPE, "the type of the action")
    function: str | None = slot(SlotKind.FUNCTION, CALLBACK_HELP)


@statement(
    "stop_action_statement",
    "{node} stop_action {action}",
    summary="Let a node no longer do a task for others.",
    example="counter stop_action 'count'",
    purpose="no longer do a task",
    ros_term="action",
    about="Takes an action away again.",
    undoes=ProvidesAction,
)
class StopAction(Statement):
    """Let a node no longer do a task for others."""

    node: str = slot(SlotKind.NODE, "the node that does the task")
    action: str = slot(SlotKind.ACTION, ACTION_HELP)


@statement(
    "sends_goal_statement",
    "{node} sends_goal to {action} of action_type {type} with input {input}",
    summary="Let a node have a task done by another one.",
    example="asker sends_goal to 'count' of action_type Fibonacci with input order=5",
    purpose="have a task done, and hear how it goes",
    ros_term="action client",
    about="A goal goes to the node that provides the action; its progress and result come back.",
)
class SendsGoal(Statement):
    """Let a node have a task done by another one."""

    node: str = slot(SlotKind.NODE, "the node that asks")
    action: str = slot(SlotKind.ACTION, ACTION_HELP)
    type: str = slot(SlotKind.ACTION_TYPE, "the type of the action")
    input: Input = slot(SlotKind.INPUT, "the values of the goal, in order or by name")


@statement(
    "stop_goal_statement",
    "{node} stop_goal to {action}",
    summary="Let a node no longer have a task done.",
    example="asker stop_goal to 'count'",
    purpose="no longer have a task done",
    ros_term="action client",
    about="Takes an action client away again.",
    undoes=SendsGoal,
)
class StopGoal(Statement):
    """Let a node no longer have a task done."""

    node: str = slot(SlotKind.NODE, "the node that asks")
    action: str = slot(SlotKind.ACTION, ACTION_HELP)
