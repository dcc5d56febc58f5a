"""One mistake gives one message: what follows from it gives none, and the rest still runs."""

from __future__ import annotations

import pytest
from workspaces import codes, run

from plastron_tui.model.kinds import Subscription

NODE = "create_node 'talker' as n\n"
MESSAGE = 'create_message m of message_type String and input "hi"\n'
LISTEN = "subscribe n to 'a' of message_type String\n"

CASES: list[tuple[str, list[str]]] = [
    # What other statements are for is broken, not missing.
    *(
        (f"create_node 'talker' as n using {library}\n{broken}\n{user}\ngenerate_node n\n", [code])
        for library in ("rospy", "rclpy")
        for broken, user, code in (
            (
                "n has_parameter 'rate' of parameter_type flot with default 1",
                "n repeats look at parameter 'rate' hz",
                "unknown-parameter-type",
            ),
            (
                "n has_parameter 'rate' of parameter_type float with defalt 1",
                "n repeats look at parameter 'rate' hz",
                "syntax-error",
            ),
            (
                "n has_parameter 'rate' of parameter_type float with default 1 between 3 and 2",
                "n no_longer_has_parameter 'rate'",
                "invalid-range",
            ),
            ("n repeats look at -2 hz", "n stop_repeating look", "invalid-rate"),
            (
                "n provides_action 'do' of action_type LookupTransfrm",
                "n stop_action 'do'",
                "unknown-type",
            ),
            (
                "n sends_goal to 'do' of action_type LookupTransfrm with input none",
                "n renames action 'do' to 'undo'",
                "unknown-type",
            ),
            (
                "subscribe n to 'scan' of message_type LaserScn",
                "create_message m of message_type String and input none\n"
                "n publish m to 'a' of message_type String for_each 'scan'",
                "unknown-type",
            ),
        )
    ),
    # What a line was to declare is broken, not unknown.
    ("creat_node 'talker' as n\n" + LISTEN + "generate_node n\n", ["unknown-statement"]),
    ("create_node 'talker' is n\n" + LISTEN + "generate_node n\n", ["syntax-error"]),
    ("create_node talker as n\n" + LISTEN + "generate_node n\n", ["syntax-error"]),
    ("create_node 'a b' as n\n" + LISTEN + "generate_node n\n", ["invalid-name"]),
    ("load nowhere as n\n" + LISTEN + "generate_node n\n", ["file-not-found"]),
    ("load 'x.py as n\n" + LISTEN, ["unclosed-quote"]),
    (
        NODE
        + "create_message m of message_type Strng and input 1\n"
        + "n publish m to 'a' of message_type String\ngenerate_node n\n",
        ["unknown-type"],
    ),
    (
        NODE
        + "create_message m of message_type String and input hi\n"
        + "n publish m to 'a' of message_type String\ngenerate_node n\n",
        ["syntax-error"],
    ),
    ("create_node 'talker' as\n" + LISTEN + "generate_node n\n", ["syntax-error"]),
    # A line that does not say what it declares stands for one variable, not for all.
    (
        "create_node 'talker'\ngenerate_node n\ngenerate_node n\ngenerate_node k\n",
        ["syntax-error", "unknown-node"],
    ),
    # What is really unknown is said, for each statement that names it.
    (
        "creat_node 'talker' as n\nsubscribe other to 'a' of message_type String\n",
        ["unknown-statement", "unknown-node"],
    ),
    ("generate_node x\ngenerate_node x\n", ["unknown-node", "unknown-node"]),
    (
        NODE
        + "create_message m of message_type Strng and input 1\n"
        + "n publish m to 'a' of message_type Strng\n"
        + "subscribe n to 'b' of message_type Strng\n",
        ["unknown-type"] * 3,
    ),
    (
        "creat_node 'talker' as n\n"
        + "subscribe n to 'a' of message_type Strng\n"
        + "n provides_service 's' of service_type Triger\n"
        + "n publish m to 'b' of message_type std_msgs/msg/Strng\n",
        ["unknown-statement", *["unknown-type"] * 2, "unknown-message", "unknown-type"],
    ),
    (
        "create_node 'talker' as n using rclpy\n"
        + "create_message m of message_type Strng and input 1\n"
        + "n publish m to 'a' of message_type std_msgs/Time\n",
        ["unknown-type"] * 2,
    ),
    # Nobody knows for which ROS a broken node is, and ROS 2 has this one.
    (
        "load nowhere as n\nsubscribe n to 'a' of message_type builtin_interfaces/Time\n",
        ["file-not-found"],
    ),
    ("subscribe n too 'a'\ngenerate_node n\n", ["syntax-error", "unknown-node"]),
    # A node that has not got what it was to do is not idle.
    (NODE + "subscribe n to 'a' of message_type Strng\ngenerate_node n\n", ["unknown-type"]),
    (NODE + "subscribe n to 'a b' of message_type String\ngenerate_node n\n", ["invalid-name"]),
    (NODE + "subscribe n to a of message_type String\ngenerate_node n\n", ["syntax-error"]),
    (
        NODE + "n client_requests 'a' of service_type SetBool with input 1\ngenerate_node n\n",
        ["wrong-kind-of-value"],
    ),
    (
        NODE + "create_node 'b' as b\nsubscribe n to a of message_type String\ngenerate_node b\n",
        ["syntax-error", "idle-node"],
    ),
    # What was not begun cannot be stopped; what was not stopped cannot be begun.
    (
        NODE + "subscribe n to 'a' of message_type Strng\nunsubscribe n from 'a'\n",
        ["unknown-type"],
    ),
    (NODE + "subscribe n too 'a'\nunsubscribe n from 'a'\n", ["syntax-error"]),
    (
        NODE + "subscribe n to 'a' of message_type Strng\nunsubscribe n from 'b'\n",
        ["unknown-type", "not-subscribed"],
    ),
    (
        NODE + "n provides_service 's' of service_type Triger\nn stop_service 's'\n",
        ["unknown-type"],
    ),
    (
        NODE + "n client_requests 's' of service_type Triger with input none\nn stop_request 's'\n",
        ["unknown-type"],
    ),
    (
        NODE + MESSAGE + "n publish m to 'a' of message_type Int32\nn stop_publishing to 'a'\n",
        ["message-type-mismatch"],
    ),
    (NODE + LISTEN + "unsubscribe n form 'a'\n" + LISTEN, ["syntax-error"]),
    (
        NODE + LISTEN + "unsubscribe n form 'a'\nsubscribe n to '/a' of message_type Int32\n",
        ["syntax-error", "topic-type-conflict"],
    ),
    # A mistake takes nothing from the lines around it.
    (NODE + "$$$\n" + LISTEN + "((\n" + "generate_node n\n", ["syntax-error", "syntax-error"]),
    # Each of two independent mistakes is said, in the order of the program.
    (
        "subscribe x to 'a' of message_type String\n$\ngenerate_node y\n",
        ["unknown-node", "syntax-error", "unknown-node"],
    ),
]  # fmt: skip


