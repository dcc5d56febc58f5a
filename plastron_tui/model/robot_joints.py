"""The statements about joints of robots."""

from __future__ import annotations

from plastron_tui.diagnostics import Diagnostic, Label, codes, guess
from plastron_tui.language import statements as st
from plastron_tui.language.inputs import Nothing
from plastron_tui.ros.robots.description import Joint, JointType, Mimic
from plastron_tui.ros.robots.joint_changes import NO_MIMIC, JointValues, changed_joint

from .mistake import Mistake
from .robot_computed import check_not_computed
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
from .robots import Places, Robot
from .run import Run


def has_joint(run: Run, statement: st.HasJoint) -> None:
    """Give a robot a joint, or change one that a loaded robot has."""
    robot = find_robot(run, statement)
    check_joint_named(run, statement)
    check_parent(run, statement)
    check_child(run, statement)
    values = JointValues(
        joint_type_of(statement),
        _ends_of(statement),
        position_of(statement),
        rotation_of(statement),
        axis_of(statement, known_type(run, statement)),
        mimic_of(run, statement),
    )
    name = statement.joint
    check_not_computed(robot, statement)
    joint = robot.description.joints.get(name)
    places = robot.joints.get(name, Places())
    if joint is None:
        assert values.type is not None, "a new joint has a type"
        assert values.ends is not None, "a new joint says what it holds"
        joint = Joint(name, values.type, *values.ends)
        places = places._replace(made=statement.span)
    else:
        places = places._replace(changed=statement.span)
    for each in joint_slips(statement):
        run.report(statement, each)
    robot.put_joint(changed_joint(joint, values))
    robot.joints[name] = places


def _ends_of(statement: st.HasJoint) -> tuple[str, str] | None:
    if statement.parent is None or statement.child is None:
        return None
    return statement.parent, statement.child


def known_type(run: Run, statement: st.HasJoint) -> JointType | None:
    """Return how a joint moves, by what is said or else as it is; None where nobody can tell."""
    if statement.type is not None:
        return next((each for each in JointType if each.value == statement.type), None)
    robot = run.workspace.robots.get(statement.robot)
    there = None if robot is None else robot.description.joints.get(statement.joint)
    return None if there is None else there.type


def check_joint_named(run: Run, statement: st.HasJoint) -> None:
    """Check that a joint may have its name, is made and changed once, and whole if it is new."""
    robot = run.workspace.robots.get(statement.robot)
    name, where = statement.joint, statement.span_of("joint")
    if robot is None:
        check_name("joint", name, where)
        return
    check_new(robot.joints, name, "joint", where)
    check_makable(robot, "joint", name, where)
    if name not in robot.description.joints:
        check_name("joint", name, where)
        _check_whole(run, robot, statement)
    elif all(getattr(statement, slot) is None for slot in _SLOTS):
        message = f"`{robot.variable}` has a joint `{name}`, and nothing is said of it"
        help_text = "say what changes, or choose another name"
        raise Mistake(Diagnostic(codes.PART_EXISTS, message, where, help=help_text))


_SLOTS = ("type", "parent", "position", "rotation", "axis", "mimicked")
"""What may be said of a joint."""


def _check_whole(run: Run, robot: Robot, statement: st.HasJoint) -> None:
    """Check that a new joint has a type, and says what it holds."""
    name, where = statement.joint, statement.span_of("joint")
    lacking = []
    if statement.type is None:
        lacking.append("`of joint_type …`")
    if statement.parent is None:
        lacking.append("`from '…' to '…'`")
    if not lacking:
        return
    if run.consequences.has_part(name) or run.consequences.mentions(name):
        raise Mistake
    near = fix = None
    if len(lacking) > 1:
        # It reads as if the joint were there.
        spoken = {key for key, at in robot.joints.items() if at.made or at.changed}
        open_ = [each for each in robot.description.joints if each not in spoken]
        near, fix = guess(name, open_, where, is_quoted=True)
    needs = " and ".join(lacking)
    message = f"`{robot.variable}` has no joint `{name}`, and a new one needs {needs}"
    held = f"from '{statement.parent or '…'}' to '{statement.child or '…'}'"
    said = f"has_joint '{name}' of joint_type {statement.type or 'fixed'} {held}"
    remedy = f"such as `{robot.variable} {said}`"
    raise Mistake(Diagnostic(codes.INCOMPLETE_JOINT, message, where, help=near or remedy, fix=fix))


def check_parent(run: Run, statement: st.HasJoint) -> None:
    """Check that the link is there that holds the other one."""
    robot = find_robot(run, statement)
    if statement.parent is not None:
        find_link(run, robot, statement.parent, statement.span_of("parent"))


def check_child(run: Run, statement: st.HasJoint) -> None:
    """Check that the link is there that is held, and is another one."""
    robot = find_robot(run, statement)
    if statement.child is None:
        return
    where = statement.span_of("child")
    find_link(run, robot, statement.child, where)
    if statement.child == statement.parent:
        message = f"`{statement.child}` cannot hold itself"
        raise Mistake(Diagnostic(codes.NO_TREE, message, where, help="a joint holds two links"))


def mimic_of(run: Run, statement: st.HasJoint) -> Mimic | None:
    """Return which joint another one follows, and how far; None where nothing is said."""
    if statement.mimicked is None:
        return None
    if isinstance(statement.mimicked, Nothing):
        return NO_MIMIC
    robot, where = find_robot(run, statement), statement.span_of("mimicked")
    if statement.mimicked == statement.joint:
        message = f"`{statement.joint}` cannot follow itself"
        help_text = "name the joint that it follows"
        raise Mistake(Diagnostic(codes.BAD_MIMIC, message, where, help=help_text))
    followed = find_joint(run, robot, statement.mimicked, where)
    if followed is not None and followed.type is JointType.FIXED:
        message = f"`{followed.name}` is fixed: nothing follows it"
        raise Mistake(Diagnostic(codes.BAD_MIMIC, message, where))
    if known_type(run, statement) is JointType.FIXED:
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
    check_not_computed(robot, statement)
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
