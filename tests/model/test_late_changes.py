from __future__ import annotations

import pytest
from workspaces import marked, run

from plastron_tui.language import DECLARATIONS, SlotKind

EARS = "create_node 'ears' as n\nsubscribe n to 'a' of message_type String\n"
HEAR = "subscribe n to 'b' of message_type String\n"
GENERATE = "generate_node n\n"
MESSAGE = "create_message m of message_type String and input none\n"

# A program, and the statements that come too late.
TABLE: list[tuple[str, list[str]]] = [
    (EARS + HEAR, []),
    (EARS + HEAR + GENERATE, []),
    (EARS + GENERATE + HEAR, [HEAR]),
    (EARS + GENERATE + HEAR + GENERATE, []),
    (EARS + GENERATE + MESSAGE, []),
    (EARS + GENERATE + "unsubscribe n from 'a'\n", ["unsubscribe n from 'a'\n"]),
    (
        EARS + MESSAGE + GENERATE + "n publish m to 'c' of message_type String\n" + HEAR,
        ["n publish m to 'c' of message_type String\n", HEAR],
    ),
    (
        EARS + GENERATE + "n provides_service 's' of service_type Trigger\n",
        ["n provides_service 's' of service_type Trigger\n"],
    ),
    (EARS + GENERATE + EARS.replace("ears", "o").replace(" n", " o") + "generate_node o\n", []),
]


@pytest.mark.parametrize(("program", "late"), TABLE)
def test_a_statement_after_the_last_generate_is_in_no_file(program: str, late: list[str]) -> None:
    found = run(program).diagnostics
    assert [each.code for each in found] == ["changed-after-generating"] * len(late)
    assert [f"{marked(program, each)}\n" for each in found] == late
    for each in found:
        assert each.severity.value == "warning"
        assert marked(program, each._replace(span=each.labels[0].span)) == GENERATE.strip()


CHANGES = """\
subscribe n to 'b' of message_type String
unsubscribe n from 'a'
n publish m to 'q' of message_type String
n stop_publishing to 'p'
n client_requests 'd' of service_type Trigger with input none
n stop_request 'c'
n provides_service 't' of service_type Trigger
n stop_service 's'
n renames topic 'b' to 'e'
n provides_action 'w' of action_type Fibonacci
n stop_action 'v'
n sends_goal to 'y' of action_type Fibonacci with input none
n stop_goal to 'x'
n repeats g at 1 hz
n stop_repeating f
n has_parameter 'h' of parameter_type int with default 1
n no_longer_has_parameter 'i'
"""


def test_every_statement_that_changes_a_node_may_come_too_late() -> None:
    program = f"""\
{EARS}{MESSAGE}n publish m to 'p' of message_type String
n client_requests 'c' of service_type Trigger with input none
n provides_service 's' of service_type Trigger
n provides_action 'v' of action_type Fibonacci
n sends_goal to 'x' of action_type Fibonacci with input none
n repeats f at 1 hz
n has_parameter 'i' of parameter_type int with default 1
{GENERATE}{CHANGES}"""
    found = run(program).diagnostics
    assert {each.code for each in found} == {"changed-after-generating"}
    assert [marked(program, each) for each in found] == CHANGES.splitlines()
    changing = {
        declaration.keyword
        for declaration in DECLARATIONS.values()
        if any(slot.kind is SlotKind.NODE for slot in declaration.slots)
        and not declaration.writes_file
    }
    assert changing <= set(CHANGES.split())


def test_a_late_statement_with_a_mistake_has_one_diagnostic() -> None:
    program = EARS + GENERATE + HEAR.replace("String", "Strng")
    assert [found.code for found in run(program).diagnostics] == ["unknown-type"]