@pytest.mark.parametrize(("text", "expected"), CASES, ids=range(len(CASES)))
def test_one_mistake_one_message(text: str, expected: list[str]) -> None:
    assert codes(text) == expected


def test_the_rest_of_a_program_still_runs() -> None:
    found = run(NODE + "subscribe n to 'b' of message_type Strng\n" + LISTEN + "generate_node n\n")
    assert [each.code for each in found.diagnostics] == ["unknown-type"]
    (generation,) = found.workspace.generations
    assert list(generation.node.of(Subscription)) == ["a"]


def test_every_line_of_a_right_program_may_be_broken() -> None:
    program = (
        NODE
        + MESSAGE
        + "n publish m to 'out' of message_type String\n"
        + LISTEN
        + "n provides_service 's' of service_type Trigger\n"
        + "n client_requests 'c' of service_type SetBool with input True\n"
        + "generate_node n\n"
        + "n stop_publishing to 'out'\n"
        + "unsubscribe n from 'a'\n"
        + "n stop_service 's'\n"
        + "n stop_request 'c'\n"
        + LISTEN
        + "generate_node n\n"
    ).splitlines()
    assert codes("\n".join(program)) == []
    for index, line in enumerate(program):
        words = line.split(" ")
        for cut in range(1, len(words)):
            broken = [*program[:index], " ".join(words[:cut]), *program[index + 1 :]]
            found = codes("\n".join(broken))
            assert len(found) <= 1, broken
