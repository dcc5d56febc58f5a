"""What `renames` makes of a node, and what is wrong with it."""

from __future__ import annotations

import re

import pytest
from workspaces import MESSAGE, NODE, FakeReader, codes, endpoint, marked, run, source, workspace

from plastron_tui.model.kinds import EndpointKind, Publisher, Subscription
from plastron_tui.model.workspace import Node

LISTEN = "subscribe n to 'a' of message_type String calling f\n"
LOADED = source(
    endpoint(EndpointKind.SUBSCRIPTION, "scan", "sensor_msgs/LaserScan", "on_scan"),
    endpoint(EndpointKind.PUBLISHER, "scan", "sensor_msgs/LaserScan"),
    endpoint(EndpointKind.PUBLISHER, "odd", None),
    endpoint(EndpointKind.ACTION_SERVER, "dock", "our_msgs/Dock"),
    endpoint(EndpointKind.PARAMETER, "~/rate"),
    endpoint(EndpointKind.TIMER, None),
)
READER = FakeReader({"driver": LOADED})


def test_all_but_the_name_stays() -> None:
    made = NODE + MESSAGE + LISTEN + "n publish m to 'b' of message_type String at 3 hz\n"
    before = workspace(made).nodes["n"]
    after = workspace(f"{made}n renames topic 'a' to 'c'\nn renames topic 'b' to 'd'\n").nodes["n"]
    assert after.of(Subscription) == {"c": before.of(Subscription)["a"]._replace(name="c")}
    assert after.of(Publisher)["d"].publications[0].rate == 3


def test_it_keeps_its_place_among_its_like() -> None:
    others = LISTEN.replace("'a'", "'b'") + LISTEN.replace("'a'", "'c'")
    node = workspace(f"{NODE}{LISTEN}{others}n renames topic 'b' to 'x'\n").nodes["n"]
    assert list(node.of(Subscription)) == ["a", "x", "c"]


CASES: dict[str, list[str]] = {
    "n renames topic 'a' to 'b'\nunsubscribe n from 'b'\n": [],
    "n renames topic 'a' to 'b'\nunsubscribe n from 'a'\n": ["not-subscribed"],
    "n renames topic 'a' to 'b'\nn renames topic 'b' to 'a'\nunsubscribe n from 'a'\n": [],
    f"n renames topic 'a' to 'b'\n{LISTEN}n renames topic 'a' to 'c'\n": [],
    "n renames topic 'a' to 'a'\n": ["name-taken"],
    "n renames topic 'b' to 'a'\n": ["nothing-to-rename"],
    "n renames service 'a' to 'b'\n": ["nothing-to-rename"],
    "n renames topik 'a' to 'b'\n": ["unknown-name-kind"],
    "n renames topic 'a' to 'b c'\n": ["invalid-name"],
    "m renames topic 'a' to 'b'\n": ["unknown-node"],
    "subscribe n to 'b' of message_type String\nn renames topic 'a' to 'b'\n": ["name-taken"],
    # One mistake, one message.
    "n renames topik 'a' to 'b'\nunsubscribe n from 'b'\nunsubscribe n from 'a'\n": [
        "unknown-name-kind"
    ],
    "n renames topic 'a' to 'b c'\nunsubscribe n from 'b c'\n": ["invalid-name"],
    # The new name may be of another type to others, and the old one is free.
    "create_node 'x' as x\nsubscribe x to 'b' of message_type Int32\n"
    "n renames topic 'a' to 'b'\n": ["topic-type-conflict"],
    "n renames topic 'a' to 'b'\nsubscribe n to 'a' of message_type Int32\n": [],
    "n renames topic 'a' to 'b'\n"
    "subscribe n to 'b' of message_type Int32\n": ["already-subscribed"],
}  # fmt: skip


@pytest.mark.parametrize(("text", "expected"), CASES.items(), ids=range(len(CASES)))
def test_what_is_wrong(text: str, expected: list[str]) -> None:
    assert codes(NODE + LISTEN + text) == expected


def test_a_conflict_changes_nothing() -> None:
    other = "create_node 'x' as x\nsubscribe x to 'b' of message_type Int32\n"
    text = f"{NODE}{LISTEN}{other}n renames topic 'a' to 'b'\n"
    found = run(text)
    assert marked(text, found.diagnostics[0]) == "'b'"
    assert list(found.workspace.nodes["n"].of(Subscription)) == ["a"]
    again = f"{text}subscribe x to 'a' of message_type Int32\n"
    assert [each.code for each in run(again).diagnostics][1:] == ["topic-type-conflict"]


