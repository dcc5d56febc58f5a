"""Messages go into a loop or a timer of the file only if it surely runs for as long as the node."""

from __future__ import annotations

import re

import pytest
from edits import edit, edited, publish

ROSPY = "import rospy\nfrom std_msgs.msg import String\n\n\n"
RCLPY = "import rclpy\nfrom rclpy.node import Node\nfrom std_msgs.msg import String\n\n\n"

SCRIPT = (
    f"{ROSPY}rospy.init_node('n')\npub = rospy.Publisher('a', String, queue_size=1)\n"
    "rate = rospy.Rate(5)\n{}rospy.spin()\n"
)
MAIN = (
    f"{RCLPY}rclpy.init()\nnode = rclpy.create_node('n')\n"
    "pub = node.create_publisher(String, 'a', 1)\nrate = node.create_rate(5)\n{}"
)
CALLBACK = (
    f"{ROSPY}class A:\n    def __init__(self):\n"
    "        self.pub = rospy.Publisher('a', String, queue_size=1)\n"
    "        rospy.Subscriber('b', String, self.on_b)\n\n"
    "    def on_b(self, msg):\n        rate = rospy.Rate(5)\n"
    "        while not rospy.is_shutdown():\n            rate.sleep()\n\n{}\n\n"
    "rospy.init_node('n')\nA()\nrospy.spin()\n"
)
RUN = (
    f"{ROSPY}class A:\n    def __init__(self):\n"
    "        self.pub = rospy.Publisher('a', String, queue_size=1)\n\n"
    "    def run(self):\n        rate = rospy.Rate(5)\n"
    "        while not rospy.is_shutdown():\n            rate.sleep()\n\n\n"
    "rospy.init_node('n')\na = A()\n{}"
)
TICK = (
    f"{RCLPY}class A(Node):\n    def __init__(self):\n        super().__init__('a')\n"
    "        self.timer = self.create_timer({})\n\n"
    "    def tick(self):\n{}\n\nrclpy.init()\nrclpy.spin(A())\n"
)
TICK_1 = (
    f"{ROSPY}def tick(event):\n    print(event)\n\n\n"
    "rospy.init_node('n')\nrospy.Timer(rospy.Duration(0.2), tick{})\nrospy.spin()\n"
)
WHILE = "while not rospy.is_shutdown():\n    {}\n    rate.sleep()\n"

