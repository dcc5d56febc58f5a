"""Where additions go among what is tried, among headings and among functions."""

from __future__ import annotations

import pytest
from edits import edited, provide, publish, subscribe

ROSPY = "import rospy\nfrom std_msgs.msg import String\nfrom std_srvs.srv import Trigger\n\n\n"
RCLPY = (
    "from rclpy.node import Node\nfrom std_msgs.msg import String\n"
    "from std_srvs.srv import Trigger\n\n\n"
)
TRIED = (
    f"{ROSPY}class Truck:\n    def __init__(self):\n        rospy.init_node('truck')\n"
    "        self.horn_sub = rospy.Subscriber('horn', String, self.on_horn)\n"
    "        try:\n"
    "            self.shock_pub = rospy.Publisher(rospy.get_param('~shock'), String)\n"
    "        except:\n            HANDLER\n"
    "        self.n = 1\n\n    def on_horn(self, msg):\n        pass\n"
)
BESIDE_HORN = "self.on_horn)\n        self.out_pub = rospy.Publisher('out', String"
BESIDE_SHOCK = "            self.out_pub = rospy.Publisher('out', String"
FRAME = (
    f"{ROSPY}def main():\n    rospy.init_node('n')\n    rospy.Subscriber('a', String, print)\n"
    "    try:\n        b_pub = rospy.Publisher('b', String, queue_size=1)\n        work(b_pub)\n"
    "    except rospy.ROSInterruptException:\n        pass\n\n\nmain()\n"
)
HANDLERS = {
    "pass": BESIDE_HORN,
    "rospy.logwarn('no shock absorbers')": BESIDE_HORN,
    "raise": BESIDE_SHOCK,
    "rospy.logerr('no shock absorbers')\n            sys.exit(1)": BESIDE_SHOCK,
}


@pytest.mark.parametrize("handler", HANDLERS)
def test_what_may_fail_for_another_endpoint_does_not_take_the_new_one_along(handler):
    after = edited(TRIED.replace("HANDLER", handler), publish("out"))
    assert HANDLERS[handler] in after


def test_a_try_that_is_all_the_rest_is_a_frame_and_no_guard():
    after = edited(FRAME, publish("out"))
    assert "        out_pub = rospy.Publisher('out', String, queue_size=1)\n        work(" in after


NODE = f"{RCLPY}class Arm(Node):\n    def __init__(self):\n"
MADE = "        super().__init__('arm')\n"
TWO = (
    "        self.at_pub = self.create_publisher(String, 'at', 10)\n{0}"
    "        self.to_pub = self.create_publisher(String, 'to', 10)\n{1}"
    "        self.n = 1\n"
)
SERVICE = "        self.stop_srv = self.create_service(Trigger, 'stop', self.handle_stop)\n"
HEADINGS = {
    "a comment": ("# Publishers\n", "", True),
    "a comment above a paragraph before": ("# Publishers\n", "\n", True),
    "a docstring": ('"""Publishers."""\n', "", False),
    "a string": ('"""PUBLISHERS"""\n', "", True),
    "a comment that speaks of both": ("# Publishers and services\n", "\n", False),
    "a comment on something else": ("# The arm\n", "\n", False),
    "none": ("", "\n", False),
}


@pytest.mark.parametrize("name", HEADINGS)
def test_another_kind_is_parted_from_what_is_under_a_heading(name):
    heading, between, is_parted = HEADINGS[name]
    indented = f"        {heading}" if heading else ""
    above = f"{indented}{MADE}" if "docstring" in name else f"{MADE}{indented}"
    after = edited(f"{NODE}{above}{TWO.format(between, chr(10))}", provide("stop"))
    assert f"'to', 10)\n{chr(10) * is_parted}{SERVICE}" in after


def test_a_function_of_a_script_stands_behind_its_others():
    text = (
        f"{ROSPY}rospy.loginfo('begin')\nn = 1\n\n\ndef on_a(msg):\n    print(msg)\n\n\n"
        "rospy.init_node('n')\nrospy.Subscriber('a', String, on_a)\nrospy.spin()\n"
    )
    after = edited(text, publish("out", data="x", rate=2.0))
    assert "    print(msg)\n\n\ndef publish_out(event):\n" in after


@pytest.mark.parametrize(("above", "blank"), [("\n", 2), ("", 1)])
def test_as_many_blank_lines_part_a_function_as_most_have(above, blank):
    text = (
        "import rospy\nfrom std_msgs.msg import String\n# The node.\n\nclass A:\n"
        f"    n = 1\n{above}\n"
        "if __name__ == '__main__':\n    rospy.init_node('n')\n    rospy.spin()\n"
    )
    after = edited(text, subscribe("b"))
    assert f"    n = 1\n{chr(10) * blank}def on_b(message):\n" in after


def test_a_client_that_a_constructor_asks_itself_does_not_make_a_local_of_what_stays():
    text = (
        f"{ROSPY}class Arm:\n    def __init__(self):\n        rospy.init_node('arm')\n"
        "        home = rospy.ServiceProxy('home', Trigger)\n        self.n = home()\n"
        "        rospy.spin()\n\n\nArm()\n"
    )
    after = edited(text, publish("out", data="x", rate=2.0))
    assert "    def publish_out(self, event):\n" in after


@pytest.mark.parametrize(("others", "name"), [("", "publish_out"), ("publish_out", "send_out")])
def test_what_publishes_beside_a_function_that_did_has_a_name_of_its_own(others, name):
    defined = f"def {others}():\n    pass\n\n\n" if others else ""
    text = f"{ROSPY}{defined}rospy.init_node('n')\nrospy.spin()\n"
    after = edited(text, publish("out", data="x", rate=2.0))
    assert f"def {name}(event):\n" in after
