"""The statements about robots."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from math import isfinite
from typing import Any, TypeVar

from plastron_tui.diagnostics import Code, Diagnostic, Label, Span, codes, guess
from plastron_tui.language import statements as st
from plastron_tui.language.declaration import Statement
from plastron_tui.ros.packages import LONGEST_FILE_NAME
from plastron_tui.ros.robots.changes import LinkValues, changed_joint, changed_link, new_link
from plastron_tui.ros.robots.description import (
    Description,
    Dynamics,
    Joint,
    JointType,
    Limit,
    Mimic,
    Pose,
)

from .mistake import Mistake
from .robot_parts import (
    axis_of,
    joint_type_of,
    material_of,
    position_of,
    range_of,
    rotation_of,
    shape_of,
    weight_of,
)
from .robots import Places, Robot, RobotGeneration
from .run import Run

_NAME = re.compile(r"[A-Za-z_][\w.-]*", re.ASCII)
_LONGEST_NAME = LONGEST_FILE_NAME - len(".urdf")

T = TypeVar("T")


def create_robot(run: Run, statement: st.CreateRobot) -> None:
    """Describe a robot."""
    run.checks.new_variable(statement, statement.variable)
    check_robot_named(run, statement)
    description = Description(statement.name)
    robot = Robot(statement.variable, statement.span, description)
    run.workspace.robots[statement.variable] = robot


def check_robot_named(run: Run, statement: st.CreateRobot) -> None:
    """Check that a robot may have its name, and that no other has it."""
    where = statement.span_of("name")
    _check_name("robot", statement.name, where)
    if len(statement.name) > _LONGEST_NAME:
        message = f"the name of a robot has at most {_LONGEST_NAME} characters"
        raise Mistake(Diagnostic(codes.BAD_ROBOT_NAME, message, where, help="choose a shorter one"))
    for other in run.workspace.robots.values():
        if other.name == statement.name:
            message = f"a robot `{statement.name}` exists already"
            raise _twice(codes.ROBOT_EXISTS, message, where, other.span)


def _check_name(what: str, name: str, where: Span) -> None:
    if not _NAME.fullmatch(name):
        message = f"`{name}` cannot be the name of a {what}"
        help_text = "a name has letters, digits, `_`, `-` and dots, and starts with a letter"
        raise Mistake(Diagnostic(codes.BAD_ROBOT_NAME, message, where, help=help_text))


def load_robot(run: Run, statement: st.LoadRobot) -> None:
    """Read the description of a robot, to change it."""
    run.checks.new_variable(statement, statement.variable)
    where = statement.span_of("source")
    loaded = run.setting.read_robot(statement.source)
    found = [each if each.file else each._replace(span=where) for each in loaded.diagnostics]
    source = loaded.source
    if source is None:
        raise Mistake(*found)
    for other in run.workspace.robots.values():
        if other.source is not None and other.source.path == source.path:
            message = f"`{statement.source}` is loaded already"
            raise _twice(codes.ROBOT_EXISTS, message, where, other.span)
    for each in found:
        run.report(statement, each)
    robot = Robot(statement.variable, statement.span, source.description, source)
    run.workspace.robots[statement.variable] = robot


def has_link(run: Run, statement: st.HasLink) -> None:
    """Give a robot a link, or change one that a loaded robot has."""
    robot = find_robot(run, statement)
    name, where = statement.link, statement.span_of("link")
    _check_new(robot.links, name, "link", where)
    values = LinkValues(
        shape_of(statement),
        weight_of(statement),
        material_of(statement, robot.description),
        position_of(statement),
        rotation_of(statement),
    )
    there = robot.description.links.get(name)
    if there is None:
        _check_name("link", name, where)
        if values.shape is None and values.mass is not None:
            message = "what weighs something has a shape: its inertia follows from it"
            where = statement.span_of("weight")
            raise Mistake(Diagnostic(codes.BAD_SHAPE, message, where, help="say `shaped …`"))
        link, places = new_link(name, values, run.setting.mesh_size), Places(made=statement.span)
    else:
        link = changed_link(there, values, run.setting.mesh_size)
        places = Places(changed=statement.span)
    robot.description = _with(robot.description, "links", name, link)
    robot.links[name] = places


def no_longer_has_link(run: Run, statement: st.NoLongerHasLink) -> None:
    """Take a link away from a robot."""
    robot = find_robot(run, statement)
    name, where = statement.link, statement.span_of("link")
    _existing(run, robot, robot.description.links, name, codes.UNKNOWN_LINK, "link", where)
    for joint in robot.description.joints.values():
        if name in (joint.parent, joint.child):
            message = f"the joint `{joint.name}` still holds `{name}`"
            places = robot.joints.get(joint.name)
            labels = () if places is None or places.made is None else (Label(places.made, "here"),)
            help_text = f"take it away first: `{robot.variable} no_longer_has_joint '{joint.name}'`"
            raise Mistake(
                Diagnostic(codes.PART_IN_USE, message, where, help=help_text, labels=labels)
            )
    robot.description = _without(robot.description, "links", name)
    robot.links.pop(name, None)


def has_joint(run: Run, statement: st.HasJoint) -> None:
    """Give a robot a joint, or change one that a loaded robot has."""
    robot = find_robot(run, statement)
    name, where = statement.joint, statement.span_of("joint")
    _check_new(robot.joints, name, "joint", where)
    for slot in ("parent", "child"):
        link, at = getattr(statement, slot), statement.span_of(slot)
        _existing(run, robot, robot.description.links, link, codes.UNKNOWN_LINK, "link", at)
    type_ = joint_type_of(statement)
    mimic = _mimic_of(run, robot, statement)
    position, rotation, axis = (
        position_of(statement),
        rotation_of(statement),
        axis_of(statement, type_),
    )
    there = robot.description.joints.get(name)
    if there is None:
        _check_name("joint", name, where)
        pose = Pose(position or (0.0, 0.0, 0.0), rotation or (0.0, 0.0, 0.0))
        joint = Joint(name, type_, statement.parent, statement.child, pose, axis, mimic=mimic)
        places = Places(made=statement.span)
    else:
        ends = statement.parent, statement.child
        joint = changed_joint(there, type_, ends, position, rotation, axis, mimic)
        places = Places(changed=statement.span)
    robot.description = _with(robot.description, "joints", name, joint)
    robot.joints[name] = places


def _mimic_of(run: Run, robot: Robot, statement: st.HasJoint) -> Mimic | None:
    if statement.mimicked is None:
        return None
    where = statement.span_of("mimicked")
    if statement.mimicked == statement.joint:
        message = f"`{statement.joint}` cannot follow itself"
        raise Mistake(Diagnostic(codes.BAD_MIMIC, message, where))
    joints = robot.description.joints
    code = codes.UNKNOWN_JOINT
    followed = _existing(run, robot, joints, statement.mimicked, code, "joint", where)
    if followed.type is JointType.FIXED:
        message = f"`{followed.name}` is fixed: nothing follows it"
        raise Mistake(Diagnostic(codes.BAD_MIMIC, message, where))
    return Mimic(followed.name, 1.0 if statement.factor is None else float(statement.factor))


def no_longer_has_joint(run: Run, statement: st.NoLongerHasJoint) -> None:
    """Take a joint away from a robot."""
    robot = find_robot(run, statement)
    name, where = statement.joint, statement.span_of("joint")
    joints = robot.description.joints
    _existing(run, robot, joints, name, codes.UNKNOWN_JOINT, "joint", where)
    for other in joints.values():
        if other.mimic is not None and other.mimic.joint == name:
            message = f"`{other.name}` still follows `{name}`"
            raise Mistake(Diagnostic(codes.PART_IN_USE, message, where))
    robot.description = _without(robot.description, "joints", name)
    robot.joints.pop(name, None)


def limits_joint(run: Run, statement: st.LimitsJoint) -> None:
    """Say how far, how strongly and how fast a joint moves."""
    robot = find_robot(run, statement)
    name, where = statement.joint, statement.span_of("joint")
    joints = robot.description.joints
    joint = _existing(run, robot, joints, name, codes.UNKNOWN_JOINT, "joint", where)
    places = robot.joints.get(name, Places())
    if places.limited is not None:
        message = f"`{name}` is limited already"
        raise _twice(codes.PART_EXISTS, message, where, places.limited)
    is_limiting = statement.minimum is not None or statement.effort is not None
    if is_limiting and not (joint.type.is_limited or joint.type is JointType.CONTINUOUS):
        message = f"a joint that is {joint.type.value} has no limits"
        raise Mistake(Diagnostic(codes.BAD_LIMITS, message, where))
    for slot in ("effort", "velocity", "damping", "friction"):
        value = getattr(statement, slot)
        if value is not None and not (value >= 0 and isfinite(value)):
            message = f"`{slot}` is a number that is not less than 0"
            raise Mistake(Diagnostic(codes.BAD_LIMITS, message, statement.span_of(slot)))
    limit = joint.limit or Limit()
    ends = range_of(statement, joint.type)
    if ends is not None:
        limit = limit._replace(lower=ends[0], upper=ends[1])
    if statement.effort is not None and statement.velocity is not None:
        effort, velocity = float(statement.effort), float(statement.velocity)
        limit = limit._replace(effort=effort, velocity=velocity)
    if is_limiting:
        joint = joint._replace(limit=limit)
    if statement.damping is not None and statement.friction is not None:
        dynamics = Dynamics(float(statement.damping), float(statement.friction))
        joint = joint._replace(dynamics=dynamics)
    robot.description = _with(robot.description, "joints", name, joint)
    robot.joints[name] = places._replace(limited=statement.span)


def generate_robot(run: Run, statement: st.GenerateRobot) -> None:
    """Note that the description of a robot is to be written as it is now."""
    robot = find_robot(run, statement)
    run.workspace.written_robots.append(RobotGeneration(robot.snapshot(), statement.span))


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


def _existing(
    run: Run,
    robot: Robot,
    parts: Mapping[str, T],
    name: str,
    code: Code,
    what: str,
    where: Span,
) -> T:
    """Return a part that a statement names."""
    found = parts.get(name)
    if found is not None:
        return found
    if run.consequences.mentions(name):
        raise Mistake
    near, fix = guess(name, parts, where, is_quoted=True)
    message = f"`{robot.variable}` has no {what} `{name}`"
    remedy = _remedy(robot.variable, what, name, parts)
    raise Mistake(Diagnostic(code, message, where, help=near or remedy, fix=fix))


def _remedy(variable: str, what: str, name: str, parts: Iterable[str]) -> str:
    if what == "link":
        return f"make it first: `{variable} has_link '{name}'`"
    there = ", ".join(f"`{each}`" for each in list(parts)[:5])
    return f"it has {there}" if there else "it has none"


def _check_new(places: Mapping[str, Places], name: str, what: str, where: Span) -> None:
    """Check that the program has not spoken of a part before."""
    earlier = places.get(name)
    span = earlier and (earlier.made or earlier.changed)
    if span is not None:
        message = f"the program has a {what} `{name}` already"
        help_text = "say all of it in one sentence"
        raise _twice(codes.PART_EXISTS, message, where, span, help_text)


def _twice(
    code: Code, message: str, where: Span, first: Span, help_text: str | None = None
) -> Mistake:
    return Mistake(
        Diagnostic(code, message, where, help=help_text, labels=(Label(first, "first here"),))
    )


def _with(robot: Description, kind: str, name: str, part: object) -> Description:
    changes: Any = {kind: {**getattr(robot, kind), name: part}}
    return replace(robot, **changes)


def _without(robot: Description, kind: str, name: str) -> Description:
    parts = getattr(robot, kind)
    changes: Any = {kind: {each: part for each, part in parts.items() if each != name}}
    return replace(robot, **changes)


HANDLERS: dict[type[Statement], Callable[[Run, Any], None]] = {
    st.CreateRobot: create_robot,
    st.LoadRobot: load_robot,
    st.HasLink: has_link,
    st.NoLongerHasLink: no_longer_has_link,
    st.HasJoint: has_joint,
    st.NoLongerHasJoint: no_longer_has_joint,
    st.LimitsJoint: limits_joint,
    st.GenerateRobot: generate_robot,
}
"""What each statement about robots does."""
