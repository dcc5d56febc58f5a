"""What else a node does: what is wrong with a statement about it, and what is not."""

from __future__ import annotations

from functools import cache

import pytest
from workspaces import LIBRARIES, FakeReader, catalog, marked, run
from wrong_statements import (
    ANSWER,
    BEFORE,
    GOAL,
    MISTAKES,
    NEAR,
    ON_BOOL,
    ON_BYTES,
    PARAMETER,
    PUBLISH,
    REQUEST,
)
from wrong_values import WRONG_VALUES

from plastron_tui.language import Document, lower
from plastron_tui.model.context import Setting
from plastron_tui.model.interpreter import Interpreter
from plastron_tui.model.kinds import Subscription
from plastron_tui.model.workspace import Node
from plastron_tui.ros.qos import Qos

CASES = [*MISTAKES, *WRONG_VALUES]


@cache
def before(text: str, library: str) -> dict[str, Node]:
    """Return the nodes of a program, which many mistakes stand behind."""
    return dict(run(text, library).workspace.nodes)


@pytest.mark.parametrize("library", ["rospy", "rclpy"])
@pytest.mark.parametrize("case", CASES, ids=[case[0] for case in CASES])
def test_a_statement_with_a_mistake(case: tuple[str, str, str, str | None], library: str) -> None:
    line, code, where, remedy = case
    text = f"{BEFORE}{line}\n"
    found = run(text, library)
    (diagnostic,) = found.diagnostics
    assert (diagnostic.code, marked(text, diagnostic)) == (code, where)
    assert remedy is None or remedy in (diagnostic.help or "")
    for name, node in before(text.removesuffix(text.splitlines()[-1] + "\n"), library).items():
        assert found.workspace.nodes[name].endpoints == node.endpoints


RIGHT = [
    f"{PARAMETER} int_list with default [3]",
    f"{GOAL} order=parameter 'count'",
    f"{REQUEST} a=parameter 'count' * 2",
    f"{ANSWER} sum=received.a + 1",
    f"{ANSWER} received.a + received.b * parameter 'count' - 2",
    f"{ANSWER} received.a * parameter 'count'\nn renames parameter 'count' to 'number'",
    "n publish other to 'kept' of message_type String once",
    f"{NEAR} for_each 'scan'",
    f"{NEAR} for_each 'scan' when any received.ranges < 1",
    f"{NEAR} for_each 'scan' when received.header.frame_id = \"a\"",
    f"{NEAR} for_each 'scan' when all received.ranges < 1e39",
    f"{NEAR} for_each 'scan' when any received.ranges = 0.1",
    *(f"{ON_BYTES} received.data {each}" for each in ("> 0", "< 1", "< 255", "= 255", "= 0.0")),
    f"{ON_BOOL} received.data = True",
    f"{PUBLISH} for_each 'text'\n{PUBLISH} for_each 'news'\n{PUBLISH} at 2 hz",
    f"{NEAR} for_each 'scan'\n{NEAR} for_each 'scan' when any received.ranges < 1",
    f"{PUBLISH} once\n{PUBLISH} for_each 'text' with qos latched",
    "create_message k of message_type Int32 and input received.a[1] * 1e400",
    "n renames parameter 'speed' to 'pace'",
    "n publish go to 'v' of message_type Twist\nn renames parameter 'speed' to 'pace'",
    f"{NEAR} for_each 'scan'\nn renames topic 'scan' to 'front/scan'",
    "n renames action 'acts' to 'deeds'",
]


@pytest.mark.parametrize("library", ["rospy", "rclpy"])
@pytest.mark.parametrize("line", RIGHT)
def test_a_statement_without_one(line: str, library: str) -> None:
    assert run(f"{BEFORE}{line}\n", library).diagnostics == ()


def test_what_ros_2_has_not() -> None:
    text = f"{BEFORE}{PARAMETER} int_list with default []\n"
    assert run(text, "rospy").diagnostics == ()
    (found,) = run(text, "rclpy").diagnostics
    assert (found.code, marked(text, found)) == ("parameter-type-mismatch", "[]")


@pytest.mark.parametrize("name", ["use_sim_time", "qos_overrides.chatter"])
def test_what_each_node_of_ros_2_declares_itself(name: str) -> None:
    text = f"{BEFORE}n has_parameter '{name}' of parameter_type bool with default True\n"
    assert "already-having" not in {each.code for each in run(text, "rospy").diagnostics}
    (found,) = run(text, "rclpy").diagnostics
    assert (found.code, marked(text, found)) == ("already-having", f"'{name}'")


def test_a_default_is_one_that_ros_1_can_keep() -> None:
    text = f"{BEFORE}{PARAMETER} int with default 3000000000\n"
    assert run(text, "rclpy").diagnostics == ()
    (found,) = run(text, "rospy").diagnostics
    assert (found.code, marked(text, found)) == ("parameter-type-mismatch", "3000000000")


@pytest.mark.parametrize(
    ("words", "kept"),
    [
        ("sensor_data", None),
        ("best_effort, depth 5", Qos(history="keep_last", depth=5)),
        ("depth 5", Qos(history="keep_last", depth=5)),
    ],
)
def test_of_quality_of_service_ros_1_keeps_what_it_has(words: str, kept: Qos | None) -> None:
    done = run(f"{BEFORE}subscribe n to 'kept' of message_type String with qos {words}\n", "rospy")
    assert done.workspace.nodes["n"].of(Subscription)["kept"].qos == kept


