"""Functions that stay in a file though nothing calls them any more: they are told."""

from __future__ import annotations

from pathlib import Path

import pytest
from updates import Outcome

from plastron_tui.output.writer import write
from plastron_tui.session import Options, Session

HEAD = """\
import rospy
from std_msgs.msg import String
from std_srvs.srv import Empty


def work(msg):
    print(msg.data)


"""
UNSUBSCRIBE = "unsubscribe n from 'a'"
CALLING = f"{UNSUBSCRIBE}\nsubscribe n to 'a' of message_type String calling"
SUB = "rospy.Subscriber('a', String, work)\n"
WORK = "nothing in the file calls `work` (line {0}) any more"
# The file below its head, the statements, and what is told.
CASES = {
    "a callback": (SUB, UNSUBSCRIBE, [WORK.format(5)]),
    "a service": (
        "rospy.Service('a', Empty, handler=work)\n", "n stop_service 'a'", [WORK.format(5)],
    ),
    "another callback": (
        f"def other(msg):\n    print(msg)\n\n\n{SUB}", f"{CALLING} other", [WORK.format(6)],
    ),
    "another callback, which is written": (SUB, f"{CALLING} other", [WORK.format(6)]),
    "another callback, where two calls say the old one": (
        f"rospy.init_node('n')\n{SUB}{SUB}", f"{CALLING} other", [WORK.format(6)],
    ),
    "a callback that a lambda calls": (
        "rospy.Subscriber('a', String, lambda msg: work(msg))\n", UNSUBSCRIBE, [WORK.format(5)],
    ),
    "a method": (
        "class N:\n    def __init__(self):\n        rospy.Subscriber('a', String, self.hear)\n"
        "        self.x = 1\n\n    def hear(self, msg):\n        self.x = msg.data\n\n\nN()\n",
        UNSUBSCRIBE,
        ["nothing in the file calls `hear` (line 13) any more"],
    ),
    "one that calls itself": (
        "def again(msg):\n    return again(msg)\n\n\nrospy.Subscriber('a', String, again)\n",
        UNSUBSCRIBE,
        ["nothing in the file calls `again` (line 9) any more"],
    ),
    "what made a message": (
        "def make():\n    return String('x')\n\n\np = rospy.Publisher('a', String)\n"
        "p.publish(make())\n",
        "n stop_publishing to 'a'",
        ["nothing in the file calls `make` (line 10) any more"],
    ),
    "several": (
        f"def more(m):\n    print(m.data)\n\n\n{SUB}rospy.Subscriber('b', String, more)\n",
        f"{UNSUBSCRIBE}\nunsubscribe n from 'b'",
        ["nothing in the file calls `work` (line 5), `more` (line 9) any more"],
    ),
    "a stub goes": (
        "def hear(msg):\n    pass\n\n\nrospy.Subscriber('a', String, hear)\n", UNSUBSCRIBE, [],
    ),
    "one that is called": (f"{SUB}work(String())\n", UNSUBSCRIBE, []),
    "one that another topic calls": (
        f"{SUB}rospy.Subscriber('b', String, work)\n", UNSUBSCRIBE, [],
    ),
    "one that a text names": (f"{SUB}globals()['work'](String())\n", UNSUBSCRIBE, []),
    "one that a decorator knows": (
        "@register\ndef hear(msg):\n    print(msg)\n\n\nrospy.Subscriber('a', String, hear)\n",
        UNSUBSCRIBE,
        [],
    ),
    "one that nothing called before": (
        "def hear(m):\n    print(m)\n\n\nrospy.Subscriber('a', String, other.hear)\n",
        UNSUBSCRIBE,
        [],
    ),
    "a node of its name": (
        "rospy.init_node('work')\n" + SUB,
        UNSUBSCRIBE,
        ["nothing in the file calls `work` (line 5) any more"],
    ),
    "a text that is its name": (SUB + "run('work')\n", UNSUBSCRIBE, []),
    "another name": (SUB, "n renames topic 'a' to 'b'", []),
}  # fmt: skip


@pytest.mark.parametrize("name", CASES)
def test_a_function_that_nothing_calls_any_more_is_told(tmp_path: Path, name: str) -> None:
    body, statements, messages = CASES[name]
    outcome = Outcome(tmp_path, "rospy", HEAD + body, statements)
    assert outcome.text != HEAD + body
    assert {str(each.code) for each in outcome.found} <= {"uncalled-function"}
    assert [each.message for each in outcome.found] == messages
    them = "them if they are" if "), " in "".join(messages) else "it if it is"
    assert all(each.help == f"remove {them} of no other use" for each in outcome.found)
    names = [each for each in ("work", "hear", "again", "make") if f"`{each}`" in str(messages)]
    assert all(f"def {each}(" in outcome.text for each in names)
    assert all(each.span is not None for each in outcome.found)


def test_it_is_told_once(tmp_path: Path) -> None:
    (tmp_path / "node.py").write_text(HEAD + SUB)

    def generate(name: str) -> list[str]:
        program = f"load 'node.py' as n\nunsubscribe n from 'a'\ngenerate_node n{name}\n"
        options = Options("rospy", tmp_path / "output")
        session = Session(program.encode(), tmp_path / "a.plastron", options, environ={})
        plan, told = session.plan()
        assert write(plan).diagnostics == ()
        return [str(each.code) for each in told]

    assert generate("") == ["uncalled-function"]
    assert generate("") == []
    written = tmp_path / "output" / "node.py"
    written.write_text(written.read_text().replace("def work(msg):\n    print(msg.data)\n", ""))
    assert generate("  // again") == ["merged-by-hand"]
