"""What a rospy file makes anew each time, which a node of rclpy would keep each time."""

from __future__ import annotations

import pytest
from ported_nodes import MARK, ported

HEAD = "import rospy\nfrom std_msgs.msg import String\nfrom std_srvs.srv import Empty\n"
END = "rospy.init_node('n')\nrospy.Subscriber('a', String, heard)\n"
RATE = "create_rate on each call"
PUBLISHER = "a publisher on each call"
CLIENT = "a client on each call"
NOTHING = "def heard(m): pass\n"
REPEATED = [
    ("def go():\n    r = rospy.Rate(1)\n    r.sleep()\n", "while x:\n    go()\n", RATE),
    ("def go():\n    r = rospy.Rate(1)\n    r.sleep()\n", "go()\n", ""),
    ("def go():\n    r = rospy.Rate(1)\n    r.sleep()\ndef a():\n    go()\n", "while x: a()", RATE),
    ("def go():\n    r = rospy.Rate(1)\n    r.sleep()\n", "while x:\n    x.go()\n", ""),
    ("def heard(m):\n    rospy.Publisher('b', String).publish(m)\n", "", PUBLISHER),
    ("def heard(m):\n    c = rospy.ServiceProxy('b', Empty)\n    c()\n", "", CLIENT),
    ("def heard(m):\n    if y:\n        z = rospy.Publisher('b', String)\n", "", ""),
    ("def go():\n    z = rospy.Publisher('b', String)\n", "while x:\n    go()\n", PUBLISHER),
    ("", "for y in x:\n    z = rospy.Publisher('b', String)\n", ""),
    ("", "while x:\n    z = rospy.Publisher('b', String)\n", PUBLISHER),
]


@pytest.mark.parametrize(("above", "below", "what"), REPEATED)
def test_what_is_made_anew_each_time_is_marked(above: str, below: str, what: str) -> None:
    heard = "" if "def heard" in above else NOTHING
    text, found = ported(f"{HEAD}{heard}{above}{END}{below}", "rospy")
    marks = [each.message.split("`")[1] for each in found]
    assert [each for each in marks if each.endswith("on each call")] == ([what] if what else [])
    assert text.count(f"{MARK}{what}\n" if what else "on each call") == bool(what)


TIMES = [
    ("def go(time):\n    rospy.sleep(1)\n", "    time_module.sleep(1)\n"),
    ("from time import time\nrospy.sleep(1)\n", "\ntime_module.sleep(1)\n"),
    ("import time\nrospy.sleep(1)\n", "\ntime.sleep(1)\n"),
    ("import time\nrospy.rostime.wallsleep(1)\n", "\ntime.sleep(1)\n"),
]


@pytest.mark.parametrize(("before", "after"), TIMES)
def test_a_time_of_the_file_is_not_taken_for_the_module(before: str, after: str) -> None:
    text, _ = ported(f"import rospy\nrospy.init_node('n')\n{before}", "rospy")
    assert after in text
    assert ("import time as time_module\n" in text) == ("time_module." in after)
