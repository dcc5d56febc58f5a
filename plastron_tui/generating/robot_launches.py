"""What starts the robots of packages: the nodes that publish their description and their joints."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from plastron_tui.diagnostics import Diagnostic, Label, Severity, Span, codes
from plastron_tui.model.kinds import Parameter, Publisher
from plastron_tui.model.launches import Launch, Start
from plastron_tui.model.packages import Package
from plastron_tui.model.robots import Robot
from plastron_tui.model.workspace import Node, Workspace
from plastron_tui.ros.names import resolved_name
from plastron_tui.ros.parameters import ParameterType, Setting
from plastron_tui.ros.robots.description import Description
from plastron_tui.ros.robots.joints import driven_joints
from plastron_tui.ros.robots.tree import roots
from plastron_tui.targets.robots.launch import JOINT_PUBLISHER, JOINT_STATES, STATE_PUBLISHER

_JOINT_STATE = ("sensor_msgs", "JointState")
_NAMES = "name"
_JOINT_NAMES = "joint_names"
_BASE_FRAME = "base_frame"
_NONE = object()
_SOURCES = "source_list"
"""The parameter of joint_state_publisher that names the topics which it puts together."""


class RobotStarts(NamedTuple):
    """What starts a robot, as a launch file of the program, and what is to be said of it."""

    launch: Launch
    diagnostics: tuple[Diagnostic, ...] = ()


def robot_starts(
    robot: Robot, package: Package, nodes: Sequence[Node], workspace: Workspace, span: Span
) -> RobotStarts:
    """Return what starts a robot of a package.

    A node of the package that says where the joints are is started too, unless a launch file of
    the program starts it. Where no node of the program says it, joint_state_publisher does. Of
    several robots each has its own nodes: those that name joints of it, or publish in its name.

    Args:
        robot: the robot.
        package: the package that contains it.
        nodes: the nodes of the program that are for the ROS of the package.
        workspace: what the program built.
        span: the statement that puts the robot there.
    """
    launch = Launch(robot.stem, robot.variable, span)
    joints = driven_joints(robot.shown)
    robots = list(workspace.robots.values())
    heard_of = {each.variable: tuple(_told(each, robots)) for each in nodes}
    said = [
        (each, told.topic)
        for each in nodes
        for told in heard_of[each.variable]
        if robot.variable in told.robots or not told.robots
    ]
    topics = tuple(dict.fromkeys(topic for _, topic in said))
    usual = f"/{JOINT_STATES}"
    heard = topics[0] if len(topics) == 1 else usual
    if joints and len(topics) != 1:
        # It would hear itself on the topic that it publishes.
        sources = tuple(each for each in topics if each != usual)
        settings = ((_SOURCES, sources),) if sources else ()
        _add(launch, _other(JOINT_PUBLISHER, span, settings=settings))
    remaps = ((JOINT_STATES, heard),) if heard != usual else ()
    _add(launch, _other(STATE_PUBLISHER, span, remaps))
    started = {
        start.node.variable
        for each in workspace.launches.values()
        for start in each.starts.values()
        if start.node is not None
    }
    tellers = {node.variable: node for node, _ in said}
    for variable, node in tellers.items():
        if variable in package.contents and variable not in started:
            _add(launch, _own(node, span, tuple(_wired(node, robot.shown, joints))))
    apart = (node for name, node in tellers.items() if name not in package.contents)
    alone = (node for node in apart if node.home is None)
    unsure = (
        node
        for name, node in tellers.items()
        if name in package.contents and not all(told.robots for told in heard_of[name])
    )
    return RobotStarts(
        launch,
        (
            *(_in_no_package(each, robot, span) for each in alone),
            *(_of_unknown_robot(each, robots) for each in unsure),
        ),
    )


class _Told(NamedTuple):
    """A topic on which a node says where joints are, and the variables of the robots they are of.

    Without any, nobody knows of which.
    """

    topic: str
    robots: tuple[str, ...]


def _told(node: Node, robots: Sequence[Robot]) -> Iterator[_Told]:
    """Yield the topics on which a node says where joints are; one may send wishes as well."""
    for each in node.of(Publisher).values():
        topic = resolved_name(node.name, each.name)
        if each.type != _JOINT_STATE or topic.rpartition("/")[2] != JOINT_STATES:
            continue
        values = (sent.message.value.fields.get(_NAMES) for sent in each.publications)
        names = {name for value in values if isinstance(value, tuple) for name in value}
        folders = topic.split("/")
        found = [
            robot
            for robot in robots
            if not names.isdisjoint(robot.shown.joints)
            or (not names and (robot.stem in folders or robot.variable in folders))
        ]
        chosen = robots if len(robots) == 1 else found
        yield _Told(topic, tuple(robot.variable for robot in chosen))


def _of_unknown_robot(node: Node, robots: Sequence[Robot]) -> Diagnostic:
    """Tell a node that says where joints are, of which nobody knows whose they are."""
    listed = ", ".join(f"`{each.variable}`" for each in robots)
    return Diagnostic(
        codes.UNCLEAR_ROBOT,
        f"`{node.variable}` is started with each of {listed}: the program does not say which of "
        "them it tells the joints of",
        node.span,
        help=f"name joints in its message, or publish to `'{robots[0].stem}/{JOINT_STATES}'`",
    )


def _in_no_package(node: Node, robot: Robot, span: Span) -> Diagnostic:
    """Tell a node that says where joints are, and that no launch file can start."""
    return Diagnostic(
        codes.IN_NO_PACKAGE,
        f"`{node.variable}`, which says where joints are, is in no package, and is not started "
        f"with `{robot.variable}`",
        span,
        help=f"put it into the package of `{robot.variable}`",
        severity=Severity.WARNING,
        labels=(Label(node.span, "the node"),),
    )


def _wired(
    node: Node, robot: Description, joints: tuple[str, ...]
) -> Iterator[tuple[str, Setting]]:
    """Yield what a node that is started with a robot has to know of it."""
    own = {each.name.lstrip("~/"): each.holds for each in node.of(Parameter).values()}
    if own.get(_JOINT_NAMES, _NONE) in (None, ParameterType.STRING_LIST):
        yield _JOINT_NAMES, joints
    root = roots(robot)
    if own.get(_BASE_FRAME, _NONE) in (None, ParameterType.STRING) and len(root) == 1:
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
