"""What an edit leaves without anything to do is told."""

from __future__ import annotations

from pathlib import Path

import pytest
from updates import Outcome

HEAD = "import rospy\nfrom std_msgs.msg import String\n\n\n"
PUB = "pub = rospy.Publisher('a', String, queue_size=1)\n"
RATE = "rate = rospy.Rate(1)\n"
STOP = "n stop_publishing to 'a'"
HEARD = "def hear(msg):\n    {}\n\n\n" + PUB + "rospy.Subscriber('b', String, hear)\n"
# The file below its head, and what is told.
CASES = {
    "a callback": (
        HEARD.format("pub.publish(msg)"),
        ["nothing is left to do for `hear` (line 5)"],
    ),
    "a callback with more in it": (HEARD.format("pub.publish(msg)\n    print(msg)"), []),
    "one that was idle": (HEARD.format("pass") + "pub.publish('x')\n", []),
    "a documented one that others call": (
        f"{PUB}\n\ndef kick():\n    '''Kick.'''\n    pub.publish('x')\n\n\nthing.on_kick = kick\n",
        ["nothing is left to do for `kick` (line 4)"],
    ),
    "a loop": (
        f"{PUB}{RATE}while not rospy.is_shutdown():\n    pub.publish('x')\n    rate.sleep()\n",
        ["nothing is left to do for the loop in line 3"],
    ),
    "a loop over numbers": (
        f"{PUB}{RATE}for i in range(9):\n    pub.publish('x')\n    rate.sleep()\n",
        ["nothing is left to do for the loop in line 3"],
    ),
    "a loop that waits for something else": (
        f"{PUB}{RATE}while wait():\n    rate.sleep()\npub.publish('x')\n",
        [],
    ),
    "a call for what it returns": (
        f"{PUB}\n\ndef kick():\n    m = String()\n    m.data = work(1)\n    pub.publish(m)\n"
        "    rest()\n\n\ngo(kick)\n",
        ["nothing uses what is returned by `work` (line 5)"],
    ),
    "a call of no use before": (
        f"{PUB}\n\ndef kick():\n    work(1)\n    pub.publish(work(1))\n\n\ngo(kick)\n",
        [],
    ),
    "several": (
        f"{PUB}\n\ndef kick():\n    pub.publish('x')\n\n\ndef kill():\n    pub.publish('y')\n\n\n"
        "go(kick, kill)\n",
        ["nothing is left to do for `kick` (line 4), `kill` (line 8)"],
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_what_does_nothing_any_more_is_told(tmp_path: Path, name: str) -> None:
    body, messages = CASES[name]
    outcome = Outcome(tmp_path, "rospy", HEAD + body, STOP)
    assert "Publisher(" not in outcome.text
    assert {str(each.code) for each in outcome.found} <= {"idle-code"}
    assert [each.message for each in outcome.found] == messages
    assert all(each.span is not None for each in outcome.found)


NODE = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

rclpy.init()


def main():
    node = {}
    pub = node.create_publisher(String, 'a', 1)
    pub.publish(String())
    {}
"""


@pytest.mark.parametrize("made", ["rclpy.create_node('n')", "Node('n')"])
@pytest.mark.parametrize(("rest", "is_told"), [("work()", True), ("rclpy.spin(node)", False)])
def test_a_node_is_kept_as_nothing_else_keeps_it_alive(
    tmp_path: Path, made: str, rest: str, is_told: bool
) -> None:
    outcome = Outcome(tmp_path, "rclpy", NODE.format(made, rest), STOP)
    assert f"    node = {made}\n    {rest}\n" in outcome.text
    line = 1 + outcome.text.splitlines().index(f"    node = {made}")
    assert [each.message for each in outcome.found] == (
        [f"nothing is left to do for the node in line {line}"] if is_told else []
    )
