"""Whether the joints that messages name are joints of the program's robot."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator
from typing import Any

from plastron_tui.diagnostics import Diagnostic, Label, Span, codes, write
from plastron_tui.diagnostics.suggest import nearest
from plastron_tui.language import statements as st
from plastron_tui.language.inputs import ListValue, Literal, NamedArgument, NestedValue
from plastron_tui.language.lowering import Program

from .workspace import Workspace

_FIELDS = {
    "sensor_msgs/JointState": "name",
    "sensor_msgs/MultiDOFJointState": "joint_names",
    "trajectory_msgs/JointTrajectory": "joint_names",
    "trajectory_msgs/MultiDOFJointTrajectory": "joint_names",
    "control_msgs/FollowJointTrajectory": "joint_names",
}
"""The fields with names of joints, by the type that has them in it; they are those types' only
lists of strings."""

_BY_NAME = {type_.rpartition("/")[2]: field for type_, field in _FIELDS.items()}


def check_joint_names(program: Program, workspace: Workspace) -> Iterator[Diagnostic]:
    """Yield a warning for each joint that a message names and the program's robot lacks.

    In a program with several robots nobody knows which of them a message is about.
    """
    if len(workspace.robots) != 1:
        return
    (robot,) = workspace.robots.values()
    whole = robot.whole
    if whole is None:
        return
    for statement in program.statements:
        if isinstance(statement, (st.CreateMessage, st.SendsGoal)):
            field = _field(statement.type, workspace)
            if field is not None:
                yield from _unknown(statement, field, whole.joints, robot.span)


def _field(type_: str, workspace: Workspace) -> str | None:
    """Return the field with names of joints that a type has, as a program names it."""
    if type_ in workspace.types:
        return None
    parts = type_.split("/")
    full = f"{parts[0]}/{parts[-1]}"
    return _BY_NAME.get(type_) if len(parts) == 1 else _FIELDS.get(full)


def _unknown(
    statement: Any, field: str, joints: Collection[str], robot: Span
) -> Iterator[Diagnostic]:
    for each in _named(statement.input or (), field):
        name = str(each.value)
        if name in joints:
            continue
        syntax = each.syntax
        where = Span(syntax.start_byte, syntax.end_byte).moved(statement.shift)
        near = nearest(name, joints)
        yield Diagnostic(
            codes.UNKNOWN_JOINT_NAME,
            f"the program's robot has no joint `{name}`",
            where,
            help=None if near is None else f"did you mean `{near}`?",
            fix=None if near is None else write(f'"{near}"', where),
            labels=(Label(robot, "the robot"),),
        )


def _named(values: Iterable[Any], field: str) -> Iterator[Literal]:
    """Yield the strings of a field that is called so, or that comes by its place."""
    for each in values:
        value = each.value if isinstance(each, NamedArgument) else each
        is_named = not isinstance(each, NamedArgument) or each.path[-1] == field
        if isinstance(value, ListValue) and is_named:
            items = (item for item in value.items if isinstance(item, Literal))
            yield from (item for item in items if isinstance(item.value, str))
        elif isinstance(value, NestedValue):
            yield from _named(value.arguments, field)
