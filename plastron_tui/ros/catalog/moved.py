"""What became of the interface types that changed between ROS 1 and ROS 2.

Sources: the ROS 2 migration guide, the changelog of `geometry_msgs` (5.8.0), the packages of both
generations in this catalog, and the definitions in `gazebo_ros_pkgs` and `vision_msgs` (noetic; 4.1
of humble).
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
    "actionlib_tutorials/Fibonacci": "example_interfaces/Fibonacci",
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
    "example_interfaces/Fibonacci": "actionlib_tutorials/Fibonacci",
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
        _name("geometry_msgs/Pose2D"): "it is gone since Lyrical: use `geometry_msgs/Pose`",
        _name("rosgraph_msgs/TopicStatistics"): "ROS 2 has statistics in `statistics_msgs`",
        _name("gazebo_msgs/SpawnModel"): "ROS 2 has `SpawnEntity`, with `name` and `xml`",
        _name("gazebo_msgs/DeleteModel"): "ROS 2 has `DeleteEntity`, with `name`",
        _name("gazebo_msgs/GetModelState"): "ROS 2 has `GetEntityState`, which gives a `state`",
        _name("gazebo_msgs/SetModelState"): "ROS 2 has `SetEntityState`, with `state`",
        _name("vision_msgs/Classification2D"): "ROS 2 has `Classification`, without an image",
        _name("vision_msgs/Classification3D"): "ROS 2 has `Classification`, without a cloud",
        _name("vision_msgs/ObjectHypothesis"): "in ROS 2 `id` is `class_id`, a text",
        _name("vision_msgs/ObjectHypothesisWithPose"): "ROS 2 has a `hypothesis` in it",
    },
    1: {
        _name("std_msgs/Header"): "in ROS 1 a header starts with `seq`, before `stamp`",
        _name("std_msgs/Byte"): "in ROS 1 a `byte` is -128 to 127, not 0 to 255",
        _name("std_msgs/ByteMultiArray"): "in ROS 1 a `byte` is -128 to 127, not 0 to 255",
        _name("sensor_msgs/CameraInfo"): "in ROS 1 the matrices are `D`, `K`, `R` and `P`",
        _name("gazebo_msgs/SpawnEntity"): "ROS 1 has `SpawnModel`, with `model_name`, `model_xml`",
        _name("gazebo_msgs/DeleteEntity"): "ROS 1 has `DeleteModel`, with `model_name`",
        _name("gazebo_msgs/GetEntityState"): "ROS 1 has `GetModelState`, which gives no `state`",
        _name("gazebo_msgs/SetEntityState"): "ROS 1 has `SetModelState`, with `model_state`",
        _name("vision_msgs/Classification"): "ROS 1 has `Classification2D`, with an image",
        _name("vision_msgs/ObjectHypothesis"): "in ROS 1 `class_id` is `id`, a number",
        _name("vision_msgs/ObjectHypothesisWithPose"): "ROS 1 has `id` and `score` in it",
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
