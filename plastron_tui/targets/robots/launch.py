"""What starts a robot: the launch file that publishes its description.

Sources: the wiki pages "robot_state_publisher" and "joint_state_publisher", and their README files
for ROS 2; "roslaunch/XML/param" for ROS 1. Of ROS 2, launch reads a file by itself since Jazzy
(`launch.substitutions.FileContent`). In both, a command is split into words as a shell does it
(`roslaunch.loader`, `launch.substitutions.Command`).
"""

from __future__ import annotations

import shlex
from dataclasses import replace
from typing import NamedTuple

from plastron_tui.ros.launch import Item, LaunchFile, ParameterValue, SetParameter, StartedNode
from plastron_tui.ros.launch_text import Kind, Substitution, Text, package_file, text
from plastron_tui.ros.robots.macros import Arguments

STATE_PUBLISHER = "robot_state_publisher"
JOINT_PUBLISHER = "joint_state_publisher"
JOINT_STATES = "joint_states"
"""The topic that robot_state_publisher hears the places of joints from."""

_DESCRIPTION = "robot_description"
_BEFORE_JAZZY = ("foxy", "galactic", "humble", "iron")


class DescribedRobot(NamedTuple):
    """A robot's description in a package.

    Attributes:
        package: the package.
        path: where the description is in it.
        is_macros: whether it has to be expanded by xacro.
        arguments: what xacro is to give its macros.
    """

    package: str
    path: str
    is_macros: bool = False
    arguments: Arguments = ()


def with_description(
    launch: LaunchFile, robot: DescribedRobot, ros_version: int, distribution: str
) -> LaunchFile:
    """Return a launch file whose robot_state_publisher knows what robot there is.

    Args:
        launch: what is started: robot_state_publisher among it.
        robot: the robot.
        ros_version: the generation of ROS.
        distribution: the distribution.
    """
    value = _description(robot, ros_version, distribution)
    parameter = ParameterValue(text(_DESCRIPTION), value, is_text=True)
    if ros_version == 1:
        return LaunchFile((SetParameter(parameter), *launch.items))
    return LaunchFile(tuple(_with_parameter(each, parameter) for each in launch.items))


def _with_parameter(item: Item, parameter: ParameterValue) -> Item:
    if isinstance(item, StartedNode) and item.package.literal == STATE_PUBLISHER:
        return replace(item, parameters=(parameter, *item.parameters))
    return item


def _description(robot: DescribedRobot, ros_version: int, distribution: str) -> Text:
    path = package_file(robot.package, robot.path)
    if robot.is_macros:
        given = "".join(f" {name}:={shlex.quote(value)}" for name, value in robot.arguments)
        return Text((Substitution(Kind.COMMAND, text("xacro ", path, given)),))
    if ros_version == 2 and distribution in _BEFORE_JAZZY:
        return Text((Substitution(Kind.COMMAND, text("cat ", path)),))
    return Text((Substitution(Kind.CONTENT, path),))
