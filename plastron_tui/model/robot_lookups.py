"""What statements about robots name: robots, their links and joints."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import Any, Generic, NamedTuple, TypeVar

from plastron_tui.diagnostics import Code, Diagnostic, Label, Span, codes, guess, listed, write
from plastron_tui.ros.robots.description import Description, Joint, Link
from plastron_tui.ros.robots.names import NAME_RULE, is_name

from .mistake import Mistake
from .other_things import another
from .robots import Places, Robot
from .run import Run

T = TypeVar("T")

_OTHERS = re.compile(r"[^\w.-]+", re.ASCII)


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
    near, fix = another(run.workspace, statement, variable) or (near, fix)
    remedy = f"make it first: `create_robot '{variable}' as {variable}`"
    message = f"no robot `{variable}`"
    raise Mistake(Diagnostic(codes.UNKNOWN_ROBOT, message, where, help=near or remedy, fix=fix))


def find_link(run: Run, robot: Robot, name: str, where: Span) -> Link | None:
    """Return a link that a statement relies on, None where only macros may make it."""
    parts = _parts(robot, lambda each: each.links)
    return _existing(run, robot, parts, name, _Sought("link", codes.UNKNOWN_LINK, where))


def find_joint(run: Run, robot: Robot, name: str, where: Span) -> Joint | None:
    """Return a joint that a statement relies on, None where only macros may make it."""
    parts = _parts(robot, lambda each: each.joints)
    return _existing(run, robot, parts, name, _Sought("joint", codes.UNKNOWN_JOINT, where))


def find_own_link(run: Run, robot: Robot, name: str, where: Span) -> Link:
    """Return a link that a statement changes."""
    find_link(run, robot, name, where)
    found = robot.description.links.get(name)
    if found is None:
        raise Mistake(_of_macro("link", name, where))
    return found


def find_own_joint(run: Run, robot: Robot, name: str, where: Span) -> Joint:
    """Return a joint that a statement changes."""
    find_joint(run, robot, name, where)
    found = robot.description.joints.get(name)
    if found is None:
        raise Mistake(_of_macro("joint", name, where))
    return found


def check_makable(robot: Robot, what: str, name: str, where: Span) -> None:
    """Check that a part which is not there may be made.

    Macros may make one of its name, or the file has one that cannot be read.
    """
    if what == "link":
        is_made = _parts(robot, lambda each: each.links).made(name) is not None
    else:
        is_made = _parts(robot, lambda each: each.joints).made(name) is not None
    if is_made:
        raise Mistake(_of_macro(what, name, where))
    source = robot.source
    if source is not None and (what, name) in source.spans:
        written = source.description
        if name not in (written.links if what == "link" else written.joints):
            message = f"the file has a {what} `{name}` that cannot be read"
            help_text = "correct it there, or choose another name"
            raise Mistake(Diagnostic(codes.BROKEN_URDF, message, where, help=help_text))


@dataclass(frozen=True, slots=True)
class _Parts(Generic[T]):
    """The links or the joints of a robot.

    Attributes:
        own: those that it has by now, as they stand in its file or in the program.
        written: those that stand in its file.
        expanded: those with what macros make of it, as far as that is known.
    """

    own: Mapping[str, T]
    written: Mapping[str, T]
    expanded: Mapping[str, T]

    def made(self, name: str) -> T | None:
        """Return a part that macros make."""
        return None if name in self.written else self.expanded.get(name)


def _parts(robot: Robot, kind: Callable[[Description], Mapping[str, T]]) -> _Parts[T]:
    source = robot.source
    if source is None or source.expanded is None:
        return _Parts(kind(robot.description), {}, {})
    return _Parts(kind(robot.description), kind(source.description), kind(source.expanded))


def _of_macro(what: str, name: str, where: Span) -> Diagnostic:
    message = f"the {what} `{name}` does not stand in the file as it is: macros make it"
    help_text = "change the macro, or what it is called with, in its file"
    return Diagnostic(codes.MADE_BY_MACRO, message, where, help=help_text)


class _Sought(NamedTuple):
    """What a statement names: the word for it, and what is wrong where it is not there."""

    what: str
    code: Code
    where: Span


def _existing(run: Run, robot: Robot, parts: _Parts[T], name: str, sought: _Sought) -> T | None:
    found = parts.own.get(name) or parts.made(name)
    if found is not None:
        return found
    if robot.source is not None and robot.source.whole is None:
        return None
    if run.consequences.mentions(name) or run.consequences.has_part(name):
        raise Mistake
    names = list(dict.fromkeys((*parts.own, *filter(parts.made, parts.expanded))))
    near, fix = guess(name, names, sought.where, is_quoted=True)
    message = f"`{robot.variable}` has no {sought.what} `{name}`"
    help_ = near or _remedy(robot.variable, sought.what, name, names)
    raise Mistake(Diagnostic(sought.code, message, sought.where, help=help_, fix=fix))


def _remedy(variable: str, what: str, name: str, parts: Iterable[str]) -> str:
    if what == "link":
        return f"make it first: `{variable} has_link '{name}'`"
    names = [f"`{each}`" for each in parts]
    return f"it has {listed(names)}" if names else "it has none"


def check_name(what: str, name: str, where: Span) -> None:
    """Check that a robot, a link or a joint may have a name."""
    if not is_name(name):
        message = f"`{name}` cannot be the name of a {what}"
        right = _OTHERS.sub("_", name).lstrip("0123456789.-")
        fix = write(f"'{right}'", where) if right.strip("_") else None
        raise Mistake(Diagnostic(codes.BAD_ROBOT_NAME, message, where, help=NAME_RULE, fix=fix))


def check_new(places: Mapping[str, Places], name: str, what: str, where: Span) -> None:
    """Check that the program has not made or changed a part before."""
    earlier = places.get(name)
    span = earlier and (earlier.made or earlier.changed)
    if earlier is not None and span is not None:
        message = f"the program has a {what} `{name}` already"
        if earlier.made is None:
            message = f"the program changes the {what} `{name}` already"
        help_text = f"say all of it in one sentence, or give the other {what} its own name"
        raise twice(codes.PART_EXISTS, message, where, span, help_text)


def twice(
    code: Code, message: str, where: Span, first: Span, help_text: str | None = None
) -> Mistake:
    """Return the mistake of what is there already, since an earlier statement."""
    label = Label(first, "first here")
    return Mistake(Diagnostic(code, message, where, help=help_text, labels=(label,)))
