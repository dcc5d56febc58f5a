"""What goes with an endpoint as nothing else needs it: logs, timers, functions and attributes."""

from __future__ import annotations

import pytest
from edits import AT, PUB, SUB, edited

from plastron_tui.model.source import Remove

TALKER = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import Int32, String


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.publisher = self.create_publisher(String, 'topic', 10)
        self.other = self.create_publisher(Int32, 'other', 10)
        period = 0.5
        self.timer = self.create_timer(period, self.send)
        self.count = 0

    def send(self):
        message = String()
        message.data = f'Hello {self.count}'
        self.publisher.publish(message)
        self.get_logger().info(f'Publishing: {message.data}')
        self.count += 1


def main():
    rclpy.init()
    rclpy.spin(Talker())
"""
# What only serves `topic`: in the order of the file.
IDLE = {
    "timer": (
        "period = 0.5",
        "self.timer = self.create_timer(period, self.send)",
        "def send(self):",
    ),
    "message": ("message = String()", "message.data = "),
    "log": ("get_logger()",),
    "count": ("self.count = 0",),
}
# What is written in place of what, and what of the idle stays then.
KEPT = {
    "nothing": ("0.5", "0.5", []),
    "what does something else": ("self.count += 1", "work()", ["timer"]),
    "a timer that is stopped elsewhere": (
        "def main", "def f(talker):\n    talker.timer.cancel()\n\n\ndef main", ["timer"],
    ),
    "a timer that wakes": ("rclpy.spin(", "rclpy.spin_once(", ["timer"]),
    "what another class may call": ("(Node):", "(Base):", ["timer", "count"]),
    "a function that is handed on": ("def main", "f(Talker.send)\n\n\ndef main", ["timer"]),
    "a log of something else": ("Publish", "Say", ["timer", "message", "log", "count"]),
    "a log that does something": ("{message.data}", "{work()}", ["timer", "log"]),
    "a warning": (".info(", ".warning(", ["timer", "message", "log", "count"]),
    "a log of what else is sent": (
        "self.count += 1", "self.other.publish(1)", ["timer", "message", "log", "count"],
    ),
    "a count that is read": ("self.count += 1", "print(self.count)", ["timer", "count"]),
    "what another function keeps": (
        "        self.count += 1", "\n    def hear(self):\n        self.count = 1", ["count"],
    ),
    "what a text names": ("def main", "N = 'count'\n\n\ndef main", ["timer", "count"]),
}  # fmt: skip


@pytest.mark.parametrize("case", KEPT)
def test_what_only_served_a_publisher_goes_with_it(case):
    old, new, kept = KEPT[case]
    assert old in TALKER
    after = edited(TALKER.replace(old, new), Remove(PUB, "topic", AT))
    found = {key: {line in after for line in IDLE[key]} for key in IDLE}
    assert found == {key: {key in kept} for key in IDLE}


def test_a_function_of_which_nothing_is_left_goes_with_its_calls():
    calls = "def main():\n    talker = Talker()\n    talker.send()\n    rclpy.spin(talker)\n"
    before = TALKER[: TALKER.index("def main")] + calls
    before = before.replace("self.create_timer(period, self.send)", "self.other.publish(period)")
    after = edited(before, Remove(PUB, "topic", AT))
    assert "send" not in after
    assert "    talker = Talker()\n    rclpy.spin(talker)\n" in after
    before = before.replace("talker.send()", "f(talker.send())")
    assert "    def send(self):\n        pass\n" in edited(before, Remove(PUB, "topic", AT))


def test_what_a_caller_gives_stays():
    before = TALKER.replace("__init__(self)", "__init__(self, start)").replace(
        "count = 0", "count = start"
    )
    assert "        self.count = start\n" in edited(before, Remove(PUB, "topic", AT))


@pytest.mark.parametrize(("given", "is_kept"), [("start", True), ("START", False), ("9", False)])
def test_what_a_message_is_made_of_goes_but_for_what_a_caller_gives(given, is_kept):
    before = TALKER.replace("__init__(self)", "__init__(self, start)")
    before = before.replace("count = 0", f"count = {given}").replace("self.count += 1", "pass")
    before = before.replace("\n\nclass", "\nSTART = make()\n\n\nclass", 1)
    after = edited(before, Remove(PUB, "topic", AT))
    assert (f"self.count = {given}" in after) == is_kept


@pytest.mark.parametrize(
    ("said", "is_kept"),
    [("Publishing String", False), ("Publishing topic", False), ("Sending String", True),
     ("Publishing Int32, String", True)],
)  # fmt: skip
def test_a_log_below_a_timer_that_goes(said, is_kept):
    log = f"        self.get_logger().info('{said}')\n"
    before = TALKER.replace("        self.count = 0\n", log).replace("self.count += 1", "pass")
    before = before.replace("{self.count}", "")
    assert (log in edited(before, Remove(PUB, "topic", AT))) == is_kept


# What stands below a subscription of `/scan`, and whether it goes with it.
BESIDE = {
    "rospy.loginfo('Subscribed to /scan')": True,
    "print('subscribing', 'scan')": True,
    "# subscribed\nrospy.loginfo('Subscribed to /scan')": True,
    "rospy.loginfo('started, scan it')": False,
    "rospy.loginfo('Subscribed to /scan and /map')": False,
    "rospy.loginfo('Subscribed to %s at scan', take())": False,
    "log('Subscribed to /scan')": False,
}


@pytest.mark.parametrize("line", BESIDE)
def test_a_log_of_a_subscription_goes_with_it(line):
    head = "import rospy\nfrom std_msgs.msg import String\nrospy.Subscriber('/map', String)\n"
    before = f"{head}rospy.Subscriber('/scan', String)\n{line}\nrospy.spin()\n"
    after = edited(before, Remove(SUB, "/scan", AT))
    assert after == f"{head}{'' if BESIDE[line] else line + chr(10)}rospy.spin()\n"


HEAD = "import rospy\nfrom std_msgs.msg import Int32, String\n"
TAIL = "rospy.init_node('n')\n"
MORE = "keep = rospy.Publisher('keep', Int32)\n"

FUNCTIONS = """\
def half(d):
    more = 2.0
    if d is None:
        return most(0)
    return most(d / more)


