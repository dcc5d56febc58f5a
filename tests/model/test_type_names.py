from __future__ import annotations

import pytest
from workspaces import LIBRARIES, FakeReader, catalog, codes

from plastron_tui.language import Document, lower
from plastron_tui.model.context import Setting
from plastron_tui.model.interpreter import interpret
from plastron_tui.model.types import TypeProblem, TypeResolver
from plastron_tui.ros.interfaces import InterfaceKind

MESSAGE, SERVICE, ACTION = InterfaceKind

FOUND: list[tuple[str, InterfaceKind, str | None, str | None]] = [
    *[
        (name, MESSAGE, f"std_msgs/{name}", f"std_msgs/{name}")
        for name in ("String", "Char", "Int32", "Float32")
    ],
    *[
        (name, MESSAGE, f"geometry_msgs/{name}", f"geometry_msgs/{name}")
        for name in ("Point", "Vector3", "Quaternion", "Pose2D", "Pose", "Twist")
    ],
    *[
        (name, SERVICE, f"std_srvs/{name}", f"std_srvs/{name}")
        for name in ("Empty", "SetBool", "Trigger")
    ],
    ("AddTwoInts", SERVICE, "beginner_tutorials/AddTwoInts", "example_interfaces/AddTwoInts"),
    ("Fibonacci", ACTION, "actionlib_tutorials/Fibonacci", "example_interfaces/Fibonacci"),
    ("WaypointClear", SERVICE, "mavros_msgs/WaypointClear", "mavros_msgs/WaypointClear"),
    ("WaypointPull", SERVICE, "mavros_msgs/WaypointPull", "mavros_msgs/WaypointPull"),
    ("WordCount", SERVICE, "basics/WordCount", "basics/WordCount"),
    ("geometry_msgs/Twist", MESSAGE, "geometry_msgs/Twist", "geometry_msgs/Twist"),
    ("geometry_msgs/msg/Twist", MESSAGE, "geometry_msgs/Twist", "geometry_msgs/Twist"),
    ("std_srvs/srv/Empty", SERVICE, "std_srvs/Empty", "std_srvs/Empty"),
    ("std_msgs/Empty", MESSAGE, "std_msgs/Empty", "std_msgs/Empty"),
    ("LaserScan", MESSAGE, "sensor_msgs/LaserScan", "sensor_msgs/LaserScan"),
    ("std_msgs/Time", MESSAGE, "std_msgs/Time", None),
]


@pytest.mark.parametrize(("text", "kind", "ros1", "ros2"), FOUND, ids=[case[0] for case in FOUND])
def test_a_type_is_found(
    text: str, kind: InterfaceKind, ros1: str | None, ros2: str | None
) -> None:
    for version, expected in ((1, ros1), (2, ros2)):
        found = TypeResolver(catalog(version)).resolve(text, kind)
        assert (None if isinstance(found, TypeProblem) else str(found.name)) == expected


PROBLEMS: list[tuple[str, InterfaceKind, int, str, str | None]] = [
    ("Strng", MESSAGE, 1, "unknown-type", "did you mean `String`?"),
    ("string", MESSAGE, 1, "unknown-type", "did you mean `String`?"),
    ("Xyzzy", MESSAGE, 1, "unknown-type", "`plastron types` lists"),
    ("geometry_msgs/Twst", MESSAGE, 1, "unknown-type", "did you mean `geometry_msgs/Twist`?"),
    ("geometri_msgs/Twist", MESSAGE, 2, "unknown-type", "did you mean `geometry_msgs/Twist`?"),
    ("nowhere_at_all/Twist", MESSAGE, 1, "unknown-type", "plastron.yaml"),
    ("geometry_msgs/srv/Twist", MESSAGE, 1, "unknown-type", "geometry_msgs/msg/Twist"),
    ("std_srvs/msg/Empty", SERVICE, 1, "unknown-type", "std_srvs/srv/Empty"),
    ("a/b/c", MESSAGE, 1, "unknown-type", None),
    ("Trigger", MESSAGE, 1, "unknown-type", "`Trigger` is a service type, not a message type"),
    ("String", ACTION, 2, "unknown-type", "`String` is a message type, not an action type"),
    ("Twist", SERVICE, 1, "unknown-type", "`Twist` is a message type, not a service type"),
    ("GoalStatus", MESSAGE, 2, "ambiguous-type", "action_msgs/GoalStatus"),
    ("std_msgs/Time", MESSAGE, 2, "unknown-type", None),
]


@pytest.mark.parametrize("case", PROBLEMS, ids=[case[0] for case in PROBLEMS])
def test_a_type_is_not_found(case: tuple[str, InterfaceKind, int, str, str | None]) -> None:
    text, kind, version, code, remedy = case
    found = TypeResolver(catalog(version)).resolve(text, kind)
    assert isinstance(found, TypeProblem)
    assert found.code == code
    assert remedy is None or remedy in (found.help or "")


def test_an_ambiguous_type_lists_the_packages() -> None:
    found = TypeResolver(catalog(2)).resolve("GoalStatus", MESSAGE)
    assert isinstance(found, TypeProblem)
    assert found.help is not None
    assert "action_msgs/GoalStatus" in found.help
    assert "actionlib_msgs/GoalStatus" in found.help


def test_a_message_names_the_ros() -> None:
    for version, ros in ((1, "ROS 1 noetic"), (2, "ROS 2")):
        found = TypeResolver(catalog(version)).resolve("Xyzzy", MESSAGE)
        assert isinstance(found, TypeProblem)
        assert f"no message type `Xyzzy` is known in {ros}" in found.message


def test_the_other_ros_is_offered_where_nobody_chose_this_one() -> None:
    text = b"create_message m of message_type builtin_interfaces/Time and input none\n"
    for is_chosen in (True, False):
        setting = Setting("rospy", LIBRARIES, catalog, FakeReader(), is_chosen)
        (found,) = interpret(lower(Document(text)), setting).diagnostics
        assert found.code == "unknown-type"
        assert ("use `--target rclpy`" in (found.help or "")) is not is_chosen


def test_the_other_ros_is_no_remedy_for_a_node_that_says_which() -> None:
    text = b"create_node 'a' as n using rclpy\nsubscribe n to 'a' of message_type std_msgs/Time\n"
    setting = Setting("rospy", LIBRARIES, catalog, FakeReader(), is_chosen=False)
    (found,) = interpret(lower(Document(text)), setting).diagnostics
    assert found.code == "unknown-type"
    assert "--target" not in (found.help or "")


def test_the_library_decides_where_a_type_is_looked_up() -> None:
    text = "create_node 'a' as n{}\nsubscribe n to 'a' of message_type std_msgs/Time\n"
    assert codes(text.format("")) == []
    assert codes(text.format(" using rclpy")) == ["unknown-type"]
    assert codes(text.format(""), "rclpy") == ["unknown-type"]
    assert codes(text.format(" using roscpp"), "rclpy") == []
