"""Edits in functions that import, return or hold what an edit has to do with, before → after."""

from __future__ import annotations

import pytest
from edits import AT, edited, provide, publish, request, subscribe

from plastron_tui.model.source import Add, EndpointKind, Remove

LISTEN = subscribe("in")
SEND = publish("out", data="hi")
CALL = request("call", "std_srvs/Trigger")
SERVE = provide("serve")

RETURNED = """\
import rospy
from std_msgs.msg import String


def listen(topic, callback):
    return rospy.Subscriber(topic, String, callback)


if __name__ == '__main__':
    rospy.init_node('n')
    subs = [listen('a', print)]
    rospy.spin()
"""
LIBRARY = RETURNED[: RETURNED.index("\n\nif __name__")]
BRANCHES = """\
import rospy
from std_msgs.msg import Bool


def main(is_dry):
    rospy.init_node('n')
    if is_dry:
        print('dry')
    else:
        pub = rospy.Publisher('on', Bool, queue_size=1)
        while not rospy.is_shutdown():
            pub.publish(True)
            rospy.sleep(1)
"""
LOCAL_BLOCK = """\
class Mixin:
    def start(self):
        from std_msgs.msg import Bool
        self.low = self.create_publisher(Bool, 'low', 1)

    def check(self, level):
        if level < 3:
            from std_msgs.msg import Bool
            self.low.publish(Bool(data=True))
"""
LOCAL = """\
import rclpy


class Bridge:
    def run(self):
        from rclpy.node import Node
        from std_msgs.msg import String

        node = Node('bridge')
        self.sub = node.create_subscription(String, 'a', self.on_a, 10)
        rclpy.spin(node)

    def on_a(self, msg):
        print(msg.data)
"""
LAZY = """\
def main():
    import rospy
    from std_srvs.srv import Trigger, TriggerRequest

    rospy.init_node('n')
    rospy.spin()


main()
"""
OTHER_STRING = """\
import rclpy


def main():
    from example_interfaces.msg import String

    node = rclpy.create_node('n')
    pub = node.create_publisher(String, 'a', 10)
    rclpy.spin(node)
"""
STAR = """\
from robot_tools import *
rospy.init_node('n')
rospy.Subscriber('x', String, on_x)
"""
TYPES = """\
import rospy
from std_msgs.msg import Bool, String

TYPES = {"String": str, "Bool": bool}


def f() -> None:
    pass


rospy.init_node('n')
rospy.Publisher('b', Bool)
rospy.Publisher('a', String)
"""
TUPLES = """\
import rospy
from std_msgs.msg import String


class A:
    def __init__(self):
        self.a, self.b = (rospy.Publisher('a', String),
                          rospy.Publisher('b', String))
        self.a.publish('x')


rospy.init_node('n')
A()
"""

