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


NODE = """\
from geometry_msgs.msg import Twist
from rclpy.node import Node
from std_msgs.msg import Int32
from std_srvs.srv import Empty, SetBool


class N(Node):
    def __init__(self):
        super().__init__('n')
        {made}
"""
# What a callback says of its type before, and after; None where it stays.
SAID = {
    "def f(self, msg: Twist) -> None:\n": "def f(self, msg: Int32) -> None:\n",
    "def f(self, msg: 'Twist'):\n": "def f(self, msg: 'Int32'):\n",
    "def f(self, msg: Twist | None, *, a: int = 1):\n": (
        "def f(self, msg: Int32 | None, *, a: int = 1):\n"
    ),
    "def f(self, msg: 'Optional[Twist]'):\n": "def f(self, msg: 'Optional[Int32]'):\n",
    "def f(self, msg: int):\n": None,
    "def f(self, msg):\n        # type: (Twist) -> None\n": (
        "def f(self, msg):\n        # type: (Int32) -> None\n"
    ),
    "def f(self, msg):  # type: (Twist) -> None\n": "def f(self, msg):  # type: (Int32) -> None\n",
    "def f(self, msg):\n        '''Go.\n\n        :type msg: Twist\n        '''\n": (
        "def f(self, msg):\n        '''Go.\n\n        :type msg: Int32\n        '''\n"
    ),
    "def f(self, msg):\n        '''\n        msg (geometry_msgs.msg.Twist): it\n        '''\n": (
        "def f(self, msg):\n        '''\n        msg (std_msgs.msg.Int32): it\n        '''\n"
    ),
    "def f(self, msg):\n        '''Go by a Twist.'''\n": None,
}  # fmt: skip


@pytest.mark.parametrize("said", SAID)
@pytest.mark.parametrize("other", ["", "\n        self.create_subscription(Twist, 'b', self.f, 1)"])
def test_a_callback_of_nothing_else_says_the_new_type(
    tmp_path: Path, said: str, other: str
) -> None:
    made = f"self.create_subscription(Twist, 'a', self.f, 1){other}"
    text = NODE.format(made=made) + f"\n    {said}        print(msg.linear, msg.copy())\n"
    statements = "unsubscribe n from 'a'\nsubscribe n to 'a' of message_type Int32 calling f"
    outcome = Outcome(tmp_path, "rclpy", text, statements)
    expected = text.replace("Twist, 'a'", "Int32, 'a'")
    if not other:
        expected = expected.replace(said, SAID[said] or said)
    if "Twist" not in expected.partition("import Twist")[2].replace("Go by a Twist", ""):
        expected = expected.replace("from geometry_msgs.msg import Twist\n", "")
    assert outcome.text == expected
    assert [each.message for each in outcome.found] == [
        "`f` was written for `geometry_msgs/Twist`, and gets `std_msgs/Int32`, "
        "which has no `linear`"
    ]


def test_a_handler_says_the_new_type(tmp_path: Path) -> None:
    handler = (
        "    def f(self, request: Empty.Request, response: Empty.Response) -> Empty.Response:\n"
    )
    made = "self.create_service(Empty, 'a', self.f)"
    text = NODE.format(made=made) + f"\n{handler}        return response\n"
    statements = "n stop_service 'a'\nn provides_service 'a' of service_type SetBool"
    outcome = Outcome(tmp_path, "rclpy", text, statements)
    head, _, body = text.partition("class N")
    expected = head.replace("import Empty, SetBool", "import SetBool")
    assert outcome.text == f"{expected}class N{body.replace('Empty', 'SetBool')}"


# Which callbacks go on to be called with messages of another type.
KEPT = {
    "print('heard')": True,
    "print(msg)": True,
    "self.get_logger().info(f'{msg}')": True,
    "self.last = msg": True,
    "self.heard.append(msg)": True,
    "self.x = msg.linear.x": False,
    "self.turn(msg)": False,
    "self.turn(message=msg)": False,
    "self.pub.publish(msg)": False,
}


@pytest.mark.parametrize("line", KEPT)
def test_a_callback_that_needs_the_old_type_is_called_no_longer(tmp_path: Path, line: str) -> None:
    made = "self.create_subscription(Twist, 'a', self.steer, qos_profile_system_default)"
    text = NODE.format(made=made) + f"\n    def steer(self, msg):\n        {line}\n"
    outcome = Outcome(
        tmp_path, "rclpy", text, "unsubscribe n from 'a'\nsubscribe n to 'a' of message_type Int32"
    )
    told = [(str(each.code), each.message) for each in outcome.found]
    if KEPT[line]:
        assert "Int32, 'a', self.steer, qos_profile_system_default)" in outcome.text
        assert "on_a" not in outcome.text
    else:
        assert "Int32, 'a', self.on_a, qos_profile_system_default)" in outcome.text
        assert "    def on_a(self, msg):\n        self.get_logger().info" in outcome.text
        message = "`steer` no longer gets `a`: it was written for `geometry_msgs/Twist`"
        message += ", and `std_msgs/Int32` has no `linear`" if "linear" in line else ""
        assert told[0] == ("other-type", message)
        assert told[1][0] == "uncalled-function"


@pytest.mark.parametrize(
    ("given", "is_kept"),
    [
        ("lambda m: print(m)", True),
        ("lambda m: self.heard.append(m)", True),
        ("lambda m: self.steer(m, 1)", False),
        ("lambda m: self.heard.append(m.linear)", False),
    ],
)
def test_a_lambda_that_needs_the_old_type_goes(tmp_path: Path, given: str, is_kept: bool) -> None:
    made = f"self.create_subscription(Twist, 'a', {given}, 10)"
    text = NODE.format(made=made) + "\n    def steer(self, msg, x):\n        pass\n"
    outcome = Outcome(
        tmp_path, "rclpy", text, "unsubscribe n from 'a'\nsubscribe n to 'a' of message_type Int32"
    )
    after = given if is_kept else "self.on_a"
    assert f"self.create_subscription(Int32, 'a', {after}, 10)" in outcome.text
    code = "other-type" if is_kept else "written-anew"
    assert str(outcome.found[0].code) == code


def test_a_handler_that_needs_the_old_request_is_called_no_longer(tmp_path: Path) -> None:
    head = "import rospy\nfrom nav_msgs.srv import SetMap\n\n\n"
    handler = "def serve(request):\n    return request.map\n\n\n"
    statements = "n stop_service 'a'\nn provides_service 'a' of service_type SetBool"
    made = "rospy.Service('a', SetMap, serve)\n"
    outcome = Outcome(tmp_path, "rospy", head + handler + made, statements)
    assert "rospy.Service('a', SetBool, handle_a)\n" in outcome.text
    assert [str(each.code) for each in outcome.found] == ["other-type", "uncalled-function"]
