"""What became of the interface types that changed between ROS 1 and ROS 2.

Sources: the ROS 2 migration guide, and the packages of both generations in this catalog.
"""

from __future__ import annotations

from collections.abc import Mapping

from plastron_tui.ros.interfaces import InterfaceName


def _name(text: str) -> InterfaceName:
    package, name = text.split("/")
    return InterfaceName(package, name)


_TO_ROS2 = {
    "beginner_tutorials/AddTwoInts": "example_interfaces/AddTwoInts",
    "rospy_tutorials/AddTwoInts": "example_interfaces/AddTwoInts",
    "roscpp_tutorials/TwoInts": "example_interfaces/AddTwoInts",
    "std_msgs/Time": "builtin_interfaces/Time",
    "std_msgs/Duration": "builtin_interfaces/Duration",
    "rosgraph_msgs/Log": "rcl_interfaces/Log",
    "tf/tfMessage": "tf2_msgs/TFMessage",
    "actionlib_msgs/GoalID": "action_msgs/GoalInfo",
    "actionlib_msgs/GoalStatus": "action_msgs/GoalStatus",
    "actionlib_msgs/GoalStatusArray": "action_msgs/GoalStatusArray",
}

_TO_ROS1 = {
    "example_interfaces/AddTwoInts": "beginner_tutorials/AddTwoInts",
    "builtin_interfaces/Time": "std_msgs/Time",
    "builtin_interfaces/Duration": "std_msgs/Duration",
    "rcl_interfaces/Log": "rosgraph_msgs/Log",
    "action_msgs/GoalInfo": "actionlib_msgs/GoalID",
    "action_msgs/GoalStatus": "actionlib_msgs/GoalStatus",
    "action_msgs/GoalStatusArray": "actionlib_msgs/GoalStatusArray",
}

_MOVED: Mapping[int, Mapping[InterfaceName, InterfaceName]] = {
    2: {_name(old): _name(new) for old, new in _TO_ROS2.items()},
    1: {_name(old): _name(new) for old, new in _TO_ROS1.items()},
}

_NOTES: Mapping[int, Mapping[InterfaceName, str]] = {
    2: {
        _name("std_msgs/Header"): "in ROS 2 a header has no `seq`, only `stamp` and `frame_id`",
        _name("std_msgs/Byte"): "in ROS 2 a `byte` is 0 to 255, not -128 to 127",
        _name("std_msgs/ByteMultiArray"): "in ROS 2 a `byte` is 0 to 255, not -128 to 127",
        _name("sensor_msgs/CameraInfo"): "in ROS 2 the matrices are `d`, `k`, `r` and `p`",
        _name("rosgraph_msgs/TopicStatistics"): "ROS 2 has statistics in `statistics_msgs`",
    },
    1: {
        _name("std_msgs/Header"): "in ROS 1 a header starts with `seq`, before `stamp`",
        _name("std_msgs/Byte"): "in ROS 1 a `byte` is -128 to 127, not 0 to 255",
        _name("std_msgs/ByteMultiArray"): "in ROS 1 a `byte` is -128 to 127, not 0 to 255",
        _name("sensor_msgs/CameraInfo"): "in ROS 1 the matrices are `D`, `K`, `R` and `P`",
    },
}


def moved(name: InterfaceName, ros_version: int = 2) -> InterfaceName | str | None:
    """Tell what to use in a ROS generation for a type of the other one.

    Args:
        name: the type as the other generation names it.
        ros_version: the generation that is wanted, 1 or 2.

    Returns:
        The type to use instead; or a sentence on what changed in a type that kept its name; or
        None when nothing is known to have changed.
    """
    return _MOVED[ros_version].get(name) or _NOTES[ros_version].get(name)
