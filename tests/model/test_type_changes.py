"""Types that change while something of the program uses them."""

from __future__ import annotations

import pytest
from workspaces import marked, run, workspace

from plastron_tui.model.kinds import Client, Publisher, Service
from plastron_tui.model.values import MessageValue

HEARD = (
    "create_message_type A with int32 x, float64 y\n"
    "create_node 'n' as n\n"
    "subscribe n to 'in' of message_type A\n"
)
OUT = "create_message out of message_type Float64 and input data="
SENT = "n publish out to 'out' of message_type Float64 for_each 'in'"
COMPUTED = f"{HEARD}{OUT}received.y\n{SENT}\n"
SERVICE = (
    "create_service_type S with int32 x returning int32 y\n"
    "create_node 'n' as n\n"
    "n provides_service 's' of service_type S answering y=received.x\n"
)

# A program, a change to a type, and what is then broken.
BROKEN = [
    (COMPUTED, "A no_longer_has_field 'y'", SENT),
    (COMPUTED, 'A has_field "string y"', SENT),
    (COMPUTED, 'A has_field "float64[] y"', SENT),
    (f"{HEARD}{OUT}1\n{SENT} when received.x < 300\n", "A no_longer_has_field 'x'", SENT),
    (f"{HEARD}{OUT}1\n{SENT} when received.x < 300\n", 'A has_field "uint8 x"', SENT),
    (f"{HEARD}{OUT}1\n{SENT} when received.x < 300\n", 'A has_field "bool x"', SENT),
    (SERVICE, "S no_longer_has_field 'x'", "n provides_service 's'"),
    (SERVICE, 'S has_field "string x"', "n provides_service 's'"),
    (
        "create_message_type A with float64 x\ncreate_node 'n' as n\n"
        "n has_parameter 'p' of parameter_type float with default 0.5\n"
        "create_message m of message_type A and input x=parameter 'p'\n"
        "n publish m to 'out' of message_type A at 1 hz\n",
        'A has_field "string x"',
        "n publish m",
    ),
    (
        "create_message_type In with int32 x\ncreate_message_type A with In inner\n"
        "create_node 'n' as n\nsubscribe n to 'in' of message_type A\n"
        f"{OUT}received.inner.x\n{SENT}\n",
        "In no_longer_has_field 'x'",
        SENT,
    ),
]


@pytest.mark.parametrize("library", ["rclpy", "rospy"])
@pytest.mark.parametrize(
    ("before", "change", "broken"), BROKEN, ids=[str(each[1:2]) for each in BROKEN]
)
def test_a_change_that_a_use_does_not_bear(
    before: str, change: str, broken: str, library: str
) -> None:
    text = f"{before}{change}\n"
    [found] = run(text, library).diagnostics
    assert (found.code, marked(text, found)) == ("type-in-use", change)
    [label] = found.labels
    start, end = label.span
    assert text[start:end].startswith(broken)


@pytest.mark.parametrize(
    "text",
    [
        f"{COMPUTED}n stop_publishing to 'out'\nA no_longer_has_field 'y'\n",
        f"{COMPUTED}A no_longer_has_field 'x'\n",
        "create_service_type S with int32 x returning none\ncreate_node 'n' as n\n"
        "n client_requests 's' of service_type S with input x=5\nn stop_request 's'\n"
        "S no_longer_has_field 'x'\n",
    ],
)
def test_what_is_used_no_longer_keeps_no_type(text: str) -> None:
    workspace(text, "rclpy")


def sent(text: str) -> MessageValue:
    """Return the value that the program's only endpoint with one sends."""
    [node] = workspace(text, "rclpy").nodes.values()
    [publisher] = node.of(Publisher).values()
    [publication] = publisher.publications
    return publication.message.value


def test_values_are_of_the_type_that_their_field_has_now() -> None:
    use = (
        "create_message m of message_type A and input x=5\ncreate_node 'n' as n\n"
        "n publish m to 'out' of message_type A at 1 hz\n"
    )
    made = "create_message_type A with float64 x\n"
    value = sent(f'{made}{use}A has_field "int32 x"\n').fields["x"]
    assert (value, type(value)) == (5, int)
    back = sent(f'{made}{use}A has_field "int32 x"\nA has_field "float32 x"\n').fields["x"]
    assert type(back) is float


def test_answers_and_requests_are_of_the_type_that_their_field_has_now() -> None:
    text = (
        "create_service_type S with float64 x returning float64 y\ncreate_node 'n' as n\n"
        "n provides_service 's' of service_type S answering y=5\n"
        "n client_requests 't' of service_type S with input x=5\n"
        'S has_field "int32 x" in request\nS has_field "int32 y" in response\n'
    )
    [node] = workspace(text, "rclpy").nodes.values()
    answer = node.of(Service)["s"].answer
    assert answer is not None
    assert type(answer.fields["y"]) is int
    [request] = node.of(Client)["t"].requests
    assert type(request.value.fields["x"]) is int
