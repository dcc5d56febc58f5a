"""Messages that a loaded node sends for each that it hears, from the function that hears it."""

from __future__ import annotations

from pathlib import Path

import pytest
from loaded_nodes import FILES

from plastron_tui.session import Session

SENT = {
    "plain": ("none", "", ["PUB.publish(Twist())"]),
    "computed": (
        "linear.x=received.range_min * 2",
        "",
        ["PUB.publish(Twist(linear=Vector3(x=msg.range_min * 2)))"],
    ),
    "under a condition": (
        "none",
        "when any received.ranges < 0.5",
        ["if any(each < 0.5 for each in msg.ranges):", "    PUB.publish(Twist())"],
    ),
    "of an element": (
        "linear.x=received.ranges[3]",
        'when received.header.frame_id = "it\'s"',
        [
            'if msg.header.frame_id == "it\'s" and len(msg.ranges) > 3:',
            "    PUB.publish(Twist(linear=Vector3(x=msg.ranges[3])))",
        ],
    ),
}
"""The fields of a message, the condition, and what is written."""

BACK = "driver stop_publishing to 'out'"
SAY = "create_message s of message_type std_msgs/String and input none\n"
SAY += "driver publish s to 'out' of message_type std_msgs/String for_each 'scan'"


def made(folder: Path, text: str, program: str) -> tuple[str, list[str]]:
    """Return what a program makes of a file, and what is told."""
    (folder / "driver.py").write_text(text)
    program = f"load driver as driver\n{program}\ngenerate_node driver\n"
    session = Session(program.encode(), folder / "program.plastron")
    plan, found = session.plan()
    after = plan.files[0].text.decode() if plan.files else text
    told = (*session.diagnostics, *found)
    return after, [each.message for each in told if each.code != "also-sent"]


@pytest.mark.parametrize("file", FILES)
@pytest.mark.parametrize("case", SENT)
def test_a_message_is_sent_where_another_is_heard(tmp_path: Path, case: str, file: str) -> None:
    fields, condition, lines = SENT[case]
    program = f"create_message go of message_type Twist and input {fields}\n"
    program += f"driver publish go to 'out' of message_type Twist for_each 'scan' {condition}"
    after, told = made(tmp_path, FILES[file], program)
    assert not told
    head, before = ("    ", "self.") if "class" in file else ("", "")
    above = f"{head}    {'self.last = msg' if head else 'print(msg)'}\n"
    written = "".join(f"{head}    {each}\n" for each in lines).replace("PUB", f"{before}out_pub")
    assert above + written in after
    assert made(tmp_path, after, BACK) == (FILES[file], [])


@pytest.mark.parametrize("file", FILES)
def test_a_new_subscription_is_heard_by_a_function_that_sends(tmp_path: Path, file: str) -> None:
    listen = "subscribe driver to 'near' of message_type sensor_msgs/LaserScan\n"
    after, told = made(tmp_path, FILES[file], listen + SAY.replace("scan", "near"))
    assert not told
    _, _, function = after.partition("def near_callback(")
    assert "out_pub.publish(String())" in function.partition("def ")[0]
    back = f"unsubscribe driver from 'near'\n{BACK}"
    assert made(tmp_path, after, back) == (FILES[file], [])


HEAD = "import rospy\nfrom std_msgs.msg import String\n\n"
FUNCTION = "\n\ndef hear(m):\n{}\n\n\nrospy.init_node('driver')\n{}rospy.spin()\n"
BODIES = {
    "may end early": ("if m.data:\n    return\nwork(m)", 0),
    "raises": ("if m.data:\n    raise ValueError\nwork(m)", 0),
    "goes on": ("while m.data:\n    work(m)", 0),
    "changes the message": ("m.data += 'x'\nwork(m)", 0),
    "calls something else so": ("m = m.data\nwork(m)", 0),
    "is documented": ("'''Hear.'''\nm = m.data\nwork(m)", 1),
    "returns at its end": ("work(m)\nreturn True", 1),
    "holds a function that returns": ("def inner():\n    return m\nwork(inner)", 3),
    "tries": ("try:\n    work(m)\nexcept ValueError:\n    pass", 4),
}
"""The body of the function that hears, and the index of the line that is written into it."""


