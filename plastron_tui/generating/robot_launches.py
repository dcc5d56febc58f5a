"""What starts the robots of packages: the nodes that publish their description and their joints."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from plastron_tui.diagnostics import Diagnostic, Label, Severity, Span, codes
from plastron_tui.model.kinds import Parameter, Publisher
from plastron_tui.model.launches import Launch, Start
from plastron_tui.model.packages import Package
from plastron_tui.model.robots import Robot
from plastron_tui.model.workspace import Node, Workspace
from plastron_tui.ros.names import parameter_name, resolved_name
from plastron_tui.ros.parameters import ParameterType, Setting
from plastron_tui.ros.robots.description import Description
from plastron_tui.ros.robots.joints import driven_joints
from plastron_tui.ros.robots.tree import roots
from plastron_tui.targets.robots.launch import JOINT_PUBLISHER, JOINT_STATES, STATE_PUBLISHER

_JOINT_STATE = ("sensor_msgs", "JointState")
_JOINT_NAMES = "joint_names"
_BASE_FRAME = "base_frame"
_SOURCES = "source_list"
"""The parameter of joint_state_publisher that names the topics which it puts together."""


class RobotStarts(NamedTuple):
    """What starts a robot, as a launch file of the program, and what is to be said of it."""

    launch: Launch
    diagnostics: tuple[Diagnostic, ...] = ()


def robot_starts(
    robot: Robot, package: Package, workspace: Workspace, ros_version: int, span: Span
) -> RobotStarts:
    """Return what starts a robot of a package.

    A node of the program that says where the joints are is started too, unless a launch file of
    the program starts it. Where none does, joint_state_publisher says it.

    Args:
        robot: the robot.
        package: the package that contains it.
        workspace: what the program built.
        ros_version: the generation of ROS of the package.
        span: the statement that puts it there.
    """
    launch = Launch(robot.stem, robot.variable, span)
    described = robot.shown
    joints = driven_joints(described)
    found = list(_tellers(package, workspace))
    topics = dict.fromkeys(topic for _, topic in found)
    told: list[Diagnostic] = []
    heard = next(iter(topics), f"/{JOINT_STATES}")
    if joints and len(topics) != 1:
        settings = ((_SOURCES, tuple(topics)),) if topics else ()
        heard = f"/{JOINT_STATES}"
        _add(launch, _other(JOINT_PUBLISHER, span, settings=settings))
    remaps = ((JOINT_STATES, heard),) if heard != f"/{JOINT_STATES}" else ()
    _add(launch, _other(STATE_PUBLISHER, span, remaps))
    started = {
        start.node.variable
        for each in workspace.launches.values()
        for start in each.starts.values()
        if start.node is not None
    }
    for node in {each.variable: each for each, _ in found}.values():
        if node.variable not in started:
            wired = tuple(_wired(node, described, joints, ros_version))
            _add(launch, _own(node, span, wired))
    told += _in_no_package(robot, workspace, ros_version, span)
    return RobotStarts(launch, tuple(told))


def _tellers(package: Package, workspace: Workspace) -> Iterator[tuple[Node, str]]:
    """Yield the nodes of a package that say where joints are, each with the topic."""
    for variable in package.contents:
        node = workspace.nodes.get(variable)
        if node is not None:
            for topic in _topics(node):
                yield node, topic


def _topics(node: Node) -> Iterator[str]:
    """Yield the topics on which a node says where joints are; one may send wishes as well."""
    for each in node.of(Publisher).values():
        topic = resolved_name(node.name, each.name)
        if each.type == _JOINT_STATE and topic.rpartition("/")[2] == JOINT_STATES:
            yield topic


def _in_no_package(
    robot: Robot, workspace: Workspace, ros_version: int, span: Span
) -> Iterator[Diagnostic]:
    """Tell the nodes that say where joints are, and that no launch file can start."""
    del ros_version
    for node in workspace.nodes.values():
        if node.home is None and any(True for _ in _topics(node)):
            yield Diagnostic(
                codes.IN_NO_PACKAGE,
                f"`{node.variable}`, which says where joints are, is in no package, and is not "
                f"started with `{robot.variable}`",
                span,
                help=f"put it into the package of `{robot.variable}`",
                severity=Severity.WARNING,
                labels=(Label(node.span, "the node"),),
            )


def _wired(
    node: Node, robot: Description, joints: tuple[str, ...], ros_version: int
) -> Iterator[tuple[str, Setting]]:
    """Yield what a node that is started with a robot has to know of it."""
    parameters = node.of(Parameter)
    names = parameters.get(parameter_name(_JOINT_NAMES, ros_version))
    if names is not None and names.holds in (None, ParameterType.STRING_LIST):
        yield _JOINT_NAMES, joints
    frame = parameters.get(parameter_name(_BASE_FRAME, ros_version))
    root = roots(robot)
    if frame is not None and frame.holds in (None, ParameterType.STRING) and len(root) == 1:
        yield _BASE_FRAME, root[0]


def _add(launch: Launch, start: Start) -> None:
    launch.starts[start.full_name] = start


def _other(
    name: str,
    span: Span,
    remaps: tuple[tuple[str, str], ...] = (),
    settings: tuple[tuple[str, Setting], ...] = (),
) -> Start:
    return Start(None, name, name, name, None, None, remaps, settings, None, span, span)


def _own(node: Node, span: Span, settings: tuple[tuple[str, Setting], ...]) -> Start:
    return Start(node, "", "", None, None, None, (), settings, None, span, span)
