"""What many runs have: names that ROS itself uses, and programs that launch files start.

Sources: the ROS wiki pages and the READMEs of the packages.
"""

from __future__ import annotations

from collections.abc import Iterable

from plastron_tui.ros.interfaces import InterfaceName
from plastron_tui.ros.launch_started import Started

IS_EVERYWHERE = frozenset(
    {"/tf", "/tf_static", "/rosout", "/rosout_agg", "/parameter_events", "/clock", "/diagnostics"}
)
"""Topics that ROS, its tools or libraries of nodes send or hear."""

OWN_PACKAGES = frozenset(
    {
        "rcl_interfaces", "lifecycle_msgs", "composition_interfaces", "type_description_interfaces",
        "service_msgs", "rosgraph_msgs", "roscpp", "nodelet", "dynamic_reconfigure", "tf2_msgs",
    }
)  # fmt: skip
"""Packages of types whose topics and services each node has by itself."""

OWN_SERVICES = frozenset(
    {
        "describe_parameters", "get_parameter_types", "get_parameters", "list_parameters",
        "set_parameters", "set_parameters_atomically", "get_type_description", "change_state",
        "get_state", "get_available_states", "get_available_transitions", "get_transition_graph",
        "transition_event", "set_logger_level", "get_loggers", "parameter_updates",
        "parameter_descriptions", "get_logger_levels", "set_logger_levels",
    }
)  # fmt: skip
"""The last words of the names of topics and services that each node has by itself."""

_TRANSFORMS = frozenset({"tf2_msgs/TFMessage", "tf/tfMessage"})
_POSES = frozenset(
    {
        "geometry_msgs/PoseStamped", "geometry_msgs/PoseWithCovarianceStamped",
        "geometry_msgs/PointStamped",
    }
)  # fmt: skip
_JOINTS = frozenset({"sensor_msgs/JointState", "std_msgs/String"})
_MOTION = frozenset({"geometry_msgs/Twist", "geometry_msgs/TwistStamped", "sensor_msgs/Joy"})

_SENT: dict[str, frozenset[str]] = {
    "tf": _TRANSFORMS,
    "tf2_ros": _TRANSFORMS,
    "robot_state_publisher": _JOINTS | _TRANSFORMS,
    "joint_state_publisher": _JOINTS,
    "joint_state_publisher_gui": _JOINTS,
    "rviz": _POSES,
    "rviz2": _POSES,
    "rqt_graph": frozenset(),
    "rqt_plot": frozenset(),
    "rqt_image_view": frozenset(),
    "image_view": frozenset(),
    "joy": frozenset({"sensor_msgs/Joy", "sensor_msgs/JoyFeedbackArray"}),
    "teleop_twist_joy": _MOTION,
    "teleop_twist_keyboard": _MOTION,
}
"""The types that the programs of a package send or ask for, at most; what shows things hears
whatever it is told to."""


def may_use(others: Iterable[Started], type_: InterfaceName) -> bool:
    """Tell whether a program that was not read may be the other side of what has a type."""
    return any(
        str(type_) in _SENT[each.package] if each.package in _SENT else True for each in others
    )
