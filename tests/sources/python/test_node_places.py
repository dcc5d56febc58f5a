"""A new endpoint comes where there is a node: behind a start that may be left out, in its class."""

from __future__ import annotations

import pytest
from edits import edit, edited, provide, publish, request, subscribe

HEAD = "import rospy\nfrom std_msgs.msg import String\n\n\ndef work():\n    rospy.sleep(1)\n\n\n"
PUB = "{}out_pub = rospy.Publisher('out', String, queue_size=10)\n"

# What is new comes in place of `+`.
STARTS = {
    "all that a `try` does": (
        "try:\n    rospy.init_node('a')\nexcept rospy.ROSException:\n    pass\n\n+rospy.spin()\n"
    ),
    "one branch, the other has no node": (
        "if usage():\n    print('usage')\nelse:\n    rospy.init_node('a')\n+    work()\n"
    ),
    "a branch that goes on to work": "if ready():\n    rospy.init_node('a')\n+    work()\n",
    "both branches": (
        "if named():\n    rospy.init_node(name)\nelse:\n    rospy.init_node('a')\n\n+rospy.spin()\n"
    ),
    "what another may have done": (
        "if not is_initialized():\n    rospy.init_node('a')\n    print('started')\n\n"
        "+rospy.spin()\n"
    ),
}


@pytest.mark.parametrize("case", STARTS)
def test_a_node_has_started(case: str) -> None:
    above, _, below = STARTS[case].partition("+")
    indent = below[: len(below) - len(below.lstrip())]
    gap = "\n" * above.endswith("\n\n")
    after = edited(HEAD + above.removesuffix(gap) + below, publish("out"))
    assert after == HEAD + above + PUB.format(indent) + gap + below


CLASSES = "import rclpy\n{}from std_msgs.msg import String\n\n\n{}"
HELPER = (
    "class Eye:\n    def __init__(self, node):\n"
    "        self.sub = node.create_subscription(String, 'a', self.on_a, 10)\n\n"
    "    def on_a(self, msg):\n        pass\n\n\n"
    "class Arm(Node):\n    def __init__(self):\n        super().__init__('arm')\n"
    "        self.eye = Eye(self)\n\n\nrclpy.init()\nrclpy.spin(Arm())\n"
)
PLUGIN = (
    "class Setpoint({}):\n    def __init__(self):\n"
    "        self.sub = self.create_subscription(String, 'a', self.on_a, 10)\n\n"
    "    def on_a(self, msg):\n        {}\n"
)
CHANGES = [
    publish("out", data="hi"),
    subscribe("out"),
    provide("out"),
    request("out", "std_srvs/Trigger"),
]


@pytest.mark.parametrize("change", CHANGES)
def test_an_endpoint_is_of_the_node_not_of_what_gets_it(change) -> None:
    after = edited(CLASSES.format("from rclpy.node import Node\n", HELPER), change)
    above, _, below = after.partition("super().__init__('arm')\n")
    assert "'out'" in below.splitlines()[0]
    assert "'out'" not in above


@pytest.mark.parametrize("change", CHANGES)
def test_a_class_of_another_file_may_be_no_node(change) -> None:
    text = CLASSES.format("from plugins import Plugin\n", PLUGIN.format("Plugin", "pass"))
    (found,) = edit(text, change).diagnostics
    assert found.code == "edit-refused"
    assert "does not show that `Setpoint` is a node" in found.message


@pytest.mark.parametrize("change", CHANGES)
@pytest.mark.parametrize(
    ("base", "line"), [("BaseNode", "pass"), ("Base", "self.get_logger().info(msg.data)")]
)
def test_a_class_of_another_file_is_shown_to_be_a_node(base: str, line: str, change) -> None:
    assert edited(
        CLASSES.format(f"from plugins import {base}\n", PLUGIN.format(base, line)), change
    )


SECTIONS = (
    "import rospy\nfrom std_msgs.msg import String\n\n\nclass Arm:\n    def __init__(self):\n"
    "        rospy.init_node('arm')\n"
    "        self.pub = rospy.Publisher('a', String, queue_size=1)\n{}"
    "        self.timer = rospy.Timer(rospy.Duration(1), self.tick)\n\n"
    "    def tick(self, event):\n        if event:\n            return\n        print()\n\n\n"
    "Arm()\nrospy.spin()\n"
)


@pytest.mark.parametrize(("between", "timer"), [("\n        # Timers\n", 2), ("", 1)])
def test_a_timer_comes_to_the_section_of_the_timers(between: str, timer: int) -> None:
    after = edited(SECTIONS.format(between), publish("out", data="hi"))
    parts = after.split("rospy.Timer(")
    assert "self.publish_out)" in parts[timer]
    assert "self.out_pub = " in parts[0].partition("# Timers")[0]


