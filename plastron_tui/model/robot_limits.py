"""The statement that limits a joint of a robot."""

from __future__ import annotations

from plastron_tui.diagnostics import Diagnostic, Severity, codes
from plastron_tui.language import statements as st
from plastron_tui.ros.robots.description import Dynamics, Joint, JointType, Limit

from .mistake import Mistake
from .robot_computed import check_not_computed
from .robot_lookups import find_own_joint, find_robot, twice
from .robot_numbers import as_float, numbers
from .robot_parts import range_of
from .robot_slips import limit_slips
from .robots import Places
from .run import Run

_STRONGEST = 1e9
"""No joint has an effort or a velocity beyond it, in whatever unit."""


def limits_joint(run: Run, statement: st.LimitsJoint) -> None:
    """Say how far, how strongly and how fast a joint moves."""
    robot = find_robot(run, statement)
    joint = check_limited_once(run, statement)
    check_limits_fit(run, statement)
    check_strength(run, statement)
    check_not_computed(robot, statement)
    ends = range_of(statement, joint.type)
    limit = joint.limit or Limit()
    if ends is not None:
        limit = limit._replace(lower=ends[0], upper=ends[1])
    if statement.effort is not None and statement.velocity is not None:
        effort, velocity = as_float(statement.effort), as_float(statement.velocity)
        limit = limit._replace(effort=effort, velocity=velocity)
    if _is_limiting(statement):
        joint = joint._replace(limit=limit)
    if statement.damping is not None and statement.friction is not None:
        dynamics = Dynamics(as_float(statement.damping), as_float(statement.friction))
        joint = joint._replace(dynamics=dynamics)
    if joint.type.is_limited and statement.velocity is not None and not limit.velocity:
        message = f"with a velocity of 0, no planner moves `{joint.name}`"
        where, help_text = statement.span_of("velocity"), "say how fast it may be at most"
        still = Diagnostic(
            codes.BAD_LIMITS, message, where, help=help_text, severity=Severity.WARNING
        )
        run.report(statement, still)
    for each in limit_slips(statement):
        run.report(statement, each)
    robot.put_joint(joint)
    places = robot.joints.get(joint.name, Places())
    robot.joints[joint.name] = places._replace(limited=statement.span)


def check_limited_once(run: Run, statement: st.LimitsJoint) -> Joint:
    """Return the joint that is limited, which the program does once."""
    robot, where = find_robot(run, statement), statement.span_of("joint")
    joint = find_own_joint(run, robot, statement.joint, where)
    limited = robot.joints.get(joint.name, Places()).limited
    if limited is not None:
        message = f"`{joint.name}` is limited already"
        help_text = "say all of it in one sentence"
        raise twice(codes.PART_EXISTS, message, where, limited, help_text)
    return joint


def check_limits_fit(run: Run, statement: st.LimitsJoint) -> None:
    """Check that a joint has limits at all, and gets all that it needs."""
    robot, where = find_robot(run, statement), statement.span_of("joint")
    joint = find_own_joint(run, robot, statement.joint, where)
    has_range, has_strength = statement.minimum is not None, statement.effort is not None
    if not (has_range or has_strength):
        if statement.damping is None:
            message = f"nothing is said of `{joint.name}`"
            help_text = "say `between … and … deg`, and `with effort … and velocity …`"
            raise Mistake(Diagnostic(codes.BAD_LIMITS, message, where, help=help_text))
        if not joint.type.has_axis:
            message = f"a joint that is {joint.type.value} has no damping"
            raise Mistake(Diagnostic(codes.BAD_LIMITS, message, where))
        return
    if not (joint.type.is_limited or joint.type is JointType.CONTINUOUS):
        message = f"a joint that is {joint.type.value} has no limits"
        help_text = "one that turns between two angles is `revolute`, one that slides `prismatic`"
        raise Mistake(Diagnostic(codes.BAD_LIMITS, message, where, help=help_text))
    if joint.type is JointType.CONTINUOUS and has_range:
        first, last = statement.span_of("minimum"), statement.span_of("unit")
        message = "a joint that is continuous turns without end"
        help_text = "one that turns between two angles is `revolute`"
        where = first._replace(end=last.end)
        raise Mistake(Diagnostic(codes.BAD_LIMITS, message, where, help=help_text))
    if joint.type.is_limited and joint.limit is None and not (has_range and has_strength):
        unit = "m" if joint.type is JointType.PRISMATIC else "deg"
        lacking = "with effort … and velocity …" if has_range else f"between … and … {unit}"
        message = f"a joint that is {joint.type.value} needs all its limits"
        help_text = f"say `{lacking}` as well"
        raise Mistake(Diagnostic(codes.MISSING_LIMITS, message, where, help=help_text))


def check_strength(_: Run, statement: st.LimitsJoint) -> None:
    """Check that effort, velocity, damping and friction are not negative, and finite."""
    wrong = [
        Diagnostic(codes.BAD_LIMITS, f"`{slot}` is a number from 0 to {_STRONGEST:,.0f}", each.span)
        for slot in ("effort", "velocity", "damping", "friction")
        for each in numbers(statement, slot)
        if not 0 <= each.value <= _STRONGEST
    ]
    if wrong:
        raise Mistake(*wrong)


def check_range(run: Run, statement: st.LimitsJoint) -> None:
    """Check the order of both ends, and their unit as far as the joint is known."""
    robot = run.workspace.robots.get(statement.robot)
    joint = None if robot is None else robot.description.joints.get(statement.joint)
    range_of(statement, joint.type if joint is not None and joint.type.is_limited else None)


def _is_limiting(statement: st.LimitsJoint) -> bool:
    return statement.minimum is not None or statement.effort is not None
