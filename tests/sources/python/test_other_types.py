"""Code that takes messages without a callback of the call, and gets others than it was made for."""

from __future__ import annotations

from pathlib import Path

import pytest
from updates import Outcome

HEAD = """\
import functools
import message_filters as mf
import rospy
from std_msgs.msg import Int32, String
"""
SUB = "mf.Subscriber('a', String)"
# What the file does with what it hears, and who is told to take it.
CASES = {
    "a synchronizer": (
        f"one = {SUB}\ntwo = mf.Subscriber('b', String)\n"
        "both = mf.TimeSynchronizer([one, two], 10)\nboth.registerCallback(hear, 'x')\n",
        "`hear` was written for `std_msgs/String`, and gets `std_msgs/Int32`",
    ),
    "attributes, and a synchronizer that nothing holds": (
        "class N:\n    def __init__(self):\n"
        f"        self.one = {SUB}\n"
        "        mf.ApproximateTimeSynchronizer((self.one,), 10, slop=1).registerCallback(self.f)\n"
        "    def f(self, m):\n        print(m.data)\n",
        "`f` was written for `std_msgs/String`, and gets `std_msgs/Int32`",
    ),
    "several functions": (
        f"one = {SUB}\none.registerCallback(hear)\ncache = mf.Cache(one, 100)\n"
        "cache.registerCallback(functools.partial(tell, 1))\n",
        "`hear` and `tell` were written for `std_msgs/String`, and gets `std_msgs/Int32`",
    ),
    "a cache that is asked": (
        f"cache = mf.Cache({SUB}, 100)\nprint(cache.getLast().data)\n",
        "what takes its messages from line 5 on was written for `std_msgs/String`, and gets "
        "`std_msgs/Int32`",
    ),
    "a message that is waited for": (
        "m = rospy.wait_for_message('a', String)\nprint(m.data)\n",
        "what takes its messages from line 5 on was written for `std_msgs/String`, and gets "
        "`std_msgs/Int32`",
    ),
    "only waiting": ("rospy.wait_for_message('a', String)\n", None),
    "nobody": ("rospy.Subscriber('a', String)\n", None),
}  # fmt: skip


@pytest.mark.parametrize("name", CASES)
def test_who_gets_messages_of_another_type_is_told(tmp_path: Path, name: str) -> None:
    body, message = CASES[name]
    statements = "unsubscribe n from 'a'\nsubscribe n to 'a' of message_type Int32"
    outcome = Outcome(tmp_path, "rospy", HEAD + body, statements)
    assert outcome.text.endswith(body.replace("'a', String", "'a', Int32"))
    told = [(str(each.code), each.message) for each in outcome.found]
    assert told == ([] if message is None else [("other-type", message)])
