"""Remaps that meet nothing, and names that a namespace moves; and those that are right."""

from __future__ import annotations

from pathlib import Path

import pytest
from graph_packages import (
    LISTENER,
    PACKAGE_XML,
    TALKER,
    code_of,
    found_in,
    in_python,
    node_of,
    package_of,
)

REMAPS = {
    "a_tuple": ({"x_py": in_python(node_of("talker", "remappings=[('chater', 'x')]"))}, 3),
    "a_list": ({"x_py": in_python(node_of("talker", "remappings=[['chater', 'x']]"))}, 3),
    "below_the_node": (
        {"x_py": in_python(node_of("talker", "remappings=[\n\n('chater', 'x')]"))},
        5,
    ),
    "a_private_name": (
        {"x_py": in_python(node_of("talker", "remappings=[('~/chatter', 'x')]"))},
        3,
    ),
    "beside_the_namespace": (
        {"x_py": in_python(node_of("talker", "namespace='r'", "remappings=[('/chatter', 'x')]"))},
        3,
    ),
    "turned_round": ({"x_py": in_python(node_of("talker", "remappings=[('x', 'chatter')]"))}, 3),
    "of_a_group": (
        {"x_py": in_python(f"GroupAction([SetRemap('chater', 'x'), {node_of('talker')}])")},
        3,
    ),
    "in_xml": (
        {
            "x_xml": '<launch>\n<node pkg="demo" exec="talker">\n<remap from="chater" to="x"/>'
            "</node></launch>"
        },
        3,
    ),
    "in_yaml": (
        {
            "x_yaml": "launch:\n- node:\n    pkg: demo\n    exec: talker\n    remap:\n"
            "    - from: chater\n      to: x\n"
        },
        6,
    ),
    "right": ({"x_py": in_python(node_of("talker", "remappings=[('chatter', 'x')]"))}, 0),
    "right_and_whole": (
        {"x_py": in_python(node_of("talker", "remappings=[('/chatter', 'x')]"))},
        0,
    ),
    "of_the_node_itself": (
        {"x_py": in_python(node_of("talker", "remappings=[('__node', 'x')]"))},
        0,
    ),
    "of_transforms": ({"x_py": in_python(node_of("talker", "remappings=[('/tf', 'tf')]"))}, 0),
    "of_a_part_of_a_name": (
        {"x_py": in_python(node_of("talker", "remappings=[('chatter/compressed', 'x')]"))},
        0,
    ),
    "of_one_node_of_a_group": (
        {
            "x_py": in_python(
                "GroupAction([SetRemap('chatter', 'x'), "
                + f"{node_of('talker')}, Node(package='other', executable='other')])"
            )
        },
        0,
    ),
}


@pytest.mark.parametrize(("launches", "line"), REMAPS.values(), ids=REMAPS)
def test_a_remap_meets_nothing(tmp_path: Path, launches: dict[str, str], line: int) -> None:
    found = found_in(tmp_path, package_of(**launches), "RG105")
    assert [at for _, _, at in found] == ([line] if line else [])


UNREAD = {
    "a_name_that_is_not_known": "self.more = self.create_publisher(String, sys.argv[1], 10)",
    "a_name_made_of_a_parameter": (
        "topic = self.declare_parameter('topic', 'x').value; "
        "self.more = self.create_publisher(String, topic + '/raw', 10)"
    ),
    "a_node_that_others_get": "helpers.add_everything(self)",
}


@pytest.mark.parametrize("more", UNREAD.values(), ids=UNREAD)
def test_a_remap_may_meet_what_is_not_read(tmp_path: Path, more: str) -> None:
    launch = in_python(node_of("talker", "remappings=[('words', 'x')]"))
    assert found_in(tmp_path, package_of(code_of(TALKER, more=more), x_py=launch), "RG105") == []


@pytest.mark.parametrize(
    ("more", "count"),
    [
        ("helpers.add_everything(self)", 1),
        ("self.more = self.create_publisher(String, 'chater', 10)", 0),
    ],
)
def test_a_remap_that_is_a_slip_is_told_whatever_else_there_is(
    tmp_path: Path, more: str, count: int
) -> None:
    launch = in_python(node_of("talker", "remappings=[('chater', 'x')]"))
    found = found_in(tmp_path, package_of(code_of(TALKER, more=more), x_py=launch), "RG105")
    assert len(found) == count


def test_a_remap_beside_that_of_the_name_that_is_near(tmp_path: Path) -> None:
    remaps = "remappings=[('chatter', 'y'), ('chater', 'x')]"
    more = "helpers.add_everything(self)"
    files = package_of(code_of(TALKER, more=more), x_py=in_python(node_of("talker", remaps)))
    assert found_in(tmp_path, files, "RG105") == []


