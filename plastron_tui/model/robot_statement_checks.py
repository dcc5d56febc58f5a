"""What is looked at in each statement about robots that may have several mistakes."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from plastron_tui.language import statements as st
from plastron_tui.language.declaration import Statement

from .robot_joints import check_child, check_joint_named, check_parent, known_type, mimic_of
from .robot_limits import check_limited_once, check_limits_fit, check_range, check_strength
from .robot_links import check_link_named
from .robot_lookups import find_robot
from .robot_parts import (
    axis_of,
    joint_type_of,
    material_of,
    position_of,
    rotation_of,
    weight_of,
)
from .robot_shapes import shape_of
from .robot_statements import check_robot_named
from .run import Run


def _variable(run: Run, statement: Any) -> None:
    run.checks.new_variable(statement, statement.variable)


def _material(run: Run, statement: st.HasLink) -> None:
    material_of(statement, run.workspace.robots.get(statement.robot))


def _axis(run: Run, statement: st.HasJoint) -> None:
    axis_of(statement, known_type(run, statement))


def _alone(check: Callable[[Any], object]) -> Callable[[Run, Any], object]:
    """Return a check that needs only the statement."""
    return lambda run, statement: check(statement)


_position, _rotation = _alone(position_of), _alone(rotation_of)

CHECKS: dict[type[Statement], tuple[Callable[[Run, Any], object], ...]] = {
    st.CreateRobot: (_variable, check_robot_named),
    st.LoadRobot: (_variable,),
    st.HasLink: (
        *(find_robot, check_link_named, _alone(shape_of), _alone(weight_of), _material),
        *(_position, _rotation),
    ),
    st.HasJoint: (
        *(find_robot, check_joint_named, check_parent, check_child, _alone(joint_type_of)),
        *(_position, _rotation, _axis, mimic_of),
    ),
    st.LimitsJoint: (
        *(find_robot, check_limited_once, check_limits_fit, check_strength, check_range),
    ),
}
"""The checks of each statement."""