def most(d):
    return max(d, 1.0)


def several(d):
    found = []
    for each in d:
        one = String()
        one.data = each
        found.append(one)
    return found


def changed(d):
    last = d.last
    last.data = 'a'
    return last


class thing:
    pass


def last(d):
    return d.last


def taken(d):
    d.x = most(d)
    return d


"""
# What a function does up to what it publishes, and what is left of that.
SENDERS = {
    "what a function works out": ("m = String(half(d))", ""),
    "what a function makes": ("m = several(d)", ""),
    "what a function changes": ("m = changed(d)", "changed(d)"),
    "what a function takes": ("m = String(taken(d))", "taken(d)"),
    "a part of what is done": ("m = String(str(take()[0]))", "take()"),
    "several things that are done": ("m = String(take() + take())", "m = String(take() + take())"),
    "what may be done": ("m = String(d or take())", "m = String(d or take())"),
    "what is done several times": ("m = [take() for x in d]", "m = [take() for x in d]"),
    "an object of the file": ("m = thing()", "m = thing()"),
    "an object that may do something": ("m = Listener()", "m = Listener()"),
    "two values": ("a, m = d, String()", ""),
    "two values that are worked out": ("a, m = take()", "take()"),
    "two values, one of which serves": ("a, m = take()\nprint(a)", "a, m = take()\nprint(a)"),
    "two values, one of which was of no use": ("_, m = d\n_ = take()", "_ = take()"),
    "all of a line": ("m = String(); m.data = 'a';\nm.data = 'b'; m.data = 'c'  # text", ""),
    "most of a line": ("m = String(); m.data = 'a'; print(d); m.data = 'b'", "print(d)"),
    "a count": ("m = 0\nm += 1", ""),
    "what others have too": ("m = d.last\nm.data = 'a'", "m = d.last\nm.data = 'a'"),
    "an entry that others have": ("m = d.get('k')\nm.data = 'a'", "m = d.get('k')\nm.data = 'a'"),
    "what a function has": ("m = last(d)\nm.data = 'a'", "m = last(d)\nm.data = 'a'"),
    "a list that others have": ("m = d.all\nm += [1]", "m = d.all\nm += [1]"),
    "a part that others have": (
        "m = String()\nm.header = d.header\nm.header.seq = 1",
        "m = String()\nm.header = d.header\nm.header.seq = 1",
    ),
    "a part that another one is": ("m = String()\nm.header = d.header\nm.data = 'a'", ""),
    "what cannot fail any more": (
        "m = String()\ntry:\n    m.data = abs(d)\nexcept E:\n    m.data = 'none'", "",
    ),
    "what is decided for nothing else": ("x = bool(d)\nm = 'a'\nif x:\n    m = 'b'", ""),
    "a parameter": ("m = String(rospy.get_param('~x'))", ""),
}  # fmt: skip


@pytest.mark.parametrize("case", SENDERS)
def test_what_only_made_a_message_goes_with_it(case):
    before, after = (
        "".join(f"    {line}\n" for line in (each or "pass").splitlines()) for each in SENDERS[case]
    )
    head = f"{HEAD}{MORE}x = String, Int32\n\n\n{FUNCTIONS}def f(d):\n"
    end = f"\n\n{TAIL}"
    sending = f"{before}    p.publish(m)\n\n\np = rospy.Publisher('t', String)\n{TAIL}"
    assert edited(head + sending, Remove(PUB, "t", AT)) == f"{head}{after}{end}"


HELD = """\
from rclpy.lifecycle import LifecycleNode
from std_msgs.msg import String


class A(LifecycleNode):
    def on_activate(self, state):
        if self.is_loud:
            self.pub = self.create_publisher(String, 'topic', 10)
        return super().on_activate(state)

    def on_deactivate(self, state):
        if self.is_loud:
            self.destroy_publisher(self.pub)
            self.pub = None
        return super().on_deactivate(state)
"""


def test_a_condition_around_all_that_is_gone_goes():
    after = edited(HELD, Remove(PUB, "topic", AT))
    assert "is_loud" not in after
    assert "pass" not in after


# How a class begins, what is left in the constructor, and whether that goes.
CONSTRUCTORS = {
    "A:\n    def __init__(self):": True,
    "A(object):\n    def __init__(self):": True,
    "A(Base):\n    def __init__(self):": False,
    "A:\n    def __init__(self, x):": False,
    "A:\n    def __init__(self):\n        # Nothing else.": False,
    "A:\n    def __init__(self):\n        '''Make it.'''": False,
    "A:\n    def __init__(self):\n        self.x = 1": False,
    "A:\n    def begin(self):": False,
}


@pytest.mark.parametrize("head", CONSTRUCTORS)
def test_a_constructor_goes_where_nothing_is_left_of_it(head):
    rest = "    def work(self):\n        return 1\n\n\nA()\n"
    made = "        rospy.Subscriber('t', String, print)\n\n"
    after = edited(f"{HEAD}{MORE}x = String\n\n\nclass {head}\n{made}{rest}", Remove(SUB, "t", AT))
    name = head.partition("(self")[0].rpartition(" ")[2]
    assert (f"def {name}(" not in after) == CONSTRUCTORS[head]
    if CONSTRUCTORS[head]:
        assert f"class {head.partition(':')[0]}:\n{rest}" in after
