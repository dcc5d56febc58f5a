"""Statements with a mistake: what is said, and that they have no effect."""

from __future__ import annotations

import pytest
from workspaces import (
    NODE,
    TALKER,
    codes,
    marked,
    run,
    workspace,
)

from plastron_tui.model.kinds import Publisher

FUNCTIONS = {
    "subscribe n to 'a' of message_type String calling f\n"
    "n provides_service 's' of service_type Trigger calling f\n": ["function-conflict"],
    "n provides_service 's' of service_type Trigger calling f\n"
    "subscribe n to 'a' of message_type String calling f\n": ["function-conflict"],
    "n provides_service 's' of service_type Trigger calling f\n"
    "n provides_service 't' of service_type SetBool calling f\n": ["function-conflict"],
    "n provides_service 's' of service_type Trigger calling f\n"
    "n provides_service 't' of service_type Trigger calling f\n": [],
    "subscribe n to 'a' of message_type String calling f\n"
    "subscribe n to 'b' of message_type String calling f\n": [],
    "subscribe n to 'a' of message_type String calling f\n"
    "unsubscribe n from 'a'\n"
    "n provides_service 's' of service_type Trigger calling f\n": [],
    "subscribe n to 'a' of message_type String calling class\n": ["invalid-function"],
    "n provides_service 's' of service_type Trigger calling None\n": ["invalid-function"],
}


@pytest.mark.parametrize(("text", "expected"), FUNCTIONS.items(), ids=range(len(FUNCTIONS)))
def test_functions(text: str, expected: list[str]) -> None:
    assert codes(NODE + text) == expected


MISTAKES: list[tuple[str, str, str, str | None]] = [
    ("create_node 'other' as n", "variable-exists", "n", "another name"),
    ("create_message n of message_type String and input none", "variable-exists", "n", None),
    ("create_node 'x' as m", "variable-exists", "m", None),
    ("create_node 'talker' as t", "node-exists", "'talker'", "ROS 1 stops the first"),
    ("create_node 'talker' as t using rclpy", "node-exists", "'talker'", "ROS 2 runs both"),
    ("create_node 'x' as _x", "invalid-variable", "_x", "write `x`"),
    ("create_node 'x' as x using rospi", "unknown-library", "rospi", "did you mean `rospy`?"),
    ("create_node 'x' as x using ros2", "unknown-library", "ros2", "did you mean `rclpy`?"),
    ("create_node 'x' as x using Noetic", "unknown-library", "Noetic", "did you mean `rospy`?"),
    ("generate_node n using turtle", "unknown-library", "turtle", "rospy, rclpy"),
    ("create_node '../../x' as x", "invalid-name", "/", None),
    ("create_node '__import__(os)' as x", "invalid-name", "(", None),
    ("create_node '' as x", "invalid-name", "", None),
    ("subscribe n to 'a b' of message_type String", "invalid-name", " ", "write 'a_b'"),
    ("subscribe n to 'é' of message_type String", "invalid-name", "é", None),
    ("n provides_service 'a//b' of service_type Trigger", "invalid-name", "//", None),
    ("subscribe nn to 'a' of message_type String", "unknown-node", "nn", "did you mean `n`?"),
    ("subscribe m to 'a' of message_type String", "unknown-node", "m", "`m` is a message"),
    ("generate_node zzz", "unknown-node", "zzz", "`create_node 'zzz' as zzz`"),
    (
        "n publish zzz to 'a' of message_type String",
        "unknown-message",
        "zzz",
        "`create_message zzz of message_type String and input ...`",
    ),
    ("n publish mm to 'a' of message_type String", "unknown-message", "mm", "did you mean `m`?"),
    ("n publish n to 'a' of message_type String", "unknown-message", "n", "`n` is a node"),
    ("n publish m to 'a' of message_type Strin", "unknown-type", "Strin", "`String`"),
    ("n publish m to 'a' of message_type Int32", "message-type-mismatch", "Int32", "String"),
    ("n publish m to 'a' of message_type String at 0 hz", "invalid-rate", "0", None),
    ("n publish m to 'a' of message_type String at -1 hz", "invalid-rate", "-1", "write `at 1 hz`"),
    ("n publish m to 'a' of message_type String at 1e7 hz", "invalid-rate", "1e7", None),
    ("n publish m to 'a' of message_type String at 1e999 hz", "invalid-rate", "1e999", None),
    (
        "n publish m to 'a' of message_type String at 0.0000000001 hz",
        "invalid-rate",
        "0.0000000001",
        None,
    ),
    ("n publish m to 'a' of message_type String at 1e-999 hz", "invalid-rate", "1e-999", None),
    ("n publish m to 'chatter' of message_type String", "already-publishing", "'chatter'", None),
    ("n stop_publishing to 'chater'", "not-publishing", "'chater'", "did you mean `chatter`?"),
    ("unsubscribe n from 'chatter'", "not-subscribed", "'chatter'", None),
    ("n stop_service 's'", "not-providing", "'s'", None),
    ("n stop_request 's'", "not-requesting", "'s'", None),
    ("subscribe n to 'chatter' of message_type Int32", "topic-type-conflict", "Int32", "String"),
    ("load nowhere as x", "file-not-found", "nowhere", None),
]


@pytest.mark.parametrize("case", MISTAKES, ids=[case[0] for case in MISTAKES])
def test_a_statement_with_a_mistake_has_no_effect(case: tuple[str, str, str, str | None]) -> None:
    line, code, where, remedy = case
    text = TALKER + line + "\n"
    found = run(text)
    (diagnostic,) = found.diagnostics
    assert diagnostic.code == code
    assert marked(text, diagnostic).startswith(where)
    assert remedy is None or remedy in (diagnostic.help or "")
    before = workspace(TALKER)
    after = found.workspace
    assert list(after.nodes) == list(before.nodes)
    assert list(after.messages) == list(before.messages)
    assert after.generations == []
    assert after.nodes["n"].endpoints.keys() == before.nodes["n"].endpoints.keys()
    assert len(after.nodes["n"].of(Publisher)["chatter"].publications) == 1


TWO_MISTAKES = {
    "subscribe n to 'a b' of message_type Strin": ["invalid-name", "unknown-type"],
    "n provides_service 'a//b' of service_type Trigge": ["invalid-name", "unknown-type"],
    "n publish zzz to 'a b' of message_type Strin": [
        "unknown-message", "invalid-name", "unknown-type"
    ],
    "subscribe zzz to 'a b' of message_type String": ["unknown-node", "invalid-name"],
    "subscribe zzz to '~b' of message_type String": ["unknown-node"],
}  # fmt: skip


@pytest.mark.parametrize("line", TWO_MISTAKES)
def test_all_mistakes_of_a_statement_are_told(line: str) -> None:
    assert codes(f"{TALKER}{line}\n") == TWO_MISTAKES[line]


def test_a_node_is_not_called_idle_for_a_misspelt_name() -> None:
    text = NODE + "subscribe nn to 'a' of message_type String\ngenerate_node n\n"
    assert codes(text) == ["unknown-node"]


def test_an_idle_node_is_not_generated() -> None:
    text = NODE + "generate_node n\n"
    found = run(text)
    (diagnostic,) = found.diagnostics
    assert (diagnostic.code, marked(text, diagnostic)) == ("idle-node", "n")
    assert found.workspace.generations == []
