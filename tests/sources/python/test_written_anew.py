"""What goes when an endpoint is written anew, or sends something else: it is told."""

from __future__ import annotations

from pathlib import Path

import pytest
from updates import Outcome

HEAD = "import rospy\nfrom std_msgs.msg import Int32, String\nrospy.init_node('n')\n"
LOOP = "p = rospy.Publisher('a', Int32, queue_size=1, latch=True)\n{0}"
TAKE = "n stop_publishing to 'a'\nn publish two to 'b' of message_type Int32"


def told(tmp_path: Path, body: str, statements: str) -> tuple[str, list[str]]:
    outcome = Outcome(tmp_path, "rospy", HEAD + body, statements)
    assert {each.code for each in outcome.found} <= {"written-anew", "idle-code"}
    found = [each for each in outcome.found if each.code == "written-anew"]
    assert all((each.help or "").startswith("`renames topic 'a' to '") for each in found)
    return outcome.text.removeprefix(HEAD), [each.message for each in found]


OPTIONS = {
    "two that may be meant": (
        "rospy.Subscriber('a', String, f, queue_size=1, tcp_nodelay=True)\n"
        "rospy.Subscriber('c', String, f, queue_size=1)\n",
        "unsubscribe n from 'a'\nunsubscribe n from 'c'\n"
        "subscribe n to 'b' of message_type String\nsubscribe n to 'd' of message_type String",
        ["`tcp_nodelay=True` of `a` is not kept for `b`"],
    ),
    "one that another has too": (
        "rospy.Subscriber('a', String, f, tcp_nodelay=True)\n"
        "rospy.Subscriber('k', String, f, tcp_nodelay=True)\n"
        "rospy.Publisher('c', String, tcp_nodelay=True, queue_size=1)\n",
        "unsubscribe n from 'a'\nsubscribe n to 'b' of message_type Int32",
        ["`tcp_nodelay=True` of `a` is not kept for `b`"],
    ),
    "of one that goes beside another": (
        "rospy.Subscriber('a', String, f, tcp_nodelay=True)\nrospy.Subscriber('c', String, f)\n",
        "unsubscribe n from 'a'\nunsubscribe n from 'c'\n"
        "subscribe n to 'b' of message_type Int32",
        [],
    ),
    "of one that two follow": (
        "rospy.Subscriber('a', String, f, tcp_nodelay=True)\n",
        "unsubscribe n from 'a'\nsubscribe n to 'b' of message_type Int32\n"
        "subscribe n to 'c' of message_type Float32",
        [],
    ),
    "a length of a queue": (
        "rospy.Subscriber('a', String, f, queue_size=1)\n"
        "rospy.Subscriber('c', String, f, queue_size=None)\n",
        "unsubscribe n from 'a'\nunsubscribe n from 'c'\n"
        "subscribe n to 'b' of message_type String\nsubscribe n to 'd' of message_type String",
        ["`queue_size=1` of `a` is not kept for `b`"],
    ),
    "another type, where nothing else can be meant": (
        "rospy.Subscriber('a', String, f, queue_size=3, tcp_nodelay=True)\n",
        "unsubscribe n from 'a'\nsubscribe n to 'b' of message_type Int32",
        ["`tcp_nodelay=True` of `a` is not kept for `b`"],
    ),
    "nothing that takes its place": (
        "rospy.Subscriber('a', String, f, tcp_nodelay=True)\nrospy.Subscriber('c', Int32, f)\n",
        "unsubscribe n from 'a'",
        [],
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", OPTIONS)
def test_options(tmp_path: Path, name: str) -> None:
    body, statements, expected = OPTIONS[name]
    assert told(tmp_path, body, statements)[1] == expected


# What the file does until it sends, and what of that is left.
SENT = {
    "a constant": ("p.publish(Int32(5))\n", "p.publish(Int32(data=2))\n", []),
    "the same constant": ("p.publish(2)\n", "p.publish(2)\n", []),
    "the same constant by a name": ("p.publish(TWO)\n", "p.publish(TWO)\n", []),
    "the same message": ("p.publish(Int32(2))\n", "p.publish(Int32(2))\n", []),
    "the same field": (
        "m = Int32()\nm.data = 2\np.publish(m)\n",
        "m = Int32()\nm.data = 2\np.publish(m)\n",
        [],
    ),
    "another constant by a name": (
        "p.publish(ONE)\n",
        "p.publish(Int32(data=2))\n",
        ["`b` no longer sends `ONE`, which the node works out"],
    ),
    "a field of two values": (
        "m = Int32()\nm.data = 1\nm.data = 2\np.publish(m)\n",
        "p.publish(Int32(data=2))\n",
        ["`b` no longer sends `m`, which the node works out"],
    ),
    "a value of which a call is left": (
        "t = len(x)\nz = t + work() + t\np.publish(z)\n",
        "work()\np.publish(Int32(data=2))\n",
        ["`b` no longer sends `z`, which the node works out"],
    ),
    "a last value": (
        "y = len(x)\nprint(y)\ny += 1\np.publish(y)\n",
        "y = len(x)\nprint(y)\np.publish(Int32(data=2))\n",
        ["`b` no longer sends `y`, which the node works out"],
    ),
    "a computed message": (
        "m = Int32()\nm.data = len(x)\nprint(m)\np.publish(m)\n",
        "m = Int32()\nm.data = len(x)\nprint(m)\np.publish(Int32(data=2))\n",
        ["`b` no longer sends `m`, which the node works out"],
    ),
}


@pytest.mark.parametrize("name", SENT)
def test_what_was_sent(tmp_path: Path, name: str) -> None:
    before, after, expected = SENT[name]
    frame = "x, ONE, TWO = [], 1, 2\nprint(ONE, x)\n\n\ndef run():\n"
    frame += "    while not rospy.is_shutdown():\n{0}        rospy.sleep(1)\n\n\nrun()\n"

    def indented(text: str) -> str:
        return "".join(f"        {line}\n" for line in text.splitlines())

    body = LOOP.format(frame.format(indented(before)))
    text, messages = told(tmp_path, body, TAKE)
    assert text == body.replace("'a'", "'b'").replace(indented(before), indented(after))
    assert messages == expected


@pytest.mark.parametrize(
    ("often", "told_rate"), [("", ""), (" at 5 hz", ": that is 5 times a second")]
)
def test_another_time_of_sending_is_told(tmp_path: Path, often: str, told_rate: str) -> None:
    body = LOOP.format("def hear(m):\n    print(m)\n    p.publish(2)\n\n\n")
    body += "rospy.Subscriber('c', Int32, hear)\nrospy.spin()\n"
    text, messages = told(tmp_path, body, TAKE + often)
    assert "p.publish(2)" not in text
    assert messages == [f"line 7 no longer decides when `b` is sent{told_rate}"]


@pytest.mark.parametrize("sent", ["m", "Empty()", ""])
def test_a_message_without_fields(tmp_path: Path, sent: str) -> None:
    body = "import rospy\nfrom std_msgs.msg import Empty\np = rospy.Publisher('a', Empty)\n"
    program = "create_message m of message_type std_msgs/Empty and input none\n"
    program += "n stop_publishing to 'a'\nn publish m to 'a' of message_type std_msgs/Empty at 5 hz"
    outcome = Outcome(
        tmp_path, "rospy", f"{body}def f(m):\n    p.publish({sent})\n\n\nf(0)\n", program
    )
    assert "    message = Empty()\n" in outcome.text
    told = [each.message for each in outcome.found if "works out" in each.message]
    assert told == (["`a` no longer sends `m`, which the node works out"] if sent == "m" else [])


def test_what_a_publisher_sent_that_is_written_anew_is_told(tmp_path: Path) -> None:
    body = "def measure():\n    return 1\n\n\nx = measure()\np = q = rospy.Publisher('a', Int32)\n"
    _, messages = told(tmp_path, body + "p.publish(x)\nrospy.spin()\n", TAKE)
    assert "`b` no longer sends `x`, which the node works out" in messages
    assert "line 10 no longer decides when `b` is sent" in messages


LOCALS = {
    "m = Int32()\nm.data = x\np.publish(m)": "p.publish(Int32(data=2))",
    "m = Int32(data=float(x))\np.publish(m)": "m = Int32(data=2)\np.publish(m)",
    "m = Int32()\nfor each in range(x):\n    m.data = each\np.publish(m)": (
        "p.publish(Int32(data=2))"
    ),
    "m = Int32()\nif measure(x):\n    m.data = 2\np.publish(m)": (
        "m = Int32()\nif measure(x):\n    m.data = 2\np.publish(Int32(data=2))"
    ),
    "m = Int32()\nif measure(x):\n    m.data = 2\n    print(x)\np.publish(m)": (
        "if measure(x):\n    print(x)\np.publish(Int32(data=2))"
    ),
    "m = Int32()\nm.data = measure(x)\np.publish(m)": ("measure(x)\np.publish(Int32(data=2))"),
    "y = x + 1\nz = y * 2\np.publish(z)": "p.publish(Int32(data=2))",
    "y = x + 1\nz = y * 2\np.publish(z)\nprint(y)": "y = x + 1\np.publish(Int32(data=2))\nprint(y)",
    "y = next(x)\np.publish(y)": "next(x)\np.publish(Int32(data=2))",
    "m = make()\np.publish(m)": "make()\np.publish(Int32(data=2))",
    "m = Int32()\nm.header.stamp = rospy.Time.now()\np.publish(m)": "p.publish(Int32(data=2))",
    "m = []\nm.append(x)\nm.extend([x])\np.publish(m)": "p.publish(Int32(data=2))",
    "m = []\nm.append(next(x))\np.publish(m)": (
        "m = []\nm.append(next(x))\np.publish(Int32(data=2))"
    ),
    "m = []\nm.sort()\np.publish(m)": "m = []\nm.sort()\np.publish(Int32(data=2))",
    "m = n = Int32()\np.publish(m)\nprint(n)": ("n = Int32()\np.publish(Int32(data=2))\nprint(n)"),
    "m = Int32()\nm[next(x)] = 1\np.publish(m)": (
        "m = Int32()\nm[next(x)] = 1\np.publish(Int32(data=2))"
    ),
    "m = Int32()\nx[m.data] = 1\np.publish(m)": (
        "m = Int32()\nx[m.data] = 1\np.publish(Int32(data=2))"
    ),
    "m = yield\np.publish(m)": "m = yield\np.publish(Int32(data=2))",
    "m = Int32()\nm += 1\np.publish(m)": "p.publish(Int32(data=2))",
    "m = Int32()\np.publish(m)\nm.data = 2": "p.publish(Int32(data=2))",
    "m = Int32()\nx.m = 1\np.publish(m)": "x.m = 1\np.publish(Int32(data=2))",
    "m = Int32()\nf = [m for m in x]\np.publish(m)": (
        "f = [m for m in x]\np.publish(Int32(data=2))"
    ),
    "for m in x:\n    print()\np.publish(m)": "for m in x:\n    print()\np.publish(Int32(data=2))",
    "m = 1\np.publish(x.m)": "m = 1\np.publish(Int32(data=2))",
    "global m\nm = Int32(x)\np.publish(m)": "global m\nm = Int32(x)\np.publish(Int32(data=2))",
}


@pytest.mark.parametrize("before", LOCALS)
def test_locals_that_served_what_is_gone(tmp_path: Path, before: str) -> None:
    frame = "def tick(event):\n    x = rospy.get_time()\n    print(x)\n{0}\n\n\n"
    frame += "rospy.Timer(rospy.Duration(0.1), tick)\n"

    def placed(text: str) -> str:
        return LOOP.format(frame.format("\n".join(f"    {line}" for line in text.splitlines())))

    text, _ = told(tmp_path, placed(before), TAKE)
    assert text == placed(LOCALS[before]).replace("'a'", "'b'")


def test_a_use_that_stands_in_the_way_is_kept_by_a_new_name(tmp_path: Path) -> None:
    body = "p = rospy.Publisher('a', Int32, queue_size=1)\nprint(p.name)\n"
    outcome = Outcome(tmp_path, "rospy", HEAD + body, TAKE)
    assert [str(each.code) for each in outcome.found] == ["endpoint-in-use"]
    help_ = "change this line in the file first, or keep them: `renames topic 'a' to 'b'`"
    assert [each.help for each in outcome.found] == [help_]


def test_a_timer_that_only_sent_what_is_gone_goes(tmp_path: Path) -> None:
    timer = "rospy.Timer(rospy.Duration(1), tick)\n"
    tick = "def tick(event):\n    p.publish(1)\n    p.publish(3)\n\n\n"
    text, _ = told(tmp_path, LOOP.format(tick + timer), TAKE)
    assert "def tick" not in text
    assert timer not in text
    assert text.count("rospy.Timer") == text.count("Int32(data=2)") == 1
