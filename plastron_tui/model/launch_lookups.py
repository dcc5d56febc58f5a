"""What the statements about launch files look up, and what is wrong where it is not there."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from plastron_tui.diagnostics import Code, Diagnostic, Label, Span, codes, guess
from plastron_tui.language.inputs import InputValue, ListValue, Literal
from plastron_tui.ros.launch import Item, names_of
from plastron_tui.ros.launch_values import as_value
from plastron_tui.ros.parameters import Setting

from .launches import Launch
from .mistake import Mistake
from .other_things import another
from .robots import Robot
from .run import Run
from .workspace import Node

VALUE_HELP = "a parameter is a number, a text, a boolean, or a list of one of them"


def find_launch(run: Run, statement: Any) -> Launch:
    """Return the launch file that a statement is about."""
    variable: str = statement.launch
    launch = run.workspace.launches.get(variable)
    if launch is not None:
        return launch
    where = statement.span_of("launch")
    remedy = f"make it first: `create_launch '{variable}' as {variable}`"
    others = run.workspace.launches
    raise _unknown(run, statement, codes.UNKNOWN_LAUNCH, variable, where, others, remedy)


def find_node(run: Run, statement: Any, variable: str, where: Span) -> Node:
    """Return the node that a launch file is to start."""
    node = run.workspace.nodes.get(variable)
    if node is not None:
        return node
    robot = run.workspace.robots.get(variable)
    if robot is not None:
        raise _started_by_its_file(run, robot, where)
    remedy = f"make it first: `create_node '{variable}' as {variable}`"
    others = run.workspace.nodes
    raise _unknown(run, statement, codes.UNKNOWN_NODE, variable, where, others, remedy)


def _started_by_its_file(run: Run, robot: Robot, where: Span) -> Mistake:
    """Return the mistake of a robot that is to be started, which a file of its package does."""
    ending = ".launch" if run.setting.ros_version(None) == 1 else ".launch.xml"
    message = f"`{robot.variable}` is a robot, and no node"
    includes = (
        f"include what starts it: `includes '{robot.home or 'PACKAGE'}/{robot.stem}{ending}'`"
    )
    help_ = includes if robot.home else f"put it into a package, and {includes}"
    return Mistake(Diagnostic(codes.UNKNOWN_NODE, message, where, help=help_))


def _unknown(
    run: Run,
    statement: Any,
    code: Code,
    variable: str,
    where: Span,
    others: Iterable[str],
    remedy: str,
) -> Mistake:
    if run.consequences.declares(variable):
        return Mistake()
    near, fix = another(run.workspace, statement, variable) or guess(variable, others, where)
    word = "launch file" if code is codes.UNKNOWN_LAUNCH else "node"
    message = f"no {word} `{variable}`"
    return Mistake(Diagnostic(code, message, where, help=near or remedy, fix=fix))


def names_there(launch: Launch, kind: type[Item], removed: Mapping[str, Span]) -> list[str]:
    """Return what a loaded launch file has of a kind by now, as programs call it."""
    if launch.source is None:
        return []
    return [name for name in names_of(launch.source.launch.items, kind) if name not in removed]


def bad_name(message: str, where: Span, help_text: str) -> Mistake:
    """Return the mistake of a name that a launch file cannot use."""
    return Mistake(Diagnostic(codes.BAD_LAUNCH_NAME, message, where, help=help_text))


def twice(
    code: Code, message: str, where: Span, first: Span | None, help_text: str | None = None
) -> Mistake:
    """Return the mistake of something that is there already, and where, if that is known."""
    labels = () if first is None else (Label(first, "first here"),)
    return Mistake(Diagnostic(code, message, where, help=help_text, labels=labels))


def plain_value(value: InputValue) -> Setting | None:
    """Return a value as a parameter holds it, None where it cannot."""
    if isinstance(value, Literal):
        return value.value
    if isinstance(value, ListValue):
        return as_value([each.value for each in value.items if isinstance(each, Literal)])
    return None
