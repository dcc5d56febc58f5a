"""What only a callback set that nothing calls any more, and others go on reading, is told."""

from __future__ import annotations

from pathlib import Path
from textwrap import indent

import pytest
from updates import Outcome

HEAD = """\
import queue
import threading

import rospy
from geometry_msgs.msg import Twist
from std_msgs.msg import String


"""
UNSUBSCRIBE = "unsubscribe n from 'a'"
CLASS = """\
class N:
    def __init__(self):
{init}
        rospy.Subscriber('a', String, self.hear)
        rospy.Timer(rospy.Duration(1), self.tick)

    def hear(self, msg):
{hear}

    def tick(self, event):
{tick}

    def work(self, msg):
{work}


rospy.init_node('n')
n = N()
n.work()
"""
FIRST = "self.last = None"
HEAR = "self.last = msg"
TICK = "print(self.last)  # 1"
READ = "`self.last` (read by `tick` in line #1)"
WAIT = "`self.last` (waited for by `tick` in line #1)"
# What the functions of the class do, and what is told.
METHODS = {
    "an attribute": (FIRST, HEAR, TICK, "", READ),
    "one that nothing made before": ("", HEAR, TICK, "", READ),
    "one that nobody reads": (FIRST, HEAR, "", "", None),
    "one that others set": (FIRST, HEAR, TICK, HEAR, None),
    "one that others set to nothing": (FIRST, HEAR, TICK, FIRST, READ),
    "one that others set as at first": (
        "self.last = Twist()",
        HEAR,
        TICK,
        "self.last = Twist()",
        READ,
    ),
    "one that others fill": (
        "self.last = []",
        "self.last.append(1)",
        TICK,
        "self.last.append(2)",
        None,
    ),
    "one that others fill as at first": (
        "self.last = []\nself.last.append(0)",
        "self.last.append(1)",
        TICK,
        "self.last.append(2)",
        None,
    ),
    "one that others count": ("self.last = 0", "self.last = 3", TICK, "self.last -= 1", None),
    "one of several that are set": (
        "self.last, self.x = 0, 0",
        "self.last, self.x = 1, 2",
        TICK,
        "",
        READ,
    ),
    "an item": ("self.last = {}", "self.last['a'] = msg", TICK, "", READ),
    "a part": (
        "self.last = Twist()",
        "self.last.linear.x = 1.0",
        TICK,
        "self.last.linear.y = 1.0",
        READ,
    ),
    "a part that others set": (
        "self.last = Twist()",
        "self.last.linear.x = 1.0",
        TICK,
        "self.last.linear = msg",
        None,
    ),
    "a part that nobody reads": (
        "self.last = Twist()",
        "self.last.linear.x = 1.0",
        "print(self.last.angular)",
        "",
        None,
    ),
    "a lock": (
        "self.last = threading.Lock()",
        "with self.last:\n    work()",
        "with self.last:\n    work()",
        "",
        None,
    ),
    "what has methods of its own": (
        "self.last = Work()",
        "self.last.add(msg)",
        "self.last.stop()",
        "",
        None,
    ),
    "a part of what has methods of its own": (
        "self.last = Work()",
        "self.last.x = msg",
        "self.last.stop()",
        "",
        None,
    ),
    "a part of a list": (
        "self.last = Work()",
        "self.last.x = msg",
        "self.last.x.pop()  # 1",
        "",
        READ,
    ),
    "a test that waits": (
        FIRST,
        HEAR,
        "wait_for(lambda: self.last is not None)  # 1",
        "",
        WAIT,
    ),
    "what does something": ("self.last = Work()", "self.last.do()", TICK, "", None),
    "a loop that waits": (
        "self.last = False",
        "self.last = True",
        "while not self.last:  # 1\n    sleep(1)",
        "",
        WAIT,
    ),
    "a loop that waits for any value": (
        FIRST,
        HEAR,
        "while self.last is None and ok():  # 1\n    sleep(1)",
        "",
        WAIT,
    ),
    "a loop that reads": (FIRST, HEAR, f"while ok():\n    {TICK}", "", READ),
    "an event": (
        "self.last = threading.Event()",
        "self.last.set()",
        "self.last.clear()\nself.last.wait(1)  # 1",
        "",
        WAIT,
    ),
    "a queue": (
        "self.last = queue.Queue()",
        "self.last.put(msg)",
        "self.last.get(timeout=1)  # 1",
        "",
        WAIT,
    ),
    "several": (
        "self.x = self.last = None",
        "self.x = self.last = msg",
        f"print(self.x)  # 2\n{TICK}",
        "",
        f"`self.x` (read by `tick` in line #2), {READ}",
    ),
    "several readers": (
        FIRST,
        HEAR,
        f"{TICK}\n{TICK[:-1]}",
        "print(self.last)  # 2",
        "`self.last` (read by `tick` in line #1; read by `work` in line #2)",
    ),
    "what is read where it is made": (f"{FIRST}; {TICK}", HEAR, "", "", None),
    "what some object may get": (FIRST, HEAR, TICK, "msg.node.last = 1", None),
}
# The same for what two functions of the class share.
SHARED = {
    "what the callback hands on": ("self.keep(msg)", "", READ),
    "what others hand on too": ("self.keep(msg)", "self.keep(1)", None),
}