IN_ROS_1 = [
    ("create_node 'k' as k managed", "managed", "error"),
    ("n publish m to 'd' of message_type String with qos best_effort", "best_effort", "warning"),
    ("subscribe n to 'd' of message_type String with qos lease 2, depth 3", "lease 2", "warning"),
]


@pytest.mark.parametrize(("line", "where", "severity"), IN_ROS_1)
def test_what_ros_1_has_not(line: str, where: str, severity: str) -> None:
    text = f"{BEFORE}{line}\n"
    (found,) = run(text, "rospy").diagnostics
    assert (found.code, marked(text, found)) == ("not-in-ros-1", where)
    assert found.severity.value == severity
    assert run(text, "rclpy").diagnostics == ()


CONSEQUENCES = [
    "n has_parameter 'p' of parameter_type flot with default 1\nn repeats f at parameter 'p' hz",
    "n has_parameter 'p' of parameter_type float default 1\nn repeats f at parameter 'p' hz",
    "n has_parameter 'p' of parameter_type flot with default 1\nn no_longer_has_parameter 'p'",
    "n repeats beat at 0 hz\nn stop_repeating beat",
    "n provides_action 'dance' of action_type Danc\nn stop_action 'dance'",
    "n sends_goal to 'dance' of action_type Danc with input none\nn stop_goal to 'dance'",
    "subscribe n to 'joy' of message_type Joyy\n"
    "n publish m to 'd' of message_type String for_each 'joy'",
]


@pytest.mark.parametrize("library", ["rospy", "rclpy"])
@pytest.mark.parametrize("lines", CONSEQUENCES)
def test_what_follows_from_a_mistake_is_none_of_its_own(lines: str, library: str) -> None:
    assert len(run(f"{BEFORE}{lines}\n", library).diagnostics) == 1


# A mistake, its message, the fix, and what its labels say and mark.
WORDS: list[tuple[str, str, str | None, dict[str, str]]] = [
    (
        "n publish go to 'a' of message_type Twist\nn no_longer_has_parameter 'speed'",
        "`n` needs `speed` for something else",
        None,
        {"needed here": "n publish go to 'a' of message_type Twist"},
    ),
    (
        "n has_parameter 'b' of parameter_type int with default 1\n"
        "n has_parameter 'b' of parameter_type int with default 2",
        "`n` has the parameter `b` already",
        "",
        {"said first here": "n has_parameter 'b' of parameter_type int with default 1"},
    ),
    (
        "create_message k of message_type Twist and input linear.x=received.ranges\n"
        "n publish k to 'd' of message_type Twist for_each 'scan'",
        "`received.ranges` is a list of numbers, and `linear.x` takes a number",
        None,
        {"sent here": "k"},
    ),
    (
        "create_message k of message_type Twist and input linear.x=received.rangs[1]\n"
        "n publish k to 'd' of message_type Twist for_each 'scan'",
        "what is received has no field `rangs`",
        "received.ranges[1]",
        {"sent here": "k"},
    ),
    (
        NEAR,
        "nothing is received that `received.ranges[0]` could be of",
        None,
        {"made here": "received.ranges[0] * 2"},
    ),
    (
        f"{ON_BYTES} received.data < 300",
        "every `uint8` is less than 300: the condition always holds",
        None,
        {},
    ),
    (
        f"{ON_BYTES} received.data > 255",
        "no `uint8` is greater than 255: the condition never holds",
        None,
        {},
    ),
    (f"{NEAR} for_each 'scan' when received.header = 1", "is not compared like this", None, {}),
    (f"{ON_BYTES} received.data = True", "and is not compared like this", "1", {}),
    ("n repeats f at 0 hz", "a rate is greater than 0 hz", None, {}),
    ("n repeats f at -1 hz", "a rate is greater than 0 hz", "1", {}),
    ("n repeats f at 1e9 hz", "at most 1e+06 hz", None, {}),
    ("n repeats f at parameter 'idle' hz", "no rate: a rate is greater than 0 hz", None, {}),
    (
        f"{PARAMETER} float with default 1 between 2.5 and 0",
        "2.5 is greater than 0",
        "0 and 2.5",
        {},
    ),
    ("n repeats f at parameter 'sped' hz", "has no parameter `sped`", "parameter 'speed'", {}),
]


@pytest.mark.parametrize("case", WORDS, ids=[case[0] for case in WORDS])
def test_what_is_said_of_a_mistake(case: tuple[str, str, str | None, dict[str, str]]) -> None:
    lines, message, written, labels = case
    text = f"{BEFORE}{lines}\n"
    (found,) = run(text).diagnostics
    assert message in found.message
    assert (None if found.fix is None else found.fix.edits[0].text) == written
    assert {each.message: text[each.span.start : each.span.end] for each in found.labels} == labels


def test_a_message_of_an_earlier_program_is_wrong_where_it_is_sent() -> None:
    setting = Setting("rclpy", LIBRARIES, catalog, FakeReader())
    interpreter = Interpreter(setting)
    made = "create_message k of message_type Twist and input linear.x=parameter 'sped'\n"
    assert interpreter.run(lower(Document(f"{BEFORE}{made}".encode()))) == ()
    sent = "n publish k to 'd' of message_type Twist\n"
    (found,) = interpreter.run(lower(Document(sent.encode())))
    assert (marked(sent, found), found.fix, found.labels) == ("k", None, ())
