"""What rospy and rclpy make of the arguments of a node, which need no graph for that."""

from __future__ import annotations

import json
import os
import subprocess
from collections.abc import Iterator
from typing import Any

import pytest
from machine import find_ros

from plastron_tui.ros.names import name_as_written
from plastron_tui.ros.parameter_values import parse_value
from plastron_tui.ros.parameters import Setting
from plastron_tui.ros.run_names import Remap, RunNames, parse_remap
from plastron_tui.runtime.arguments import ros_arguments
from plastron_tui.runtime.environment import node_environ

pytestmark = pytest.mark.live

ROS1 = """
import json, sys
import rospy.client, rospy.names
from rosgraph.names import get_ros_namespace, ns_join
names = json.load(sys.stdin)
node = ns_join(get_ros_namespace(), "n")
rospy.names.initialize_mappings(node)
values = rospy.client.load_command_line_node_params(sys.argv)
print(json.dumps([[rospy.names.resolve_name(name, node) for name in names], values]))
"""

ROS2 = """
import json, sys
import rclpy
from rclpy.node import Node
names = json.load(sys.stdin)
rclpy.init(args=sys.argv)
node = Node("n", automatically_declare_parameters_from_overrides=True)
values = {name: each.value for name, each in node._parameters.items()}
values = {name: each if type(each) in (bool, int, float, str) else list(each)
          for name, each in values.items()}
print(json.dumps([[node.resolve_topic_name(name) for name in names], values]))
rclpy.shutdown()
"""

TEXTS = [
    *("0.8", "-3", "+5", "0x1f", "-0x1f", "010", "08", "1.", ".5", "1e5", "-.inf", "inf"),
    *("infinity", "99999999999999999999", "1e999", "1_0", "1:30", "2020-01-01", "0o7", "y", "N"),
    *("yes", "OFF", "tRUE", "null", "~", '""', '"0.8"', "'yes'", "!!str 5", "two words"),
    *("[1, 2]", "[1.0, -2.5]", "[true, no]", '[a, "1"]', "a:=b", '"a\\tb\\u00e9"', ".Nan"),
]
VALUES: list[Setting] = [
    *("", " ", "0.8", "yes", "a:=b", '"', "'", "\\", "# no", "$(x) `y` ; *", "é😀", "a\nb\tc"),
    *(-3, -0.5, 1e-7, 1e22, True, ("", "a, b"), (1,), (0.5, 1e300), (False,), "--ros-args"),
]


def told(
    version: int, names: list[str], arguments: tuple[str, ...]
) -> tuple[list[str], dict[str, Any]]:
    environment = find_ros(version)
    done = subprocess.run(
        [environment.python, "-c", ROS1 if version == 1 else ROS2, *arguments],
        input=json.dumps(names),
        env=node_environ(environment, os.environ),
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    resolved, values = json.loads(done.stdout)
    kept = ("use_sim_time", "start_type_description_service")
    return resolved, {name: each for name, each in values.items() if name not in kept}


def listed(value: Setting) -> Any:
    return list(value) if isinstance(value, tuple) else value


def test_a_text_has_the_type_that_ros2_gives_it() -> None:
    texts = {f"p{at}": text for at, text in enumerate(TEXTS)}
    given = [word for name, text in texts.items() for word in ("-p", f"{name}:={text}")]
    _, values = told(2, [], ("--ros-args", *given))
    found = {name: parse_value(text) for name, text in texts.items()}
    # Types count: 1 is not 1.0, nor True.
    assert {name: repr(listed(each)) for name, each in found.items()} == {
        name: repr(each) for name, each in values.items()
    }


@pytest.mark.parametrize("version", [1, 2])
def test_values_arrive_as_they_are(version: int) -> None:
    values = {f"p{at}": value for at, value in enumerate(VALUES)}
    _, found = told(version, [], ros_arguments(version, RunNames(), values))
    assert {name: repr(each) for name, each in found.items()} == {
        name: repr(listed(each)) for name, each in values.items()
    }


def rules() -> Iterator[RunNames]:
    for namespace in (None, "", "/r", "/r/s"):
        for texts in (
            ["a:=b", "b:=c", "~/x:=/y", "/r/z:=q", "k/l:=~/m"],
            ["/a:=b", "~/x:=~/y", "b:=/a"],
        ):
            found = [parse_remap(text) for text in texts]
            yield RunNames(namespace, tuple(each for each in found if isinstance(each, Remap)))


@pytest.mark.long
@pytest.mark.parametrize("version", [1, 2])
def test_names_are_resolved_as_ros_does(version: int) -> None:
    names = ["a", "b", "/a", "/b", "~/x", "~/y", "z", "/r/z", "k/l", "/k/l", "/r/n/x"]
    for given in rules():
        written = [name_as_written(name, version) for name in names]
        found, _ = told(version, written, ros_arguments(version, given, {}))
        assert found == [given.resolved("n", name) for name in names], given
