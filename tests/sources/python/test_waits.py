"""What is new does not wait for other nodes: it comes before what does, and behind the node."""

from __future__ import annotations

import pytest
from edits import edited, provide, publish, request, subscribe

ROSPY = (
    "import rospy\nfrom std_msgs.msg import String\nfrom std_srvs.srv import Trigger\n\n\n"
    "class Arm:\n    def __init__(self):\n{}        self.is_home = False\n\n"
    "    def on_a(self, msg):\n        pass\n\n\n{}Arm()\nrospy.spin()\n"
)
RCLPY = (
    "import rclpy\nfrom rclpy.action import ActionClient\nfrom rclpy.node import Node\n"
    "from std_msgs.msg import String\nfrom std_srvs.srv import Trigger\n\n\n"
    "class Arm(Node):\n    def __init__(self):\n        super().__init__('arm')\n"
    "{}        self.is_home = False\n\n"
    "    def on_a(self, msg):\n        pass\n\n\nrclpy.init()\nrclpy.spin(Arm())\n"
)
INIT = "        rospy.init_node('arm')\n"
NEW = ("Publisher('out'", "Subscriber('out'", "Service('out'", "ServiceProxy('out'")
METHODS = ("create_publisher", "create_subscription", "create_service", "create_client")
HOME = "        self.home = rospy.ServiceProxy('home', Trigger)\n"
PUB = "        self.pub = rospy.Publisher('a', String, queue_size=1)\n"

# What `+` is in front of is there, and what is new comes there.
ROSPY_WAITS = {
    "for its service, in a class that another place starts": (
        f"+{HOME}        self.home.wait_for_service()\n",
        "rospy.init_node('arm')\n",
    ),
    "by name, and tells so": (
        f"{INIT}+        rospy.loginfo('waiting for home')\n"
        f"        rospy.wait_for_service('home')\n{HOME}",
        "",
    ),
    "behind a log of something else": (
        f"{INIT}        rospy.loginfo('the arm')\n+        rospy.wait_for_service('home')\n{HOME}",
        "",
    ),
    "under a comment": (
        f"{INIT}+        # The arm has to be there.\n        rospy.wait_for_service('home')\n",
        "",
    ),
    "where it may give up": (
        f"{INIT}+        try:\n            rospy.wait_for_service('home', 3)\n"
        "            self.home = rospy.ServiceProxy('home', Trigger)\n"
        "        except rospy.ROSException:\n            pass\n",
        "",
    ),
    "for an answer": (
        f"{INIT}+        try:\n            home = rospy.ServiceProxy('home', Trigger)\n"
        "            home()\n        except rospy.ServiceException as e:\n            print(e)\n",
        "",
    ),
    "for a topic's type": (
        f"{INIT}+        type_, topic, _ = rostopic.get_topic_class('a', blocking=True)\n"
        "        self.sub = rospy.Subscriber(topic, type_, self.on_a)\n",
        "",
    ),
    "behind other endpoints": (
        f"{INIT}{PUB}+        self.map = rospy.wait_for_message('map', String)\n",
        "",
    ),
}
RCLPY_WAITS = {
    "for a server": (
        "+        self.dock = ActionClient(self, Undock, 'undock')\n"
        "        self.dock.wait_for_server()\n"
    ),
    "in a loop": (
        "+        self.home = self.create_client(Trigger, 'home')\n"
        "        while not self.home.wait_for_service(timeout_sec=1.0):\n"
        "            self.get_logger().info('waiting')\n"
    ),
    "for an answer": (
        "+        future = self.ask()\n"
        "        rclpy.spin_until_future_complete(self, future)\n"
        "        self.tick = self.create_timer(1.0, self.ask)\n"
    ),
}
CHANGES = (publish("out"), subscribe("out"), provide("out"), request("out", "std_srvs/Trigger"))


@pytest.mark.parametrize("case", ROSPY_WAITS)
@pytest.mark.parametrize(("change", "new"), [*zip(CHANGES, NEW, strict=True)], ids=NEW)
def test_what_is_new_comes_before_a_wait(case: str, change, new: str) -> None:
    body, start = ROSPY_WAITS[case]
    above, below = body.split("+")
    after = edited(ROSPY.format(above + below, start), change)
    assert above.strip() in after.partition(new)[0]
    assert below in after.partition(new)[2]


@pytest.mark.parametrize("case", RCLPY_WAITS)
@pytest.mark.parametrize(("change", "new"), [*zip(CHANGES, METHODS, strict=True)], ids=METHODS)
def test_what_is_new_comes_before_a_wait_of_rclpy(case: str, change, new: str) -> None:
    above, below = RCLPY_WAITS[case].split("+")
    _, _, after = edited(RCLPY.format(above + below), change).partition("__init__('arm')\n" + above)
    assert new in after.splitlines()[0]
    assert below in after


STAYING = {
    "its like that has another reason to wait": (
        f"{INIT}        rospy.wait_for_message('map', String)\n{PUB}",
        publish("out"),
        PUB,
    ),
    "a callback that may use what it waits for": (
        f"{INIT}        rospy.wait_for_service('home')\n{HOME}",
        subscribe("in", callback="on_a"),
        HOME,
    ),
    "a look-up that does not wait": (
        f"{INIT}        type_, topic, _ = rostopic.get_topic_class('a')\n"
        "        rospy.Subscriber(topic, type_, self.on_a)\n",
        subscribe("in"),
        "        rospy.Subscriber(topic, type_, self.on_a)\n",
    ),
    "a service that is awaited before there is a node": (
        f"        rospy.wait_for_service('home')\n{INIT}{PUB}",
        publish("out"),
        PUB,
    ),
}


@pytest.mark.parametrize("case", STAYING)
def test_what_is_new_comes_behind(case: str) -> None:
    body, change, above = STAYING[case]
    _, _, after = edited(ROSPY.format(body, ""), change).partition(above)
    assert "'out'" in after.splitlines()[0] or "'in'" in after.splitlines()[0]


@pytest.mark.parametrize("change", CHANGES[:-1])
def test_what_is_new_comes_beside_what_does_not_wait(change) -> None:
    sub = "        self.a = self.create_subscription(String, 'a', self.on_a, 1)\n"
    body = (
        f"{sub}        name = 'home'\n        self.home = self.create_client(Trigger, name)\n"
        "        self.home.wait_for_service()\n"
    )
    _, _, after = edited(RCLPY.format(body), change).partition(sub)
    assert "'out'" in after.splitlines()[0]


def test_a_node_may_be_let_go_of_later() -> None:
    body = (
        "        pass\n\n\ndef main():\n    node = None\n    node = rclpy.create_node('n')\n"
        "    cli = node.create_client(Trigger, 'home')\n    if not cli.wait_for_service():\n"
        "        return\n    rclpy.spin(node)\n    node = None\n\n\nmain()\n"
    )
    text = "import rclpy\nfrom std_srvs.srv import Trigger\n\n\ndef work():\n"
    _, _, after = edited(text + body, provide("out")).partition("create_node('n')\n")
    assert "'out'" in after.splitlines()[0]


def test_what_is_new_does_not_use_what_comes_later() -> None:
    body = (
        "        future = self.ask()\n        rclpy.spin_until_future_complete(self, future)\n"
        "        self.group = group()\n"
        "        self.a = self.create_subscription(String, 'a', self.on_a, 1, "
        "callback_group=self.group)\n"
    )
    after = edited(RCLPY.format(body), provide("out"))
    assert after.index("'out'") < after.index("self.group =")
    assert after.count("callback_group") == 1