LOAD_CASES: dict[str, tuple[list[str], set[str]]] = {
    "d renames topic 'scan' to 'front'\n": ([], {"front", "odd", "dock", "~/rate"}),
    "d renames topic 'odd' to 'even'\n": ([], {"scan", "even", "dock", "~/rate"}),
    "d renames action 'dock' to 'park'\n": ([], {"scan", "odd", "park", "~/rate"}),
    "d renames parameter '~rate' to '~speed'\n": ([], {"scan", "odd", "dock", "~/speed"}),
    "d renames parameter 'rate' to 'speed'\n": ([], {"scan", "odd", "dock", "~/speed"}),
    "d renames parameter 'rat' to 'speed'\n": (
        ["nothing-to-rename"], {"scan", "odd", "dock", "~/rate"}
    ),
    "d renames action 'dock' to 'x'\nd renames action 'x' to 'y'\n": (
        [], {"scan", "odd", "y", "~/rate"}
    ),
}  # fmt: skip


@pytest.mark.parametrize("text", LOAD_CASES)
def test_of_a_loaded_node(text: str) -> None:
    expected, names = LOAD_CASES[text]
    found = run(f"load driver as d\n{text}", reader=READER)
    assert [each.code for each in found.diagnostics] == expected
    node = found.workspace.nodes["d"]
    assert {name for kind in EndpointKind for name in node.names(kind)} == names


def test_suggestions_are_as_programs_write_names() -> None:
    for line, expected in (
        ("d renames parameter '~/rat' to 'x'", "did you mean `rate`?"),
        ("d renames topic '~/sca' to 'x'", "did you mean `~/scan`?"),
        ("d no_longer_has_parameter 'rat'", "did you mean `rate`?"),
        ("unsubscribe d from '~/sca'", "did you mean `~/scan`?"),
    ):
        there = source(
            endpoint(EndpointKind.SUBSCRIPTION, "~/scan", "sensor_msgs/LaserScan"),
            endpoint(EndpointKind.PARAMETER, "~/rate"),
        )
        (found,) = run(
            f"load driver as d\n{line}\n", reader=FakeReader({"driver": there})
        ).diagnostics
        assert found.help == expected


def test_a_private_name_has_one_spelling() -> None:
    text = (
        "create_node 'n' as n using rospy\nsubscribe n to '~a' of message_type String\n"
        "n renames topic '~/a' to '~/b'\nunsubscribe n from '~b'\n"
    )
    found = run(text)
    assert [each.code for each in found.diagnostics] == ["private-name"]
    assert found.workspace.nodes["n"].is_idle


@pytest.mark.parametrize(
    ("name", "version", "is_right"),
    [
        ("~rate", "rospy", True),
        ("rate", "rospy", True),
        ("a.b", "rospy", False),
        ("a.b", "rclpy", True),
        ("a..b", "rclpy", False),
        ("~rate", "rclpy", False),
        ("", "rclpy", False),
    ],
)
def test_the_name_of_a_parameter(name: str, version: str, is_right: bool) -> None:
    there = source(endpoint(EndpointKind.PARAMETER, "x"), library=version)
    text = f"load driver as d\nd renames parameter 'x' to '{name}'\n"
    found = codes(text, version, FakeReader({"driver": there}))
    assert found == ([] if is_right else ["invalid-name"])


USING = """\
create_node 'robot' as n using {library}
n has_parameter 'speed' of parameter_type float with default 2
subscribe n to 'scan' of message_type Point calling hear
create_message m of message_type Point and input x=parameter 'speed' * 2
n publish m to 'a' of message_type Point at parameter 'speed' hz
n publish m to 'b' of message_type Point for_each 'scan' when received.x < 1
n client_requests 'c' of service_type SetBool with input True at parameter 'speed' hz
n provides_service 's' of service_type AddTwoInts answering sum=received.a
n repeats look at parameter 'speed' hz
"""
RENAMES = "n renames parameter 'speed' to 'haste'\nn renames topic 'scan' to 'points'\n"


@pytest.mark.parametrize("library", ["rospy", "rclpy"])
def test_what_uses_it_uses_it_by_its_new_name(library: str) -> None:
    made = USING.replace("{library}", library)
    renamed = workspace(made + RENAMES).nodes["n"]
    named = workspace(made.replace("'speed'", "'haste'").replace("'scan'", "'points'")).nodes["n"]
    assert _without_spans(renamed) == _without_spans(named)
    used = made + RENAMES + "n no_longer_has_parameter 'haste'\n"
    assert codes(used) == codes(made + "n no_longer_has_parameter 'speed'\n") != []


def _without_spans(node: Node) -> str:
    return re.sub(r"Span\(start=\d+, end=\d+\)", "Span", repr(node.endpoints))
