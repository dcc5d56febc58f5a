"""What is shown as a guess: another file may say otherwise."""

from __future__ import annotations

from pathlib import Path

import pytest
from file_sets import one
from updates import Outcome

from plastron_tui.model.inspection import inspect_json, inspect_text
from plastron_tui.sources.python.reader import read_python

CLASS = (
    "import rospy\nfrom std_msgs.msg import String\n\n\nclass Driver:\n"
    "    def __init__(self, topic='scan'):\n        self.topic = topic\n"
    "        rospy.Subscriber(self.topic, String, print)\n"
)
USE = "rospy.Publisher('a', Float32MultiArray, queue_size=1)\n"

FILES = {
    CLASS: True,
    CLASS + "\n\nDriver()\n": False,
    CLASS + "\n\nDriver('scan')\n": False,
    CLASS.replace("self.topic,", "'scan',"): False,
    f"import rospy\nfrom zephyr.msg import *\n{USE}": True,
    f"import rospy\nfrom zephyr.msg import *\nfrom helpers import *\n{USE}": True,
    # Python takes the last module that has a name.
    f"import rospy\nfrom std_msgs.msg import *\nfrom helpers import *\n{USE}": False,
    f"import rospy\nfrom helpers import *\nfrom std_msgs.msg import *\n{USE}": False,
    f"import rospy\nfrom std_msgs.msg import *\nfrom zephyr.msg import *\n{USE}": True,
    f"import rospy\nfrom zephyr.msg import *\nfrom std_msgs.msg import *\n{USE}": False,
    f"import rospy\nfrom std_msgs.msg import *\nfrom std_srvs.srv import *\n{USE}": False,
    f"import rospy\nfrom std_msgs.msg import *\nfrom geometry_msgs.msg import *\n{USE}": False,
    f"import rospy\nfrom std_msgs.msg import *\nfrom math import *\n{USE}": False,
    f"import rospy\nfrom std_msgs.msg import *\nfrom zephyr.msg import *\n{USE}".replace(
        "Float32MultiArray", "Wheel"
    ): True,
    f"import rospy\nfrom math import *\nfrom zephyr.msg import *\n{USE}".replace(
        "Float32MultiArray", "Wheel"
    ): False,
    f"import rospy\nfrom std_msgs.msg import Float32MultiArray\n{USE}": False,
}


@pytest.mark.parametrize("text", FILES)
def test_what_another_file_may_say_otherwise_is_a_guess(text: str) -> None:
    source = read_python(Path("node.py"), one(text.encode())).source
    assert source is not None
    (found,) = source.endpoints
    assert found.is_guess is FILES[text]
    assert found.name is not None
    assert found.type is not None
    assert ("(a guess)" in inspect_text(source)) is FILES[text]
    assert ('"guess": True' in str(inspect_json(source)).replace("'", '"')) is FILES[text]


MADE = "\n\nDriver()\n"
RETYPED = "subscribe n to 'scan' of message_type Int32 calling print"
CHANGES = {
    "n renames topic 'scan' to 'b'": CLASS.replace("'scan'", "'b'"),
    "unsubscribe n from 'scan'": None,
    f"unsubscribe n from 'scan'\n{RETYPED}": CLASS.replace("String", "Int32"),
    "subscribe n to 'b' of message_type String": None,
}


@pytest.mark.parametrize("statements", CHANGES)
def test_a_change_that_goes_by_a_guess_is_told(tmp_path: Path, statements: str) -> None:
    outcome = Outcome(tmp_path, "rospy", CLASS, statements)
    assert CHANGES[statements] in (None, outcome.text)
    assert [(str(each.code), each.message, each.help) for each in outcome.found] == [
        (
            "guessed-name",
            "the name `scan` in line 8 is the default of `topic`, for which another file may give "
            "another name",
            "look at what other files give to `Driver`",
        )
    ] * (not statements.startswith("subscribe"))
    assert Outcome(tmp_path, "rospy", CLASS + MADE, statements).found == []


HEAD = "import rospy\nfrom std_msgs.msg import String\n\n\n"
SAID = {
    "def start(topic='scan'):\n    rospy.Subscriber(topic, String, print)\n": (
        "line 6 is the default of `topic`", "`start`"
    ),
    "def start(topic='scan'):\n    rospy.Subscriber(topic, String, print)\n\n\n"
    "def go(topic='scan'):\n    rospy.Subscriber(topic, String, print)\n\n\ngo()\n": (
        "line 6 is the default of `topic`", "`start`"
    ),
    "class Driver:\n    def start(self, topic='scan'):\n"
    "        rospy.Subscriber(topic, String, print)\n": (
        "line 7 is the default of `topic`", "`start`"
    ),
    "def start(a='scan', b='scan'):\n    rospy.Subscriber(a, String, print)\n"
    "    rospy.Subscriber(b, String, print)\n    rospy.Subscriber('scan', String, print)\n": (
        "lines 6, 7 is the default of `a`, `b`", "`start`"
    ),
}  # fmt: skip


@pytest.mark.parametrize("text", SAID)
def test_what_gives_another_name_is_told(tmp_path: Path, text: str) -> None:
    outcome = Outcome(tmp_path, "rospy", HEAD + text, "unsubscribe n from 'scan'")
    where, user = SAID[text]
    (found,) = (each for each in outcome.found if each.code == "guessed-name")
    assert where in found.message
    assert (found.help or "").endswith(f" {user}")
