"""Python modules of other packages that only one ROS has, or that speak another way in the other.

Sources: the packages of both generations in rosdistro.
"""

from __future__ import annotations

from collections.abc import Iterator

from tree_sitter import Node

from .port_state import Work

_ROS_1_ONLY = "it is of ROS 1"
_TAKES_NODE = "its classes take the node in ROS 2"

_OF_ROS_1 = {
    "sensor_msgs.point_cloud2": "`sensor_msgs_py.point_cloud2`, whose `read_points` gives an array",
    "laser_geometry.laser_geometry": "`laser_geometry`",
    "moveit_commander": "`moveit.planning`, of `moveit_py`",
    "diagnostic_updater": _TAKES_NODE,
    "sound_play.libsoundplay": _TAKES_NODE,
    "interbotix_xs_modules": "`interbotix_xs_modules.xs_robot`",
    "ros_numpy": "`ros2_numpy`",
    "rospy_message_converter": "`rosidl_runtime_py`",
    "tf_conversions": "`tf_transformations`, or `PyKDL`",
    "baxter_interface": _ROS_1_ONLY,
    "baxter_external_devices": _ROS_1_ONLY,
    "intera_interface": _ROS_1_ONLY,
    "jsk_topic_tools": _ROS_1_ONLY,
    "aiorospy": _ROS_1_ONLY,
    "mavros": "the services of `mavros` itself",
    "ddynamic_reconfigure_python": "a callback of parameters",
    "rosserial_python": "`micro_ros`",
    "topic_tools": "its services are those of a node in ROS 2",
}
_OF_ROS_2 = {
    "sensor_msgs_py": "`sensor_msgs.point_cloud2`, whose `read_points` gives tuples",
    "diagnostic_updater": "its classes take no node in ROS 1",
    "tf_transformations": "`tf.transformations`",
    "moveit": "`moveit_commander`",
    "ros2_numpy": "`ros_numpy`",
    "rosidl_runtime_py": "`rospy_message_converter`, or `genpy`",
    "ros2topic": "`rostopic`",
    "ros2node": "`rosnode`",
    "nav2_msgs": "`move_base_msgs`",
}


def mark_other_modules(work: Work) -> None:
    """Mark the import of a module that the other ROS has not, or has with other functions."""
    known = _OF_ROS_1 if work.catalog.ros_version == 2 else _OF_ROS_2
    for tag in ("import", "import_from"):
        for statement in work.analysis.captures.get(tag, []):
            for path in _paths(work, statement) if not work.is_gone(statement) else ():
                found = next((name for name in known if f"{path}.".startswith(f"{name}.")), None)
                if found is not None:
                    work.mark(statement, found, known[found])


def _paths(work: Work, statement: Node) -> Iterator[str]:
    """Yield the modules and names that a statement imports."""
    module = statement.child_by_field_name("module_name")
    prefix = f"{work.slice(module)}." if module is not None else ""
    for each in statement.children_by_field_name("name"):
        yield prefix + work.slice(each.child_by_field_name("name") or each)
