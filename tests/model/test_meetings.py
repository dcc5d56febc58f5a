"""Names that are one slip apart, and files that do not agree on a type."""

from __future__ import annotations

import pytest
from workspaces import FakeReader, codes, endpoint, marked, run, source

from plastron_tui.diagnostics import Severity
from plastron_tui.model.graph import graph_of
from plastron_tui.model.source import EndpointKind

TALKER = (
    "create_node 'a' as a\ncreate_node 'b' as b\n"
    "create_message m of message_type std_msgs/String and input none\n"
    "a publish m to '{}' of message_type std_msgs/String\n"
)

NAMES = {
    ("chatter", "chater"): True,
    ("chatter", "chattter"): True,
    ("chatter", "chatler"): True,
    ("chatter", "chattre"): True,
    ("chatter", "/Chatter"): True,
    ("arm/state", "arm_state"): True,
    ("chatter", "chatter"): False,
    ("chatter", "chatting"): False,
    ("motor1", "motor2"): False,
    ("motor", "motor1"): False,
    ("arm_left", "arm_right"): False,
    ("front/scan", "rear/scan"): False,
    ("l_wheel", "r_wheel"): False,
    ("fl_wheel", "fr_wheel"): False,
    ("posx", "posy"): False,
    ("ping", "pong"): False,
}


@pytest.mark.parametrize(("names", "is_slip"), NAMES.items())
def test_a_name_that_one_side_alone_uses(names: tuple[str, str], is_slip: bool) -> None:
    for sent, heard in (names, names[::-1]):
        text = TALKER.format(sent) + f"subscribe b to '{heard}' of message_type std_msgs/String\n"
        found = run(text).diagnostics
        assert [each.code for each in found] == (["misspelt-name"] if is_slip else [])
        for each in found:
            assert marked(text, each) == f"'{heard}'"
            assert each.fix is not None
            assert codes(text.replace(f"'{heard}'", each.fix.edits[0].text)) == []


def test_a_service_that_nobody_provides() -> None:
    text = (
        "create_node 'a' as a\ncreate_node 'b' as b\n"
        "a provides_service 'reset' of service_type std_srvs/Empty\n"
        "b client_requests 'rest' of service_type std_srvs/Empty with input none\n"
    )
    assert codes(text) == ["misspelt-name"]


STRING = "of message_type std_msgs/String\n"
MEANT = [
    f"subscribe b to 'chater' {STRING}subscribe b to 'chatter' {STRING}",
    f"subscribe a to 'chater' {STRING}",
    "subscribe b to 'chater' of message_type std_msgs/Int32\n",
    f"subscribe b to 'chater' {STRING}b publish m to 'chater' {STRING}",
]


@pytest.mark.parametrize("rest", MEANT)
def test_a_name_that_is_meant(rest: str) -> None:
    assert codes(TALKER.format("chatter") + rest) == []


def test_the_other_ros_has_names_of_its_own() -> None:
    text = TALKER.format("chatter").replace("'b' as b", "'b' as b using rclpy")
    assert codes(f"{text}subscribe b to 'chater' {STRING}") == []


def test_every_statement_that_has_the_name_is_mended() -> None:
    text = (
        f"{TALKER.format('chatter')}subscribe b to 'chater' {STRING}"
        f"unsubscribe b from 'chater'\nsubscribe b to 'chater' {STRING}"
    )
    (found,) = run(text).diagnostics
    assert found.fix is not None
    assert len(found.fix.edits) == 3


def test_all_nodes_that_have_the_name_are_mended() -> None:
    text = (
        f"{TALKER.format('chatter')}create_node 'c' as c\n"
        f"subscribe b to 'chater' {STRING}subscribe c to '/chater' {STRING}"
    )
    (found,) = run(text).diagnostics
    assert found.fix is not None
    assert [marked(text, found._replace(span=each.span)) for each in found.fix.edits] == [
        "'chater'",
        "'/chater'",
    ]


READER = FakeReader(
    {
        "one": source(endpoint(EndpointKind.PUBLISHER, "scan", "std_msgs/String"), name="one"),
        "two": source(endpoint(EndpointKind.SUBSCRIPTION, "/scan", "std_msgs/Int32"), name="two"),
        "odd": source(endpoint(EndpointKind.SUBSCRIPTION, "scann", "std_msgs/String"), name="odd"),
    }
)


def test_files_that_do_not_agree() -> None:
    (found,) = run("load one as a\nload two as b\n", reader=READER).diagnostics
    assert (found.code, found.severity) == ("topic-type-conflict", Severity.WARNING)
    assert found.message == (
        "topic `/scan` is of type `std_msgs/String` in line 1 of `driver.py`, "
        "and `std_msgs/Int32` in line 1 of `driver.py`"
    )


MENDED = {
    "unsubscribe b from '/scan'\n": [],
    "b renames topic '/scan' to 'map'\n": [],
    "": ["topic-type-conflict"],
}


@pytest.mark.parametrize("rest", MENDED)
def test_files_that_the_program_brings_to_agree(rest: str) -> None:
    assert codes(f"load one as a\nload two as b\n{rest}", reader=READER) == MENDED[rest]


def test_a_slip_in_a_file_is_told_with_its_line() -> None:
    (found,) = run("load one as a\nload odd as b\n", reader=READER).diagnostics
    assert found.code == "misspelt-name"
    assert "`b` subscribes to `scann` in line 1 of `driver.py`" in found.message


RENAMED = {
    "load one as a\nload odd as b\n": "load one as a\nload odd as b\n"
    "b renames topic 'scann' to 'scan'\n",
    "load odd as b\nload one as a\ngenerate_node a": "load odd as b\nload one as a\n"
    "a renames topic 'scan' to 'scann'\ngenerate_node a",
    "load one as a\nload odd as b\nload odd as c": "load one as a\nload odd as b\n"
    "b renames topic 'scann' to 'scan'\nload odd as c\nc renames topic 'scann' to 'scan'",
}


@pytest.mark.parametrize("text", RENAMED)
def test_a_name_of_a_file_is_mended_by_a_line_behind_its_load(text: str) -> None:
    (found,) = run(text, reader=READER).diagnostics
    assert found.fix is not None
    mended = text
    for edit in sorted(found.fix.edits, reverse=True):
        mended = mended[: edit.span.start] + edit.text + mended[edit.span.end :]
    assert mended == RENAMED[text]
    assert codes(mended, reader=READER) == []


def test_a_guess_is_shown_and_no_ground_for_a_warning() -> None:
    there = endpoint(EndpointKind.SUBSCRIPTION, "scan", "std_msgs/Int32")._replace(is_guess=True)
    files = {**READER.files, "two": source(there, name="two")}
    found = run("load one as a\nload two as b\n", reader=FakeReader(files))
    assert found.diagnostics == ()
    (hub,) = graph_of(found.workspace).topics
    assert [end.is_guess for end in hub.ends] == [False, True]
    renamed = "load two as b\nb renames topic 'scan' to 'map'\n"
    (hub,) = graph_of(run(renamed, reader=FakeReader(files)).workspace).topics
    assert not any(end.is_guess for end in hub.ends)