def _told(tmp_path: Path, text: str, statements: str = UNSUBSCRIBE) -> list[str]:
    outcome = Outcome(tmp_path, "rospy", text, statements)
    told = [each for each in outcome.found if each.code == "still-read"]
    assert all(each.span is not None for each in told)
    messages = [each.message for each in told]
    for number, line in enumerate(outcome.text.splitlines(), 1):
        if (mark := line[-3:]) in ("# 1", "# 2"):
            messages = [each.replace(f"line {number}", f"line #{mark[-1]}") for each in messages]
    return messages


def _says(expected: str | None) -> list[str]:
    return [] if expected is None else [f"no longer set: {expected}"]


def _class(init: str, hear: str, tick: str, work: str) -> str:
    parts = {"init": init, "hear": hear, "tick": tick, "work": work}
    return HEAD + CLASS.format(
        **{key: indent(each or "pass", " " * 8) for key, each in parts.items()}
    )


@pytest.mark.parametrize("case", METHODS)
def test_an_attribute_that_nothing_sets_any_more(tmp_path: Path, case: str) -> None:
    *parts, expected = METHODS[case]
    assert _told(tmp_path, _class(*parts)) == _says(expected)


@pytest.mark.parametrize("case", SHARED)
def test_an_attribute_that_another_function_sets_for_a_callback(tmp_path: Path, case: str) -> None:
    hear, work, expected = SHARED[case]
    text = _class(FIRST, hear, TICK, work)
    keep = "    def keep(self, msg):\n        self.last = msg\n\n    def tick"
    assert _told(tmp_path, text.replace("    def tick", keep)) == _says(expected)


def test_an_attribute_that_a_method_makes_for_the_constructor(tmp_path: Path) -> None:
    text = _class("self.reset()", HEAR, TICK, "")
    reset = "    def reset(self):\n        self.last = Twist()\n\n    def tick"
    assert _told(tmp_path, text.replace("    def tick", reset)) == _says(READ)


def test_how_many_readers_are_named(tmp_path: Path) -> None:
    more = [f"    def work{number}(self):\n        print(self.last)\n\n" for number in range(2)]
    text = _class(FIRST, HEAR, TICK, "print(self.last)  # 2")
    readers = "read by `tick` in line #1; read by `work` in line #2; 2 more"
    text = text.replace("\n\nrospy.init_node", "".join(["\n", *more, "\nrospy.init_node"]))
    assert _told(tmp_path, text) == _says(f"`self.last` ({readers})")


GLOBAL = """\
last = queue.Queue()


def hear(msg):
    {}


rospy.init_node('n')
rospy.Subscriber('a', String, {})
while not rospy.is_shutdown():
    print(last)  # 1
    {}
"""
# What the callback of a script does, what it is, and what is told.
GLOBALS = {
    "a global": ("global last; last = msg", "hear", "pass", "`last` (read in line #1)"),
    "a local": ("last = msg", "hear", "pass", None),
    "one that the loop sets": ("global last; last = msg", "hear", "last = work()", None),
    "one that the loop forgets": (
        "global last; last = msg",
        "hear",
        "last = None",
        "`last` (read in line #1)",
    ),
    "a method of what is filled": ("pass", "last.append", "pass", "`last` (read in line #1)"),
    "a lambda": ("pass", "lambda msg: last.put(msg)", "pass", "`last` (read in line #1)"),
}


@pytest.mark.parametrize("case", GLOBALS)
def test_a_global_that_nothing_sets_any_more(tmp_path: Path, case: str) -> None:
    *parts, expected = GLOBALS[case]
    assert _told(tmp_path, HEAD + GLOBAL.format(*parts)) == _says(expected)


def test_what_a_callback_set_that_another_one_replaces(tmp_path: Path) -> None:
    other = f"{UNSUBSCRIBE}\nsubscribe n to 'a' of message_type String calling other"
    text = _class(FIRST, HEAR, TICK, "")
    assert _told(tmp_path, text, other) == _says(READ)
