"""Which endpoints a new one comes behind or before, and whether it depends on them."""

from __future__ import annotations

import pytest
from edits import edited, publish, subscribe


@pytest.mark.parametrize(
    "following",
    ["self.sub  # prevent unused variable warning\n", "self.sub.wait_for_x()\n",
     "self.get_logger().info('waiting')\n        self.sub.wait_for_x()\n"],
)  # fmt: skip
def test_an_endpoint_stands_behind_what_goes_with_the_one_before(following):
    text = edited(
        "from rclpy.node import Node\nfrom std_msgs.msg import String\n\n\nclass A(Node):\n"
        "    def __init__(self):\n        super().__init__('a')\n"
        "        self.sub = self.create_subscription(String, 'a', self.on_a, 10)\n"
        f"        {following}"
        "        self.count = 0\n\n    def on_a(self, msg):\n        pass\n",
        subscribe("b", callback="on_a"),
    )
    assert f"        {following}        self.b_sub = self.create_subscription(" in text


@pytest.mark.parametrize(
    ("line", "is_before"),
    [
        ("Talker(rospy.Publisher('a', String, queue_size=1)).loop()", True),
        ("talk(rospy.Publisher('a', String, queue_size=1), 3)", True),
        ("pubs.append(rospy.Publisher('a', String, queue_size=1))", False),
        ("pub, n = rospy.Publisher('a', String, queue_size=1), 3", False),
    ],
)
def test_an_endpoint_stands_before_what_may_go_on_with_another(line, is_before):
    text = edited(
        "import rospy\nfrom std_msgs.msg import String\n\n"
        f"rospy.init_node('n')\n{line}\nrospy.spin()\n",
        subscribe("b"),
    )
    new = "rospy.Subscriber('b', String, on_b)\n"
    assert (f"{new}{line}\n" if is_before else f"{line}\n{new}") in text


TRIED = """\
import rospy
from std_msgs.msg import Bool, String


class Node:
    def __init__(self):
        rospy.init_node('n')
        self.count = 1
        try:
            self.pub = rospy.Publisher('may_fail', Bool, queue_size=1)
        except ValueError:
            self.pub = None
        self.late = rospy.Publisher('late', Bool, queue_size=1)

Node()
rospy.spin()
"""


@pytest.mark.parametrize("late", ["rospy.Publisher('late', Bool, queue_size=1)", "2"])
def test_an_endpoint_is_made_whether_or_not_another_one_fails(late):
    before = TRIED.replace("rospy.Publisher('late', Bool, queue_size=1)", late)
    text = edited(before, publish("more"))
    line = next(each for each in text.splitlines() if "'more'" in each)
    assert line.startswith(" " * 8 + "self.")


def test_a_script_that_is_tried_as_a_whole_has_its_endpoints_together():
    whole = "import rospy\nfrom std_msgs.msg import String\n\n\ndef main():\n    try:\n"
    whole += "        rospy.init_node('n')\n"
    whole += "        a = rospy.Publisher('a', String, queue_size=1)\n"
    whole += "        a.publish('x')\n        rospy.spin()\n    except rospy.ROSException:\n"
    text = edited(f"{whole}        pass\n\n\nmain()\n", subscribe("b"))
    assert text.index("'a'") < text.index("'b'") < text.index("a.publish")