@pytest.mark.parametrize("case", BODIES)
def test_each_message_is_followed_by_one(tmp_path: Path, case: str) -> None:
    body, at = BODIES[case]
    lines = body.splitlines()
    written = [*lines[:at], "out_pub.publish(String(data=m.data))", *lines[at:]]
    called = "rospy.Subscriber('scan', String, hear)\n"
    frame = f"{HEAD}from elsewhere import work\n{FUNCTION}"
    text = frame.format("\n".join(f"    {each}" for each in lines), called)
    sent = SAY.replace("none", "data=received.data")
    after, told = made(tmp_path, text, sent)
    assert not told
    assert "\n".join(f"    {each}" for each in written) in after
    assert made(tmp_path, after, BACK) == (text, [])
    # What is heard at once must find what sends.
    assert after.index("rospy.Publisher(") < after.index("rospy.Subscriber(")


IN_MAIN = """\
import rclpy
from std_msgs.msg import String


def hear(msg):
    pass


def main():
    rclpy.init()
    node = rclpy.create_node('driver')
    node.create_subscription(String, 'scan', hear, 10)
    rclpy.spin(node)


main()
"""


def test_a_publisher_of_a_function_is_shared_with_the_one_that_hears(tmp_path: Path) -> None:
    after, told = made(tmp_path, IN_MAIN, SAY)
    assert not told
    assert "def hear(msg):\n    out_pub.publish(String())\n\n\n" in after
    assert "    global out_pub\n    out_pub = node.create_publisher(String, 'out', 10)\n" in after
    assert made(tmp_path, after, BACK)[0] == IN_MAIN


def test_a_stamp_needs_a_node_that_is_seen(tmp_path: Path) -> None:
    after, told = made(tmp_path, IN_MAIN, SAY.replace("std_msgs/String", "sensor_msgs/Range"))
    assert after == IN_MAIN
    assert [each.partition(": ")[2] for each in told] == ["`hear` does not see `node`"]


MANAGED = """\
import rclpy
from rclpy.lifecycle import LifecycleNode, TransitionCallbackReturn
from std_msgs.msg import String


class Driver(LifecycleNode):
    def __init__(self):
        super().__init__('driver')

    def on_configure(self, state):
        self.sub = self.create_subscription(String, 'scan', self.hear, 10)
        return TransitionCallbackReturn.SUCCESS

    def on_cleanup(self, state):
        self.destroy_subscription(self.sub)
        return TransitionCallbackReturn.SUCCESS

    def hear(this, msg: String) -> None:
        this.last = msg


def main():
    rclpy.init()
    rclpy.spin(Driver())


main()
"""


def test_a_method_says_its_own_name_of_the_object(tmp_path: Path) -> None:
    after, told = made(tmp_path, MANAGED, SAY)
    assert not told
    assert "        this.out_pub.publish(String())\n" in after
    assert "        self.destroy_publisher(self.out_pub)\n" in after
    assert made(tmp_path, after, BACK) == (MANAGED, [])


HEARD = "rospy.Subscriber('scan', String, {})\n"
REFUSED = {
    "a lambda hears it in line 15": HEARD.format("lambda m: hear(m)"),
    "`make()` is no function of this file": HEARD.format("make()"),
    "`work` is no function of this file": HEARD.format("work"),
    "`hear` gets more than the message": HEARD.format("hear, callback_args=1"),
    "`two` takes other arguments than the message": HEARD.format("two"),
    "`kept` is decorated": HEARD.format("kept"),
    "`hear` is used in line 16 as well": HEARD.format("hear") + "hear(String())\n",
    "several functions hear it": HEARD.format("hear") + HEARD.format("other"),
    "`hear` does not see `out`": "def f():\n    out = rospy.Publisher('out', String)\n    "
    + HEARD.format("hear")
    + "f()\n",
    "the body of `short` is not one of lines": HEARD.format("short"),
}


@pytest.mark.parametrize("reason", REFUSED)
def test_what_is_not_sure_is_refused(tmp_path: Path, reason: str) -> None:
    text = "import rospy\nfrom std_msgs.msg import String\nfrom elsewhere import make, work\n"
    text += (
        "def hear(m):\n    print(m)\ndef other(m):\n    print(m)\ndef two(m, n):\n    print(m)\n"
    )
    text += "@work\ndef kept(m):\n    print(m)\ndef short(m): print(m)\n"
    text += f"rospy.init_node('driver')\n{REFUSED[reason]}rospy.spin()\n"
    after, told = made(tmp_path, text, SAY)
    assert after == text
    assert [each.partition(": ")[2] for each in told] == [reason]
