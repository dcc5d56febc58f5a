"""The statements about joints of robots."""

from __future__ import annotations

from plastron_tui.diagnostics import Diagnostic, Label, codes
from plastron_tui.language import statements as st
from plastron_tui.ros.robots.description import Joint, JointType, Mimic
from plastron_tui.ros.robots.joint_changes import changed_joint

from .mistake import Mistake
from .robot_lookups import (
    check_makable,
    check_name,
    check_new,
    find_joint,
    find_link,
    find_own_joint,
    find_robot,
)
from .robot_numbers import FARTHEST, as_float
from .robot_parts import axis_of, joint_type_of, position_of, rotation_of
from .robot_slips import joint_slips
from .robots import Places
from .run import Run


def has_joint(run: Run, statement: st.HasJoint) -> None:
    """Give a robot a joint, or change one that a loaded robot has."""
    robot = find_robot(run, statement)
    check_joint_named(run, statement)
    check_parent(run, statement)
    check_child(run, statement)
    type_ = joint_type_of(statement)
    position, rotation = position_of(statement), rotation_of(statement)
    axis = axis_of(statement, type_)
    mimic = mimic_of(run, statement)
    name, ends = statement.joint, (statement.parent, statement.child)
    there = robot.description.joints.get(name)
    places = robot.joints.get(name, Places())
    if there is None:
        new = Joint(name, type_, *ends)
        joint = changed_joint(new, type_, ends, position, rotation, axis, mimic)
        places = places._replace(made=statement.span)
    else:
        joint = changed_joint(there, type_, ends, position, rotation, axis, mimic)
        places = places._replace(changed=statement.span)
    for each in joint_slips(statement):
        run.report(statement, each)
    robot.put_joint(joint)
    robot.joints[name] = places


def check_joint_named(run: Run, statement: st.HasJoint) -> None:
    """Check that a joint may have its name, and is made and changed once."""
    robot = run.workspace.robots.get(statement.robot)
    name, where = statement.joint, statement.span_of("joint")
    if robot is not None:
        check_new(robot.joints, name, "joint", where)
        check_makable(robot, "joint", name, where)
    if robot is None or name not in robot.description.joints:
        check_name("joint", name, where)


def check_parent(run: Run, statement: st.HasJoint) -> None:
    """Check that the link is there that holds the other one."""
    robot = find_robot(run, statement)
    find_link(run, robot, statement.parent, statement.span_of("parent"))


def check_child(run: Run, statement: st.HasJoint) -> None:
    """Check that the link is there that is held, and is another one."""
    robot = find_robot(run, statement)
    where = statement.span_of("child")
    find_link(run, robot, statement.child, where)
    if statement.child == statement.parent:
        message = f"`{statement.child}` cannot hold itself"
        raise Mistake(Diagnostic(codes.NO_TREE, message, where, help="a joint holds two links"))


def mimic_of(run: Run, statement: st.HasJoint) -> Mimic | None:
    """Return which joint another one follows, and how far; None where nothing is said."""
    if statement.mimicked is None:
        return None
    robot, where = find_robot(run, statement), statement.span_of("mimicked")
    if statement.mimicked == statement.joint:
        message = f"`{statement.joint}` cannot follow itself"
        help_text = "name the joint that it follows"
        raise Mistake(Diagnostic(codes.BAD_MIMIC, message, where, help=help_text))
    followed = find_joint(run, robot, statement.mimicked, where)
    if followed is not None and followed.type is JointType.FIXED:
        message = f"`{followed.name}` is fixed: nothing follows it"
        raise Mistake(Diagnostic(codes.BAD_MIMIC, message, where))
    if statement.type == JointType.FIXED.value:
        message = f"`{statement.joint}` is fixed: it follows nothing"
        raise Mistake(Diagnostic(codes.BAD_MIMIC, message, where))
    there = robot.description.joints.get(statement.joint)
    mimic = Mimic(statement.mimicked)
    if there is not None and there.mimic is not None and there.mimic.joint == mimic.joint:
        mimic = there.mimic
    if statement.factor is None:
        return mimic
    factor = as_float(statement.factor)
    if not 0 < abs(factor) <= FARTHEST:
        message = "how far a joint follows is a number that is not 0"
        raise Mistake(Diagnostic(codes.BAD_MIMIC, message, statement.span_of("factor")))
    return mimic._replace(multiplier=factor)


def no_longer_has_joint(run: Run, statement: st.NoLongerHasJoint) -> None:
    """Take a joint away from a robot."""
    robot = find_robot(run, statement)
    name, where = statement.joint, statement.span_of("joint")
    find_own_joint(run, robot, name, where)
    following = next(robot.following(name), None)
    if following is not None:
        if run.consequences.has_part(following.name):
            raise Mistake
        made = robot.joints.get(following.name, Places()).made
        labels = () if made is None else (Label(made, "here"),)
        message = f"`{following.name}` still follows `{name}`"
        help_text = (
            f"take that one away first, `{robot.variable} no_longer_has_joint '{following.name}'`, "
            "or let it follow another"
        )
        raise Mistake(Diagnostic(codes.PART_IN_USE, message, where, help=help_text, labels=labels))
    robot.take_joint(name, where)
