"""What moves in a robot."""

from __future__ import annotations

from .description import Description, JointType

_DRIVEN = (JointType.REVOLUTE, JointType.CONTINUOUS, JointType.PRISMATIC)


def driven_joints(robot: Description) -> tuple[str, ...]:
    """Return the joints whose place somebody has to say (`sensor_msgs/JointState`).

    A joint that follows another one is where that one puts it, and robot_state_publisher knows
    (`joint_state_listener.cpp`); what moves in several directions has no single place.
    """
    joints = robot.joints.values()
    return tuple(each.name for each in joints if each.type in _DRIVEN and each.mimic is None)