CASES = {
    "what is returned is no place to stand behind": (
        RETURNED,
        LISTEN,
        [
            ("callback)\n", "callback)\n\n\ndef in_callback(message):\n"
                            "    rospy.loginfo('in: %s', message)\n"),
            ("node('n')\n", "node('n')\n    rospy.Subscriber('in', String, in_callback)\n"),
        ],
    ),
    "a method that does not see the node prints": (
        LOCAL,
        LISTEN,
        [
            ("on_a, 10)\n", "on_a, 10)\n        self.in_sub = "
                            "node.create_subscription(String, 'in', self.on_in, 10)\n"),
            ("msg.data)\n", "msg.data)\n\n    def on_in(self, msg):\n"
                            "        print(f'in: {msg}')\n"),
        ],
    ),
    "a timer stands where the node is seen": (
        LOCAL,
        SEND,
        [(
            "on_a, 10)\n",
            "on_a, 10)\n        self.out_pub = node.create_publisher(String, 'out', 10)\n\n"
            "        def publish_out():\n"
            "            message = String(data='hi')\n"
            "            self.out_pub.publish(message)\n\n"
            "        self.out_timer = node.create_timer(0.1, publish_out)\n",
        )],
    ),
    "what a function imports is not imported again": (
        LAZY,
        CALL,
        [(
            "node('n')\n",
            "node('n')\n    call_client = rospy.ServiceProxy('call', Trigger)\n\n"
            "    def call_call(event):\n"
            "        \"\"\"Call call within 10 s, and log its answer.\"\"\"\n"
            "        try:\n"
            "            call_client.wait_for_service(timeout=10.0)\n"
            "            response = call_client(TriggerRequest())\n"
            "            rospy.loginfo('call: %s', response)\n"
            "        except (rospy.ROSException, rospy.ServiceException) as error:\n"
            "            rospy.logerr('call: %s', error)\n\n"
            "    rospy.Timer(rospy.Duration(0.1), call_call, oneshot=True)\n",
        )],
    ),
    "a local name of another package is not hidden": (
        OTHER_STRING,
        LISTEN,
        [
            ("import rclpy\n", "import rclpy\nfrom rclpy.logging import get_logger\n"
                               "from std_msgs.msg import String as StdMsgsString\n"
                               "\n\ndef on_in(message):\n"
                               "    get_logger('n').info(f'in: {message}')\n"),
            ("'a', 10)\n", "'a', 10)\n"
                           "    node.create_subscription(StdMsgsString, 'in', on_in, 10)\n"),
        ],
    ),
    "a name that a star import may bring is not hidden": (
        STAR,
        LISTEN,
        [
            ("import *\n", "import *\nfrom std_msgs.msg import String as StdMsgsString\n"),
            ("on_x)\n", "on_x)\nrospy.Subscriber('in', StdMsgsString, on_in)\n"),
            ("rospy.init", "\n\ndef on_in(message):\n    rospy.loginfo('in: %s', message)\n\n\n"
                           "rospy.init"),
        ],
    ),
    "a word in a dictionary keeps no import": (
        TYPES,
        Remove(EndpointKind.PUBLISHER, "a", AT),
        [("Bool, String\n", "Bool\n"), ("rospy.Publisher('a', String)\n", "")],
    ),
    "an import of a function goes with its last use": (
        LOCAL,
        Remove(EndpointKind.SUBSCRIPTION, "a", AT),
        [
            ("        from std_msgs.msg import String\n", ""),
            ("        self.sub = node.create_subscription(String, 'a', self.on_a, 10)\n", ""),
        ],
    ),
    "a block that loses its import too": (
        LOCAL_BLOCK,
        Remove(EndpointKind.PUBLISHER, "low", AT),
        [
            ("        from std_msgs.msg import Bool\n        self.low = self.create_publisher"
             "(Bool, 'low', 1)\n", "        pass\n"),
            ("            from std_msgs.msg import Bool\n            self.low.publish"
             "(Bool(data=True))\n", "            pass\n"),
        ],
    ),
    "in the branch where the node runs": (
        BRANCHES,
        SEND,
        [
            ("import Bool\n", "import Bool, String\n"),
            ("queue_size=1)\n", "queue_size=1)\n        out_pub = "
                                "rospy.Publisher('out', String, queue_size=1)\n"),
            ("publish(True)\n", "publish(True)\n            "
                                "out_pub.publish(String(data='hi'))\n"),
        ],
    ),
    "one of a tuple in brackets": (
        TUPLES,
        Remove(EndpointKind.PUBLISHER, "b", AT),
        [("self.a, self.b =", "self.a ="),
         (",\n                          rospy.Publisher('b', String))", ")")],
    ),
}  # fmt: skip


@pytest.mark.parametrize("case", CASES)
def test_the_surroundings_are_seen(case: str) -> None:
    before, change, replacements = CASES[case]
    after = before
    for old, new in replacements:
        assert after.count(old) == 1, old
        after = after.replace(old, new)
    assert edited(before, change) == after


@pytest.mark.parametrize("change", [LISTEN, SEND, CALL, SERVE])
@pytest.mark.parametrize("annotation", ['"Node"', '"rclpy.node.Node"', "Node", "Any"])
def test_a_node_with_an_annotation_is_found_again(change: Add, annotation: str) -> None:
    text = LOCAL.replace("node = ", f"node: {annotation} = ")
    assert edited(text, change) != text
