"""Lines that go on below a bracket stay aligned when a name before it changes its length."""

from __future__ import annotations

import pytest
from edits import AT, SUB, edited, interface

from plastron_tui.model.kinds import Subscription
from plastron_tui.model.source import Rename, Update

NODE = """\
import rospy
from std_msgs.msg import String


def on_text(message):
    pass


rospy.init_node('n')
{}rospy.spin()
"""
# At the `@` is the name, at the `~` are as many spaces.
ALIGNED = {
    "a call behind the name": (f"rospy.Subscriber('@', String, partial(on_text,\n{' ' * 37}~1))\n"),
    "brackets in brackets": (
        "rospy.Subscriber('@', String, on_text)\n"
        f"rospy.logwarn_throttle(5, 'no @ for %s' % max(1,\n{' ' * 45}~min(2,\n{' ' * 49}~3)))\n"
    ),
    "what goes on behind a bracket": (
        "rospy.Subscriber('@', String, on_text)\n"
        f"rospy.loginfo('on @: {{}}'.format(1,\n{' ' * 31}~2), list(range(1,\n{' ' * 46}~3)))\n"
    ),
    "a line that the bracket does not align": (
        "rospy.Subscriber('@', String, partial(on_text,\n    1))\n"
    ),
    "a text of several lines": (
        f"rospy.Subscriber('@', String, partial(on_text, '''a\n{' ' * 60}b'''))\n"
    ),
}


def _text(case: str, name: str) -> str:
    return NODE.replace("{}", ALIGNED[case]).replace("@", name).replace("~", " " * len(name))


@pytest.mark.parametrize("name", ["a/b", "a/longer_name"])
@pytest.mark.parametrize("case", ALIGNED)
def test_lines_stay_aligned(case: str, name: str) -> None:
    assert edited(_text(case, "a/text"), Rename(SUB, "a/text", name, AT)) == _text(case, name)


def test_a_type_that_moves_a_bracket_keeps_the_lines_aligned() -> None:
    call = "rospy.Subscriber('a', {}, on_text, queue_size=max(1,\n{}2))\n"
    change = Update(SUB, "a", Subscription("a", interface("std_msgs/Float32"), "on_text", AT), AT)
    text = edited(NODE.replace("{}", call.format("String", " " * 54)), change)
    assert call.format("Float32", " " * 55) in text
