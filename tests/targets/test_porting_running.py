"""What runs a node, and what ends its parts, brought from one ROS to the other."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

from plastron_tui.ros.catalog import Catalog
from plastron_tui.targets.porting.port import port_python
from plastron_tui.targets.python import read_python

MARK = "# port by hand: "
CATALOGS = {"rospy": Catalog("noetic"), "rclpy": Catalog("kilted")}
CLASS = (
    "import rclpy\nfrom rclpy.node import Node\n\n\nclass A(Node):\n"
    "    def __init__(self):\n        super().__init__('a')\n\n\n"
)


def ported(text: str, library: str, other: str) -> str:
    """Bring a file to the other library; the result is Python."""
    read = read_python(Path("node.py"), text.encode(), library).source
    assert read is not None
    result = port_python(read, CATALOGS[other], other)
    assert result.text is not None, result.diagnostics
    ast.parse(result.text)
    return result.text.decode()


SPINS = [
    ("rclpy.spin(A())", "A()\nrospy.spin()"),
    ("node = A()\nrclpy.spin(node)", "node = A()\nrospy.spin()"),
    ("rclpy.spin(node=A())", "A()\nrospy.spin()"),
    ("rclpy.spin(a := A())", "(a := A())\nrospy.spin()"),
    ("rclpy.spin(\n    A(),\n)", "A()\nrospy.spin()"),
    ("if True:\n    rclpy.spin(A())", "if True:\n    A()\n    rospy.spin()"),
    ("if True: rclpy.spin(A())", "if True: A(); rospy.spin()"),
    ("x = rclpy.spin(A())", "x = (A(), rospy.spin())[1]"),
    ("rclpy.spin(rclpy.create_node('b'))", 'rospy.init_node("b")\nrospy.spin()'),
]


@pytest.mark.parametrize(("before", "after"), SPINS)
def test_spinning_keeps_what_makes_the_node(before: str, after: str) -> None:
    text = ported(f"{CLASS}rclpy.init()\n{before}\n", "rclpy", "rospy").replace(
        f"{MARK}a second node\n", ""
    )
    assert text.endswith(f"\n{after}\n")


def test_a_name_is_free_however_many_are_taken() -> None:
    taken = "node = ros_node = _ros_node = _ros_node_2 = 1\n"
    text = ported(f"import rospy\n{taken}rospy.init_node('n')\n", "rospy", "rclpy")
    assert "\n_ros_node_3 = rclpy.create_node(" in text