LOGS = {
    "print('publisher ready')": True,
    "rospy.loginfo('Publishing to %s', topic)": True,
    "rospy.loginfo('a: on')": True,
    "rospy.loginfo('publishers ready')": False,
    "rospy.loginfo('publisher node ready')": False,
    "rospy.loginfo('started')": False,
    "\n        rospy.loginfo('publisher ready')": False,
}


@pytest.mark.parametrize("log", LOGS)
def test_a_log_stays_with_what_it_tells_of(log: str) -> None:
    after = edited(SECTIONS.format(f"        {log}\n"), publish("out"))
    assert (after.index(log.strip()) < after.index("'out'")) is LOGS[log]


@pytest.mark.parametrize("is_wrapped", [True, False])
@pytest.mark.parametrize(
    ("heading", "is_section"),
    [
        ("", False),
        ("\n        # Publishers\n        self.a = 1\n", True),
        ("\n        # State\n        self.a = 1\n", False),
        ("\n        # State\n", True),
    ],
)
def test_what_starts_a_section_is_parted_from_what_follows(
    heading: str, is_section: bool, is_wrapped: bool
) -> None:
    head, _, _ = SECTIONS.partition("        self.pub")
    queue = ",\n            queue_size=1)" if is_wrapped else ", queue_size=1)"
    pub = f"        self.pub = rospy.Publisher('a', String{queue}\n        self.n = 1\n"
    text = f"{head}{heading}{pub}\n\nArm()\nrospy.spin()\n"
    gap = "\n" * is_section
    new = "        rospy.Subscriber('in', String, self.on_in)\n"
    assert f"queue_size=1)\n{gap}{new}{gap}        self.n = 1\n" in edited(text, subscribe("in"))


def test_a_node_may_start_in_a_method_of_its_base() -> None:
    sub = "        self.sub = self.create_subscription(String, 'a', self.on_a, 10)\n"
    text = (
        "import rclpy\nimport base\nfrom std_msgs.msg import String\n\n\n"
        "class Arm(base.BaseNode):\n    def __init__(self):\n"
        "        base.BaseNode.__init__(self, 'arm')\n        self.n = 1\n\n"
        "    def on_a(self, msg):\n        pass\n\n    def main(self):\n"
        f"        base.BaseNode.main(self)\n{sub}\n\nrclpy.init()\nArm().main()\n"
    )
    assert f"{sub}        self.in_sub = " in edited(text, subscribe("in"))


HELD = (
    "import rclpy\nfrom std_msgs.msg import String\n\n\nclass Eye:\n"
    "    def __init__(self, node):\n        self._node = node\n"
    "        self.pub = node.create_publisher(String, 'a', 10)\n"
)


@pytest.mark.parametrize("change", CHANGES)
def test_a_method_uses_the_node_that_its_object_holds(change) -> None:
    after = edited(HELD, change)
    assert "        def " not in after
    assert "print(" not in after
    assert "node.create_" in after.partition("'a', 10)\n")[2]


def test_a_section_ends_where_the_next_begins() -> None:
    head, _, _ = SECTIONS.partition("        self.pub")
    start = "        # State\n        self.a = 1\n        self.b = 1\n"
    wait = "        # Map\n        m = rospy.wait_for_message('map', String)\n"
    wait += "        self.pub = rospy.Publisher('a', String, queue_size=len(m))\n"
    new = "        rospy.Subscriber('in', String, self.on_in)\n"
    after = edited(f"{head}{start}{wait}\n\nArm()\nrospy.spin()\n", subscribe("in"))
    assert f"{start}\n{new}\n{wait}" in after


def test_a_section_does_not_begin_above_a_function() -> None:
    text = (
        "#!/usr/bin/env python\nimport rospy\nfrom std_msgs.msg import String\ndef on_a(msg):\n"
        "    print(msg)\nrospy.init_node('n')\nrospy.Subscriber('a', String, on_a)\nrospy.spin()\n"
    )
    assert "on_a)\nout_pub = rospy.Publisher(" in edited(text, publish("out"))


@pytest.mark.parametrize(
    ("gaps", "expected"), [((1, 1, 0), 1), ((0, 0, 1), 0), ((2, 1, 2), 2), ((1, 2), 2), ((5,), 2)]
)
def test_methods_are_as_far_apart_as_most_of_the_class(
    gaps: tuple[int, ...], expected: int
) -> None:
    methods = "".join(
        "\n" * gap + f"    def go_{at}(self):\n        pass\n" for at, gap in enumerate(gaps)
    )
    head = SECTIONS.partition("        self.timer")[0].format("")
    text = f"{head}{methods}\n\nArm()\nrospy.spin()\n"
    above = edited(text, subscribe("in")).partition("    def on_in(")[0]
    assert len(above) - len(above.rstrip("\n")) - 1 == expected