OWN = {
    "until ROS shuts down": SCRIPT.format(WHILE.format("print()")),
    "the node's own among those that wait": SCRIPT.format(
        "while not rospy.is_shutdown() and pub.get_num_connections() == 0:\n    rate.sleep()\n"
        + WHILE.format("print()")
    ),
    "for ever": SCRIPT.format("while 1:\n    print()\n    rate.sleep()\n"),
    "left when it is interrupted": SCRIPT.format(
        "while not rospy.is_shutdown():\n    try:\n        print()\n        rate.sleep()\n"
        "    except rospy.ROSInterruptException:\n        break\n"
    ),
    "with a loop in it that ends": SCRIPT.format(
        WHILE.format("for each in 'ab':\n        if each:\n            continue")
    ),
    "that does not wait for what comes": MAIN.format(
        "while rclpy.ok():\n    rclpy.spin_once(node, timeout_sec=0)\n    rate.sleep()\n"
    ),
    "in a method that is run once": RUN.format("a.run()\n"),
    "a timer": TICK.format("0.2, self.tick", "        print()\n"),
    "a timer in a callback group": TICK.format("0.2, self.tick, None", "        print()\n"),
    "a timer that goes on": TICK_1.format(", oneshot=False"),
    "a timer that goes on, by position": TICK_1.format(", False"),
    "a timer that returns at its end": TICK.format("0.2, self.tick", "        return\n"),
    "one that spinning wakes": MAIN.format(
        "while rclpy.ok():\n    rclpy.spin_once(node)\n    rate.sleep()\n"
    ),
}
OTHERS = {
    "one that begins when another ends": SCRIPT.format(
        "while True:\n    try:\n        rate.sleep()\n    except E:\n        break\n"
        + WHILE.format("pub.publish('x')")
    ),
    "until somebody listens": SCRIPT.format(
        "while pub.get_num_connections() == 0:\n    rate.sleep()\n"
    ),
    "until it is ready": SCRIPT.format(
        "while not rospy.is_shutdown() and not ready:\n    rate.sleep()\n"
    ),
    "again until it works": SCRIPT.format(
        "while not rospy.is_shutdown():\n    try:\n        connect()\n        break\n"
        "    except IOError:\n        rate.sleep()\n"
    ),
    "ended early": SCRIPT.format(WHILE.format("if done():\n        break")),
    "rounds that end early": SCRIPT.format(WHILE.format("if not seen:\n        continue")),
    "rounds that fail": SCRIPT.format(
        "while not rospy.is_shutdown():\n    try:\n        look()\n        rate.sleep()\n"
        "    except LookupError:\n        pass\n"
    ),
    "without a rate": SCRIPT.format("while not rospy.is_shutdown():\n    print()\n"),
    "at a rate in one branch": SCRIPT.format(
        "while not rospy.is_shutdown():\n    if seen:\n        rate.sleep()\n"
    ),
    "that waits for a key": SCRIPT.format(WHILE.format("key = input()")),
    "that waits in it": SCRIPT.format(WHILE.format("while busy:\n        pass")),
    "as often as something comes": MAIN.format("while rclpy.ok():\n    rclpy.spin_once(node)\n"),
    "in a callback": CALLBACK.format(""),
    "in a method that is run when asked": RUN.format("if input():\n    a.run()\nrospy.spin()\n"),
    "in a thread": RUN.format("Thread(target=a.run).start()\nrospy.spin()\n"),
    "a timer that starts later": TICK.format("0.2, self.tick, autostart=False", "        pass\n"),
    "a timer that ends": TICK.format("0.2, self.tick", "        self.timer.cancel()\n"),
    "a timer that is taken away": TICK.format(
        "0.2, self.tick", "        self.destroy_timer(self.timer)\n"
    ),
    "a timer that is shut down": TICK_1.format("").replace("print(event)", "t.shutdown()"),
    "a timer of what cannot see it": TICK_1.format("").replace(
        "rospy.Timer",
        "class A:\n    def __init__(self):\n"
        "        self.pub = rospy.Publisher('a', String, queue_size=1)\n\n\nA()\nrospy.Timer",
    ),
    "on one line": SCRIPT.format("while not rospy.is_shutdown(): rate.sleep()\n"),
    "a timer that returns early": TICK.format(
        "0.2, self.tick", "        if self.x:\n            return\n        print()\n"
    ),
    "a function that others call": TICK.format(
        "0.2, self.tick", "        print()\n\n    def now(self):\n        self.tick()\n"
    ),
    "a timer that runs once": TICK_1.format(", oneshot=True"),
    "a timer that runs once, by position": TICK_1.format(", True"),
}


@pytest.mark.parametrize("case", OWN)
def test_a_message_goes_into_the_loop_of_the_node(case: str) -> None:
    after = edited(OWN[case], publish("out", data="hi"))
    assert "publish_out" not in after
    assert after.count(".publish(String(") == 1


@pytest.mark.parametrize("case", OTHERS)
def test_a_message_gets_a_timer_where_no_loop_surely_runs(case: str) -> None:
    after = edited(OTHERS[case], publish("out", data="hi"))
    assert "def publish_out(" in after
    made, had = (len(re.findall(r"Timer\(|create_timer\(", each)) for each in (after, OTHERS[case]))
    assert made == had + 1


@pytest.mark.parametrize(
    ("body", "is_woken"),
    [
        ("rclpy.spin_once(node, timeout_sec=0.5)\n    pub.publish(m)", True),
        ("rclpy.spin_once(node)\n    pub.publish(m)", True),
        ("rclpy.spin_once(node, timeout_sec=0)\n    pub.publish(m)", False),
        ("rclpy.spin_once(node)", False),
        ("rclpy.spin_once(node)\n    pub.publish(m)\n    time.sleep(1)", False),
    ],
)
def test_it_is_told_that_a_loop_runs_more_often(body: str, is_woken: bool) -> None:
    text = MAIN.format(f"while rclpy.ok():\n    {body}\n")
    found = edit(text, publish("out", rate=7.0, data="x")).diagnostics
    assert [str(each.code) for each in found] == ["wakes-loop"] * is_woken
