"""Nodes that a program loads from files."""

from __future__ import annotations

import pytest
from robots_run import applied
from workspaces import (
    MESSAGE,
    TALKER,
    FakeReader,
    codes,
    endpoint,
    run,
    source,
    workspace,
)

from plastron_tui.model.kinds import Client, Publisher, Service, Subscription
from plastron_tui.model.source import EndpointKind

LOADED = source(
    endpoint(EndpointKind.PUBLISHER, "out", "std_msgs/String"),
    endpoint(EndpointKind.SUBSCRIPTION, "in", "std_msgs/String", "on_in"),
    endpoint(EndpointKind.SERVICE, "ask", "std_srvs/Trigger", "answer"),
    endpoint(EndpointKind.CLIENT, "call", "std_srvs/SetBool"),
    endpoint(EndpointKind.PUBLISHER, None, "std_msgs/String"),
    endpoint(EndpointKind.SUBSCRIPTION, "untyped"),
)


def test_load() -> None:
    reader = FakeReader({"driver": LOADED})
    node = workspace("load driver as d\n", reader=reader).nodes["d"]
    assert (node.name, node.variable, node.library) == ("driver", "d", "rospy")
    assert node.source is LOADED
    assert list(node.of(Publisher)) == ["out"]
    assert node.of(Publisher)["out"].publications == ()
    assert {key: each.callback for key, each in node.of(Subscription).items()} == {
        "in": "on_in",
        "untyped": None,
    }
    assert node.of(Service)["ask"].callback == "answer"
    assert node.of(Client)["call"].requests == ()


def test_load_asks_the_reader_for_what_is_written() -> None:
    reader = FakeReader({"driver": LOADED, "a/b.py": LOADED})
    text = TALKER + "generate_node n\nload driver as d\nload 'a/b.py' as e\n"
    workspace(text, reader=reader)
    assert [(each.source, each.is_path) for each in reader.requests] == [
        ("driver", False),
        ("a/b.py", True),
    ]
    assert [each.node.name for each in reader.requests[0].generated] == ["talker"]


LOAD_CASES = {
    "unsubscribe d from 'in'\nsubscribe d to 'new' of message_type String\n": [],
    "unsubscribe d from 'in'\nsubscribe d to 'in' of message_type Int32\n": [],
    "subscribe d to 'in' of message_type String\n": ["already-subscribed"],
    "subscribe d to 'new' of message_type String calling answer\n": ["function-conflict"],
    "subscribe d to 'untyped' of message_type Int32\n": ["already-subscribed"],
    "d stop_request 'call'\nd stop_service 'ask'\nd stop_publishing to 'out'\n": [],
    "unsubscribe d from 'out'\n": ["not-subscribed"],
    "create_node 'x' as x\nsubscribe x to 'out' of message_type Int32\n": ["topic-type-conflict"],
    "create_node 'x' as x\nx provides_service 'ask' of service_type Trigger\n": [
        "service-provided-twice"
    ],
    "generate_node d\n": [],
}


@pytest.mark.parametrize(("text", "expected"), LOAD_CASES.items(), ids=range(len(LOAD_CASES)))
def test_a_loaded_node_is_a_node(text: str, expected: list[str]) -> None:
    assert codes("load driver as d\n" + text, reader=FakeReader({"driver": LOADED})) == expected


OWN = source(
    endpoint(EndpointKind.SUBSCRIPTION, "a", "my_msgs/Wheel"),
    endpoint(EndpointKind.SERVICE, "s", "my_msgs/Brake"),
)
OWN_TYPES = {
    "subscribe d to 'b' of message_type my_msgs/Wheel\n": [],
    "subscribe d to 'b' of message_type my_msgs/msg/Wheel\n": [],
    "subscribe d to 'b' of message_type Wheel\n": [],
    "subscribe d to 'b' of message_type my_msgs/Brake\n": ["unknown-type"],
    "subscribe d to 'b' of message_type my_msgs/Whel\n": ["unknown-type"],
    "subscribe d to 'b b' of message_type my_msgs/Wheel\n": ["invalid-name"],
    "d provides_service 't' of service_type my_msgs/Brake\n": [],
    "d client_requests 't' of service_type my_msgs/Brake with input none\n": [],
    "d client_requests 't' of service_type my_msgs/Brake with input 1\n": ["unknown-type"],
    "create_message m of message_type my_msgs/Wheel and input none\n": ["unknown-type"],
    "create_node 'n' as n\nsubscribe n to 'b' of message_type my_msgs/Wheel\n": ["unknown-type"],
}


@pytest.mark.parametrize("text", OWN_TYPES)
def test_a_type_of_the_file_needs_no_definition(text: str) -> None:
    assert codes(f"load driver as d\n{text}", reader=FakeReader({"driver": OWN})) == OWN_TYPES[text]


def test_a_loaded_node_may_do_nothing() -> None:
    timer = source(endpoint(EndpointKind.TIMER, None))
    last = source(endpoint(EndpointKind.SUBSCRIPTION, "a", "std_msgs/String"))
    empty = source(name=None)
    text = "load driver as d\ngenerate_node d\n"
    assert codes(text, reader=FakeReader({"driver": timer})) == []
    assert codes(text, reader=FakeReader({"driver": empty})) == []
    text = "load driver as d\nunsubscribe d from 'a'\ngenerate_node d\n"
    assert codes(text, reader=FakeReader({"driver": last})) == []
    nodes = workspace("load driver as d\n", reader=FakeReader({"driver": empty})).nodes
    assert nodes["d"].name == "driver"


SENDING = f"load driver as d\n{MESSAGE}{{}}d publish m to 'out' of message_type String{{}}\n"
ALSO_SENT = {
    ("", ""): True,
    ("", " at 50 hz"): True,
    ("", " for_each 'in'"): True,
    ("", " for_each 'in' when received.data = \"stop\""): False,
    ("", " once"): False,
    ("d stop_publishing to 'out'\n", ""): False,
    ("d renames topic 'out' to 'of_file'\n", ""): False,
    ("d publish m to 'out' of message_type String once\n", " at 2 hz"): True,
    ("d publish m to 'out' of message_type String for_each 'in'\n", " at 2 hz"): True,
}


@pytest.mark.parametrize(("case", "is_told"), ALSO_SENT.items())
def test_a_second_sender_beside_that_of_a_file(case: tuple[str, str], is_told: bool) -> None:
    text = SENDING.format(*case)
    found = run(text, reader=FakeReader({"driver": LOADED})).diagnostics
    assert [each.code for each in found] == (["also-sent"] if is_told else [])
    for each in found:
        assert "line 1 of `driver.py` sends to `out`" in each.message
        assert each.fix is not None
        mended = applied(text, each.fix)
        assert "String and input \"hi\"\nd stop_publishing to 'out'\nd publish" in mended
        assert codes(mended, reader=FakeReader({"driver": LOADED})) == []


CHANGING = {
    "subscribe d to 'in' of message_type Int32\n": "unsubscribe d from 'in'",
    "d provides_service 'ask' of service_type SetBool\n": "d stop_service 'ask'",
}


@pytest.mark.parametrize(("statement", "first"), CHANGING.items())
def test_what_a_file_has_is_changed_by_a_statement_before(statement: str, first: str) -> None:
    text = "load driver as d\n" + statement
    [found] = run(text, reader=FakeReader({"driver": LOADED})).diagnostics
    assert found.fix is not None
    assert found.help == f"to change what the file has, write `{first}` before"
    assert applied(text, found.fix) == f"load driver as d\n{first}\n{statement}"
    assert codes(applied(text, found.fix), reader=FakeReader({"driver": LOADED})) == []
