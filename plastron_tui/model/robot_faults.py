"""Faults of robots in words."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence

from plastron_tui.diagnostics import Code, Diagnostic, Severity, Span, codes, listed
from plastron_tui.ros.robots.description import Description, JointType
from plastron_tui.ros.robots.faults import Fault, FaultKind, faults
from plastron_tui.ros.robots.plausible import HEAVIEST, LONGEST

from .robots import Robot, RobotSource

CODES: Mapping[FaultKind, Code] = {
    FaultKind.NO_LINKS: codes.NO_TREE,
    FaultKind.LOOSE: codes.NO_TREE,
    FaultKind.CIRCLE: codes.NO_TREE,
    FaultKind.HELD_TWICE: codes.NO_TREE,
    FaultKind.NO_PARENT: codes.UNKNOWN_LINK,
    FaultKind.NO_CHILD: codes.UNKNOWN_LINK,
    FaultKind.NO_LIMITS: codes.MISSING_LIMITS,
    FaultKind.NO_RANGE: codes.BAD_LIMITS,
    FaultKind.NO_VELOCITY: codes.BAD_LIMITS,
    FaultKind.MIMICS_NOTHING: codes.BAD_MIMIC,
    FaultKind.MIMICS_FIXED: codes.BAD_MIMIC,
    FaultKind.MIMIC_CIRCLE: codes.BAD_MIMIC,
    FaultKind.MASS: codes.BAD_WEIGHT,
    FaultKind.SIZE: codes.BAD_SHAPE,
    FaultKind.INERTIA: codes.IMPOSSIBLE_INERTIA,
    FaultKind.ROOT_INERTIA: codes.ROOT_INERTIA,
    FaultKind.WEIGHTLESS: codes.MISSING_WEIGHT,
    FaultKind.LONG: codes.UNIT_SLIP,
    FaultKind.HEAVY: codes.UNIT_SLIP,
    FaultKind.NAME: codes.BAD_ROBOT_NAME,
    FaultKind.SHARED_NAME: codes.LINK_NAME_AGAIN,
}
"""What each kind of fault is to a user."""

_OF_SEVERAL: Mapping[FaultKind, str] = {
    FaultKind.NO_LINKS: "it has no link",
    FaultKind.LOOSE: "no joint holds {}",
    FaultKind.NO_LIMITS: "the limits are missing that URDF wants of {}",
    FaultKind.NO_RANGE: "between its limits nothing moves at {}",
    FaultKind.NO_VELOCITY: "with a velocity of 0, no planner moves {}",
    FaultKind.MASS: "no positive mass has {}",
    FaultKind.SIZE: "no positive size has {}",
    FaultKind.INERTIA: "no body can have the inertia of {}",
    FaultKind.ROOT_INERTIA: "the weight of the root {} is ignored by KDL, ROS's library for motion",
    FaultKind.WEIGHTLESS: "{} moves and has no weight: Gazebo leaves it out",
    FaultKind.LONG: f"more than {LONGEST:,.0f} m is said of {{}}",
    FaultKind.HEAVY: f"more than {HEAVIEST:,.0f} kg is said of {{}}",
    FaultKind.NAME: "tf2 takes no such name: {}",
    FaultKind.SHARED_NAME: "a link and a joint have one name: {}",
}
"""What is said of all faults of a kind at once."""

_OF_ONE: Mapping[FaultKind, Callable[[Fault], str]] = {
    FaultKind.CIRCLE: lambda fault: f"joints hold each other in a circle: {_row(fault)}",
    FaultKind.HELD_TWICE: lambda fault: (
        f"two joints hold `{fault.others[0]}`: `{fault.others[1]}` and `{fault.part}`"
    ),
    FaultKind.NO_PARENT: lambda fault: (
        f"`{fault.part}` hangs on `{fault.others[0]}`, which is not there"
    ),
    FaultKind.NO_CHILD: lambda fault: (
        f"`{fault.part}` holds `{fault.others[0]}`, which is not there"
    ),
    FaultKind.MIMICS_NOTHING: lambda fault: (
        f"`{fault.part}` follows `{fault.others[0]}`, which is not there"
    ),
    FaultKind.MIMICS_FIXED: lambda fault: (
        f"`{fault.part}` follows `{fault.others[0]}`, which is fixed"
    ),
    FaultKind.MIMIC_CIRCLE: lambda fault: f"joints follow each other in a circle: {_row(fault)}",
}
"""What is said of one fault of the other kinds."""

_MOST = 5
"""How many faults of one kind of a file are told one by one."""


def _row(fault: Fault) -> str:
    return listed(f"`{each}`" for each in fault.others)


def message_of(fault: Fault) -> str:
    """Return what is said of one fault."""
    one = _OF_ONE.get(fault.kind)
    return _OF_SEVERAL[fault.kind].format(f"`{fault.part}`") if one is None else one(fault)


def help_of(fault: Fault, robot: Robot) -> str | None:
    """Return the remedy for one fault, in words."""
    variable, part = robot.variable, fault.part
    match fault.kind:
        case FaultKind.NO_LINKS:
            return f"give it one: `{variable} has_link 'base_link'`"
        case FaultKind.LOOSE:
            parent = fault.others[0]
            joint = f"'{part}_joint' of joint_type fixed from '{parent}' to '{part}'"
            remedy = f"a joint is missing, such as `{variable} has_joint {joint}`"
            if robot.source is None:
                return remedy
            return f"{remedy}; or take the link away: `{variable} no_longer_has_link '{part}'`"
        case FaultKind.CIRCLE | FaultKind.MIMIC_CIRCLE | FaultKind.HELD_TWICE:
            return f"take one of them away: `{variable} no_longer_has_joint '{part}'`"
        case FaultKind.NO_LIMITS | FaultKind.NO_RANGE:
            is_sliding = robot.description.joints[part].type is JointType.PRISMATIC
            ends = "0 and 0.5 m" if is_sliding else "-90 and 90 deg"
            said = f"limits_joint '{part}' between {ends} with effort 10 and velocity 1"
            return f"say, for example, `{variable} {said}`"
        case FaultKind.SHARED_NAME:
            return f"call the joint `{part}_joint`"
        case FaultKind.ROOT_INERTIA:
            return _empty_root(part)
        case FaultKind.WEIGHTLESS:
            return "say what it weighs, such as `weighing 0.5`"
        case _:
            return None


def _empty_root(root: str) -> str:
    return f"let an empty link be the root, and hold `{root}` by a fixed joint"


def faults_of_file(source: RobotSource, where: Span) -> Iterator[Diagnostic]:
    """Yield a warning for what is wrong with a robot's file, which can be changed as it is.

    Args:
        source: the file.
        where: the statement that loads it: what stands nowhere in it is told there.

    That a link has no weight is not told: many files are for pictures alone.
    """
    whole = source.whole
    if whole is None:
        return
    found: dict[FaultKind, list[Fault]] = {}
    for fault in faults(whole):
        if fault.kind is not FaultKind.WEIGHTLESS and not _is_told_by_reader(fault, whole):
            found.setdefault(fault.kind, []).append(fault)
    for kind, each in found.items():
        for part, message in _messages(kind, each):
            key = "joint" if kind.is_of_joint else "link", part
            span = source.spans.get(key) if source.origin is None else None
            file = None if span is None else source.path
            at = where if span is None else span
            help_ = _empty_root(part) if kind is FaultKind.ROOT_INERTIA else None
            yield Diagnostic(CODES[kind], message, at, file, help_, severity=Severity.WARNING)


def _is_told_by_reader(fault: Fault, robot: Description) -> bool:
    """Tell whether reading URDF tells of a fault: urdfdom's parser does, too."""
    if fault.kind is FaultKind.MASS:
        inertial = robot.links[fault.part].inertial
        return inertial is not None and inertial.mass < 0
    return fault.kind is FaultKind.NO_LIMITS


def _messages(kind: FaultKind, found: Sequence[Fault]) -> Iterator[tuple[str, str]]:
    """Yield what is said of faults of a kind, each with the part where it is said."""
    if kind in _OF_SEVERAL:
        names = listed(f"`{each.part}`" for each in found)
        yield found[0].part, _OF_SEVERAL[kind].format(names)
        return
    yield from ((each.part, message_of(each)) for each in found[:_MOST])
    rest = found[_MOST:]
    if rest:
        yield rest[0].part, f"so it is with {listed(f'`{each.part}`' for each in rest)}"
