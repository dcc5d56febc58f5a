"""Default values of parameters that are functions themselves, and the scopes around them."""

from __future__ import annotations

import pytest
from edits import edited, publish

FUNCTIONS = {
    "rospy": (
        "import rospy\nfrom std_msgs.msg import String\n\n\n"
        "def main({}):\n    rospy.init_node('n')\n{}"
        "    pub = rospy.Publisher('a', String, queue_size=1)\n    rospy.spin()\n\n\nmain()\n"
    ),
    "rclpy": (
        "import rclpy\nfrom std_msgs.msg import String\n\n\n"
        "def main({}):\n    rclpy.init()\n    node = rclpy.create_node('n')\n{}"
        "    pub = node.create_publisher(String, 'a', 1)\n    rclpy.spin(node)\n\n\nmain()\n"
    ),
}


@pytest.mark.parametrize("library", FUNCTIONS)
@pytest.mark.parametrize(
    "parameters", ["f=lambda: 1", "f=lambda: 1, g=lambda x: x", "f=[i for i in '']"]
)
@pytest.mark.parametrize(
    "inner",
    ["    stop = lambda: 1\n", "    all = [i for i in '']\n", "    def stop():\n        pass\n"],
)
def test_what_sends_stands_where_it_sees_the_publisher(
    library: str, parameters: str, inner: str
) -> None:
    after = edited(FUNCTIONS[library].format(parameters, inner), publish("out", data="hi"))
    assert "\n    def publish_out(" in after
