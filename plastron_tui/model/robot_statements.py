"""The statements about robots as a whole, and what each statement about robots does."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from plastron_tui.diagnostics import Severity, codes
from plastron_tui.language import statements as st
from plastron_tui.language.declaration import Statement
from plastron_tui.ros.robots.description import Description
from plastron_tui.ros.robots.materials import defined_materials

from .mistake import Mistake
from .robot_arguments import arguments_of, unused_arguments
from .robot_faults import faults_of_file
from .robot_joints import has_joint, no_longer_has_joint
from .robot_limits import limits_joint
from .robot_links import has_link, no_longer_has_link
from .robot_lookups import check_name, find_robot, twice
from .robots import Robot, RobotGeneration
from .run import Run


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
    check_name("robot", statement.name, where)
    for other in run.workspace.robots.values():
        if other.name == statement.name:
            message = f"a robot `{statement.name}` exists already"
            raise twice(codes.ROBOT_EXISTS, message, where, other.span)


def load_robot(run: Run, statement: st.LoadRobot) -> None:
    """Read the description of a robot, to change it."""
    run.checks.new_variable(statement, statement.variable)
    where = statement.span_of("source")
    arguments = arguments_of(statement)
    loaded = run.setting.read_robot(statement.source, arguments)
    found = [each if each.file else each._replace(span=where) for each in loaded.diagnostics]
    source = loaded.source
    if source is None:
        raise Mistake(*found)
    for other in run.workspace.robots.values():
        if other.source is not None and other.source.path == source.path:
            message = f"`{statement.source}` is loaded already"
            raise twice(codes.ROBOT_EXISTS, message, where, other.span)
    unused = unused_arguments(statement.source, arguments, loaded, statement)
    for each in (*found, *unused, *faults_of_file(source, where)):
        if each.code == codes.ROOT_INERTIA:
            continue  # the program can give it an empty root: told at its end
        # What is wrong with it can be mended by what changes it.
        is_error = each.severity is Severity.ERROR
        run.report(statement, each._replace(severity=Severity.WARNING) if is_error else each)
    run.workspace.robots[statement.variable] = Robot(
        statement.variable,
        statement.span,
        source.description,
        source,
        own_materials=defined_materials(source.description),
    )


def generate_robot(run: Run, statement: st.GenerateRobot) -> None:
    """Note that the description of a robot is to be written as it is now."""
    robot = find_robot(run, statement)
    run.workspace.written_robots.append(RobotGeneration(robot.snapshot(), statement.span))


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
