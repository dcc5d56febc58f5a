"""What `calling` may name: a function of the file that takes what ROS gives it, or a new name."""

from __future__ import annotations

import pytest
from edits import edit, edited, provide, subscribe

ROSPY = """\
import os.path
import rospy
from std_msgs.msg import String


def module_one(msg):
    pass


def module_none():
    pass


class A:
    limit = 3

    def __init__(self, name="a"):
        self.pub = rospy.Publisher("pub", String, queue_size=1)
        rospy.Subscriber("a", String, self.one)

    def one(self, msg):
        pass

    def none(self):
        pass

    def two(self, msg, args):
        pass

    def two_with_default(self, msg, args=None):
        pass

    def any(self, *args):
        pass

    def named(self, msg, *, loud=False):
        pass

    @staticmethod
    def static(msg):
        pass

    @classmethod
    def of_class(cls, msg):
        pass

    @wrapped
    def wrapped(self):
        pass

    @property
    def mode(self):
        return 1


rospy.init_node("a")
A()
rospy.spin()
"""
RCLPY = (
    ROSPY.replace("import rospy", "import rclpy\nfrom rclpy.node import Node")
    .replace("class A:", "class A(Node):")
    .replace('rospy.Publisher("pub", String, queue_size=1)',
             'self.create_publisher(String, "pub", 1)')
    .replace('rospy.Subscriber("a", String, self.one)',
             'self.create_subscription(String, "a", self.one, 1)')
    .replace('rospy.init_node("a")\nA()\nrospy.spin()', "rclpy.init()\nrclpy.spin(A())")
    .replace('    def __init__(self, name="a"):\n',
             '    def __init__(self, name="a"):\n        super().__init__("a")\n')
)  # fmt: skip
NODES = {"rospy": ROSPY, "rclpy": RCLPY}
SCRIPTS = {
    "rospy": "import rospy\nfrom std_msgs.msg import String\nrospy.init_node('n')\nwall = 3\n"
    "sub = rospy.Subscriber('a', String, print)\n\n\ndef later(msg):\n    pass\n\n\n"
    "rospy.spin()\n\n\ndef last(msg):\n    pass\n",
    "rclpy": "import rclpy\nfrom std_msgs.msg import String\nrclpy.init()\nwall = 3\n"
    "node = rclpy.create_node('n')\nsub = node.create_subscription(String, 'a', print, 1)\n\n\n"
    "def later(msg):\n    pass\n\n\nrclpy.spin(node)\n\n\ndef last(msg):\n    pass\n",
}
EVERY = ("one", "two_with_default", "any", "named", "static", "of_class", "wrapped")


@pytest.mark.parametrize("library", NODES)
@pytest.mark.parametrize("name", EVERY)
def test_a_function_that_takes_a_message_is_called(library: str, name: str) -> None:
    if library == "rclpy":
        edited(NODES[library], subscribe("x", callback="two"))
    assert edited(NODES[library], subscribe("x", callback=name)).count("def ") == NODES[
        library
    ].count("def ")


@pytest.mark.parametrize(
    ("library", "change", "text"),
    [
        (
            "rospy",
            subscribe("x", callback="none"),
            "takes no arguments, and would be called with 1",
        ),
        ("rospy", subscribe("x", callback="two"), "takes 2 arguments, and would be called with 1"),
        ("rospy", provide("x", handler="two"), "takes 2 arguments, and would be called with 1"),
        ("rospy", subscribe("x", callback="module_none"), "takes no arguments"),
        (
            "rclpy",
            subscribe("x", callback="none"),
            "takes no arguments, and would be called with 1",
        ),
        ("rclpy", provide("x", handler="one"), "takes 1 argument, and would be called with 2"),
        ("rclpy", provide("x", handler="module_one"), "takes 1 argument"),
        *(
            (library, subscribe("x", callback=name), text)
            for library in NODES
            for name, text in (
                ("pub", "sets the attribute `pub` to something else"),
                ("limit", "sets the attribute `limit` to something else"),
                ("mode", "is a property"),
                ("os", "is imported in line 1"),
                ("String", "is imported in line"),
                ("print", "is a name of Python itself"),
                ("__len__", "has a meaning of its own"),
            )
        ),
    ],
)
def test_what_cannot_be_called_is_told(library: str, change, text: str) -> None:
    (found,) = edit(NODES[library], change).diagnostics
    assert found.code == "invalid-function"
    assert text in found.message
    assert found.help is not None


@pytest.mark.parametrize("library", SCRIPTS)
@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("last", "after the line that would use it"),
        ("wall", "is something else in line 4"),
        ("print", "is a name of Python itself"),
    ],
)
def test_what_a_script_has_not_yet_is_told(library: str, name: str, text: str) -> None:
    (found,) = edit(SCRIPTS[library], subscribe("x", callback=name)).diagnostics
    assert found.code == "invalid-function"
    assert text in found.message


@pytest.mark.parametrize("library", SCRIPTS)
def test_a_script_uses_a_function_behind_its_definition(library: str) -> None:
    after = edited(SCRIPTS[library], subscribe("x", callback="later"))
    assert after.index("def later") < after.index("'x'") < after.index(".spin(")


@pytest.mark.parametrize("library", SCRIPTS)
def test_the_method_of_another_object_is_called_as_it_is(library: str) -> None:
    text = SCRIPTS[library].replace("print", "robot.arm.hear")
    after = edited(text, subscribe("x", callback="hear"))
    assert after.count("robot.arm.hear") == 2
    assert "def hear" not in after
