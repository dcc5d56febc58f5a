"""What statements about robots name: robots, their links and joints."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from typing import Any, TypeVar

from plastron_tui.diagnostics import Code, Diagnostic, Label, Span, codes, guess, listed
from plastron_tui.ros.robots.description import Joint, Link

from .mistake import Mistake
from .robots import Places, Robot
from .run import Run

T = TypeVar("T")

_NAME = re.compile(r"[A-Za-z_][\w.-]*", re.ASCII)


def find_robot(run: Run, statement: Any) -> Robot:
    """Return the robot that a statement is about."""
    variable: str = statement.robot
    robot = run.workspace.robots.get(variable)
    if robot is not None:
        return robot
    where = statement.span_of("robot")
    if run.consequences.declares(variable):
        raise Mistake
    near, fix = guess(variable, run.workspace.robots, where)
    other = run.workspace.what(variable)
    if other is not None:
        near, fix = f"`{variable}` is a {other[0]}", None
    remedy = f"make it first: `create_robot '{variable}' as {variable}`"
    message = f"no robot `{variable}`"
    raise Mistake(Diagnostic(codes.UNKNOWN_ROBOT, message, where, help=near or remedy, fix=fix))


def find_link(run: Run, robot: Robot, name: str, where: Span) -> Link:
    """Return a link that a statement names."""
    return _existing(run, robot, robot.description.links, name, codes.UNKNOWN_LINK, "link", where)


def find_joint(run: Run, robot: Robot, name: str, where: Span) -> Joint:
    """Return a joint that a statement names."""
    joints, code = robot.description.joints, codes.UNKNOWN_JOINT
    return _existing(run, robot, joints, name, code, "joint", where)


def _existing(
    run: Run,
    robot: Robot,
    parts: Mapping[str, T],
    name: str,
    code: Code,
    what: str,
    where: Span,
) -> T:
    found = parts.get(name)
    if found is not None:
        return found
    if run.consequences.mentions(name) or run.consequences.has_part(name):
        raise Mistake
    near, fix = guess(name, parts, where, is_quoted=True)
    message = f"`{robot.variable}` has no {what} `{name}`"
    remedy = _remedy(robot.variable, what, name, parts)
    raise Mistake(Diagnostic(code, message, where, help=near or remedy, fix=fix))


def _remedy(variable: str, what: str, name: str, parts: Iterable[str]) -> str:
    if what == "link":
        return f"make it first: `{variable} has_link '{name}'`"
    names = [f"`{each}`" for each in parts]
    return f"it has {listed(names)}" if names else "it has none"


def check_name(what: str, name: str, where: Span) -> None:
    """Check that a robot, a link or a joint may have a name."""
    if not _NAME.fullmatch(name):
        message = f"`{name}` cannot be the name of a {what}"
        help_text = "a name has letters, digits, `_`, `-` and dots, and starts with a letter or `_`"
        raise Mistake(Diagnostic(codes.BAD_ROBOT_NAME, message, where, help=help_text))


def check_new(places: Mapping[str, Places], name: str, what: str, where: Span) -> None:
    """Check that the program has not made or changed a part before."""
    earlier = places.get(name)
    span = earlier and (earlier.made or earlier.changed)
    if earlier is not None and span is not None:
        message = f"the program has a {what} `{name}` already"
        if earlier.made is None:
            message = f"the program changes the {what} `{name}` already"
        help_text = "say all of it in one sentence"
        raise twice(codes.PART_EXISTS, message, where, span, help_text)


def twice(
    code: Code, message: str, where: Span, first: Span, help_text: str | None = None
) -> Mistake:
    """Return the mistake of what is there already, since an earlier statement."""
    label = Label(first, "first here")
    return Mistake(Diagnostic(code, message, where, help=help_text, labels=(label,)))
