"""Messages at a rate: in the loop or timer of the file only where that has the same rate."""

from __future__ import annotations

from pathlib import Path

import pytest
from file_sets import one

from plastron_tui.diagnostics import Span
from plastron_tui.model.kinds import DEFAULT_RATE, Message, Publication, Publisher
from plastron_tui.model.source import Add
from plastron_tui.model.values import MessageValue
from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.interfaces import InterfaceName
from plastron_tui.sources.python import edit_python, read_python
from plastron_tui.targets.python.rclpy import DIALECT as RCLPY
from plastron_tui.targets.python.rospy import DIALECT as ROSPY

LOOP = (
    "import rospy\nfrom std_msgs.msg import String\nrospy.init_node('n')\n"
    "rate = rospy.Rate({})\nwhile not rospy.is_shutdown():\n    rate.sleep()\n"
)
SLEEP = LOOP.replace("rate = rospy.Rate({})\n", "").replace("rate.sleep()", "rospy.sleep({})")
TWICE = LOOP.replace("    rate.sleep()\n", "    rate.sleep()\n" * 2)
TIMER_1 = (
    "import rospy\nfrom std_msgs.msg import String\nrospy.init_node('n')\n\n\ndef tick(event):\n"
    "    print(event)\n\n\nrospy.Timer(rospy.Duration({}), tick)\nrospy.spin()\n"
)
TIMER_2 = (
    "from rclpy.node import Node\nfrom std_msgs.msg import String\n\n\nclass A(Node):\n"
    "    def __init__(self):\n        super().__init__('a')\n"
    "        self.create_timer({}, self.tick)\n\n    def tick(self):\n        print()\n"
)


@pytest.mark.parametrize(
    ("text", "own", "rate", "is_own"),
    [
        (LOOP, "5", None, True),
        (LOOP, "5", 5.0, True),
        (LOOP, "5", 10.0, False),
        (LOOP, "10", 10.0, True),
        (LOOP, "rospy.get_param('~rate')", None, True),
        (LOOP, "5", 2.0, False),
        (LOOP, "rospy.get_param('~rate')", 2.0, False),
        (SLEEP, "0.5", 2.0, True),
        (TWICE, "5", 5.0, False),
        (SLEEP, "0.5", 3.0, False),
        (TIMER_1, "0.5", 2.0, True),
        (TIMER_1, "0.5", 4.0, False),
        (TIMER_2, "1.0 / 30", 30.0, True),
        (TIMER_2, "1", 10.0, False),
        (TIMER_2, "1", None, True),
        (TIMER_2, "1", 4.0, False),
    ],
)
def test_a_rate_that_the_file_does_not_have_gets_a_timer(
    text: str, own: str, rate: float | None, is_own: bool
) -> None:
    source = read_python(Path("node.py"), one(text.replace("{}", own).encode())).source
    assert source is not None
    library = {"rospy": (Catalog("noetic"), ROSPY), "rclpy": (Catalog("jazzy"), RCLPY)}
    type_, at = InterfaceName("std_msgs", "String"), Span(0, 0)
    message = Message("m", MessageValue(type_, {"data": "hi"}), at)
    sent = Publication(message, rate or DEFAULT_RATE, is_rate_open=rate is None)
    change = Add(Publisher("out", type_, [sent], at))
    result = edit_python(source, [change], *library[source.library])
    assert result.files is not None, result.diagnostics
    assert (b"def publish_out(" not in result.files.main) == is_own
    assert result.files.main.count(b"out_pub.publish(") == 1
