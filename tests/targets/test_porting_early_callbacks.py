"""What rospy calls back stands behind what its callbacks use: before → after."""

from __future__ import annotations

import pytest
from ported_nodes import MARK, ported

HEAD = (
    "import rclpy\nfrom rclpy.node import Node\nfrom std_msgs.msg import String\n\n\n"
    "class A(Node):\n    known = 1\n\n    def __init__(self):\n"
    "        super().__init__('a')\n{}\n\n"
    "    def hear(self, msg):\n        self.show(self.count + self.known)\n\n"
    "    def show(self, what):\n        self.shown = what\n\n"
    "    def start(self):\n        self.count = 0\n\n"
    "    def plain(self, msg):\n        print(msg)\n"
)
SUB_2 = "self.sub = self.create_subscription(String, 's', self.{}, 1)"
SUB_1 = "self.sub = rospy.Subscriber('s', String, self.{}, queue_size=1)"
COUNT = "self.count = 0"

MOVED = [
    ("{sub}\n{count}", "{count}\n{sub}"),
    ("{sub}\nself.start()", "self.start()\n{sub}"),
    ("{sub}\nself.shown = None\nself.last = 1", "self.shown = None\n{sub}\nself.last = 1"),
    ("{sub}\nif here:\n    {count}\nself.last = 1", "if here:\n    {count}\n{sub}\nself.last = 1"),
    ("{count}\n{sub}", "{count}\n{sub}"),
    (
        "{count}\n{sub}\nfor x in here:\n    self.count.append(x)",
        "{count}\nfor x in here:\n    self.count.append(x)\n{sub}",
    ),
    ("{count}\n{sub}\nself.count[0] = 1", "{count}\nself.count[0] = 1\n{sub}"),
    ("if here:\n    {sub}\n{count}", "{count}\nif here:\n    {sub}"),
    ("{sub}\nself.known = 2", "{sub}\nself.known = 2"),
    ("{sub}  # hears\n{count}  # how many", "{count}  # how many\n{sub}  # hears"),
    ("\n# Hear\n{sub}\n\n# State\n{count}\n\nself.last = 1",
     "\n# State\n{count}\n\n# Hear\n{sub}\n\nself.last = 1"),
    ("# Both\n{sub}\nself.last = 1\n{count}", "# Both\nself.last = 1\n{count}\n{sub}"),
    ("self.time = 1\n{sub}\nself.create_timer(1, self.tick)\n{count}",
     "self.time = 1\nrospy.Timer(rospy.Duration(1), lambda event: self.tick())\n{count}\n{sub}"),
]  # fmt: skip


@pytest.mark.parametrize(("before", "after"), MOVED)
def test_a_subscription_stands_behind_what_its_callback_uses(before: str, after: str) -> None:
    text, found = ported(HEAD.format(lines(before, SUB_2)), "rclpy")
    assert f"rospy.init_node('a')\n{lines(after, SUB_1)}\n\n    def hear" in text
    assert not found


STAYING = [
    "{sub}\nself.sub.last = self.sub\n{count}",
    "{sub}\nwhile self.last is None:\n    pass\n{count}",
    "name = 's'\n{sub}\nself.hear = 1\n{count}",
    "{sub}; x = 1\n{count}",
    "with here:\n    {sub}\n{count}",
    "{sub}\nif here:\n    return\n{count}",
]


@pytest.mark.parametrize("before", STAYING)
def test_one_that_cannot_move_is_marked(before: str) -> None:
    text, found = ported(HEAD.format(lines(before, SUB_2)), "rclpy")
    [told] = [each for each in found if "calls back" in each.message]
    assert "`calls back before self.count is set`" in told.message
    assert f"{MARK}calls back before self.count is set\n" in text
    assert "".join(text.split()).index("Subscriber(") < text.index("self.count = 0")


def test_a_callback_that_uses_nothing_of_it_stays() -> None:
    text, found = ported(HEAD.format(f"        {SUB_2.format('plain')}\n        {COUNT}"), "rclpy")
    assert f"        {SUB_1.format('plain')}\n        {COUNT}\n" in text
    assert not found


def test_marks_move_with_their_lines() -> None:
    given = f"        {SUB_2.format('hear').replace('1)', 'qos)')}\n        {COUNT}"
    text, _ = ported(HEAD.format(given), "rclpy")
    mark = f"        {MARK}quality of service\n        self.sub = rospy.Subscriber("
    assert f"        {COUNT}\n{mark}" in text


def lines(text: str, sub: str) -> str:
    """Indent the lines of a constructor."""
    made = text.format(sub=sub.format("hear"), count=COUNT)
    return "\n".join(f"        {line}" if line else "" for line in made.split("\n"))