MOVES = {
    "the_talker": (
        {"x_py": in_python(node_of("talker", "namespace='r'"), node_of("listener"))},
        [3],
    ),
    "the_listener": (
        {"x_py": in_python(node_of("talker"), node_of("listener", "namespace='r'"))},
        [4],
    ),
    "a_group": (
        {
            "x_py": in_python(
                f"GroupAction([PushRosNamespace('r'),\n{node_of('talker')}])", node_of("listener")
            )
        },
        [3],
    ),
    "a_remap_to_a_relative_name": (
        {
            "x_py": in_python(
                node_of("talker", "namespace='r'", "remappings=[('chatter', 'text')]"),
                node_of("listener", "remappings=[('chatter', 'text')]"),
            )
        },
        [3],
    ),
    "beside_what_shows_things": (
        {
            "x_py": in_python(
                node_of("talker", "namespace='r'"),
                node_of("listener"),
                "Node(package='rviz2', executable='rviz2')",
            )
        },
        [3],
    ),
    "both": (
        {
            "x_py": in_python(
                node_of("talker", "namespace='r'"), node_of("listener", "namespace='r'")
            )
        },
        [],
    ),
    "a_remap_to_a_whole_name": (
        {
            "x_py": in_python(
                node_of("talker", "namespace='r'", "remappings=[('chatter', '/chatter')]"),
                node_of("listener"),
            )
        },
        [],
    ),
    "one_of_two_talkers": (
        {
            "x_py": in_python(
                node_of("talker", "namespace='r'"), node_of("talker"), node_of("listener")
            )
        },
        [],
    ),
    "beside_what_is_not_read": (
        {
            "x_py": in_python(
                node_of("talker", "namespace='r'"),
                node_of("listener"),
                "Node(package='other', executable='other')",
            )
        },
        [3],
    ),
    "beside_what_is_moved_and_not_read": (
        {
            "x_py": in_python(
                node_of("talker", "namespace='r'"),
                node_of("listener"),
                "Node(package='other', executable='other', namespace='r')",
            )
        },
        [],
    ),
    "beside_what_is_computed": (
        {
            "x_py": in_python(
                node_of("talker", "namespace='r'"), node_of("listener"), "OpaqueFunction()"
            )
        },
        [3],
    ),
}


@pytest.mark.parametrize(("launches", "lines"), MOVES.values(), ids=MOVES)
def test_a_namespace_moves_a_name(
    tmp_path: Path, launches: dict[str, str], lines: list[int]
) -> None:
    assert [line for _, _, line in found_in(tmp_path, package_of(**launches), "RG106")] == lines


def test_a_whole_name_that_stays_where_it_is(tmp_path: Path) -> None:
    launch = in_python(node_of("talker", "namespace='r'"), node_of("listener", "namespace='r'"))
    files = package_of("", code_of(LISTENER, topic="/chatter"), x_py=launch)
    assert found_in(tmp_path, files, "RG106") == [("RG106", "x.launch.py", 3)]


OLD_XML = PACKAGE_XML.replace("ament_python", "catkin")
OLD_TALKER = """\
#!/usr/bin/env python
import rospy
from std_msgs.msg import String
rospy.init_node('talker')
pub = rospy.Publisher('chatter', String, queue_size=1)
rospy.spin()
"""
OLD_LAUNCH = (
    '<launch>\n<node pkg="demo" type="talker.py" name="talker">\n'
    '<remap from="speech" to="x"/></node></launch>'
)


def test_what_lies_in_a_package_of_ros_1_is_started(tmp_path: Path) -> None:
    files: dict[str, str | bytes] = {
        "demo/package.xml": OLD_XML,
        "demo/CMakeLists.txt": "find_package(catkin REQUIRED)\ncatkin_package()\n",
        "demo/scripts/talker.py": OLD_TALKER,
        "demo/launch/x.launch": OLD_LAUNCH,
    }
    assert found_in(tmp_path, files, "RG105") == [("RG105", "x.launch", 3)]


NEW_CPP = """\
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/string.hpp>
int main(int argc, char ** argv)
{{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("talker");
  {pub}
  rclcpp::spin(node);
}}
"""
PUB = 'auto pub = node->create_publisher<std_msgs::msg::String>("chatter", 10);'


@pytest.mark.parametrize(("pub", "count"), [(PUB, 1), ("", 0)])
def test_a_program_may_have_its_endpoints_from_a_library(
    tmp_path: Path, pub: str, count: int
) -> None:
    launch = in_python(node_of("talker", "remappings=[('speech', 'x')]"))
    files: dict[str, str | bytes] = {
        "demo/package.xml": PACKAGE_XML.replace("ament_python", "ament_cmake"),
        "demo/CMakeLists.txt": "find_package(ament_cmake REQUIRED)\n"
        "add_executable(talker src/talker.cpp)\n"
        "install(TARGETS talker DESTINATION lib/${PROJECT_NAME})\nament_package()\n",
        "demo/src/talker.cpp": NEW_CPP.format(pub=pub),
        "demo/launch/x.launch.py": launch,
    }
    assert len(found_in(tmp_path, files, "RG105")) == count
