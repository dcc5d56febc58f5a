"""Publishers and subscriptions of one program that never match."""

from __future__ import annotations

import pytest
from robots_run import applied
from workspaces import FakeReader, codes, endpoint, marked, run, source

from plastron_tui.diagnostics import Severity
from plastron_tui.model.graph import graph_of
from plastron_tui.model.source import EndpointKind, SourceEndpoint, SourceUnit
from plastron_tui.ros.qos import DEFAULT, PROFILES, Qos

PUBLISHER, SUBSCRIPTION = EndpointKind.PUBLISHER, EndpointKind.SUBSCRIPTION
BEST_EFFORT = Qos(reliability="best_effort")
RELIABLE = Qos(reliability="reliable")
KEPT = Qos(durability="transient_local")
LOADED = "load one as a\nload two as b\n"


def topic(
    kind: EndpointKind, qos: Qos | None, name: str = "scan", type_: str | None = None
) -> SourceEndpoint:
    return endpoint(kind, name, type_)._replace(qos=qos)


def unit(name: str, *endpoints: SourceEndpoint, library: str = "rclpy") -> SourceUnit:
    return source(*endpoints, name=name, library=library)


def reader(offered: Qos | None, requested: Qos | None, library: str = "rclpy") -> FakeReader:
    return FakeReader(
        {
            "one": unit("one", topic(PUBLISHER, offered), library=library),
            "two": unit("two", topic(SUBSCRIPTION, requested, "/scan"), library=library),
        }
    )


WEAK = Qos("best_effort", "volatile", "keep_last", 1, 2.0, 2.0, "automatic", 2.0)
PAIRS: list[tuple[Qos | None, Qos | None, str]] = [
    (BEST_EFFORT, RELIABLE, "reliability"),
    (Qos(durability="volatile"), KEPT, "durability"),
    (Qos(liveliness="automatic"), Qos(liveliness="manual_by_topic"), "liveliness"),
    (DEFAULT, Qos(deadline=1.0), "deadline"),
    (DEFAULT, Qos(lease=1.0), "lease"),
    (WEAK, PROFILES["action_status_default"], "reliability and durability"),
    (RELIABLE, BEST_EFFORT, ""),
    (DEFAULT, PROFILES["sensor_data"], ""),
    (DEFAULT, PROFILES["best_available"], ""),
    (PROFILES["system_default"], KEPT, ""),
    # What is not known is no mistake.
    (None, RELIABLE, ""),
    (BEST_EFFORT, None, ""),
    (BEST_EFFORT, KEPT, ""),
]


@pytest.mark.parametrize(("offered", "requested", "policies"), PAIRS)
def test_files_that_never_match(offered: Qos | None, requested: Qos | None, policies: str) -> None:
    found = run(LOADED, reader=reader(offered, requested)).diagnostics
    assert [each.code for each in found] == (["qos-incompatible"] if policies else [])
    for each in found:
        assert each.severity is Severity.ERROR
        assert each.message.startswith(f"{policies} of topic `/scan` ")
    # ROS 1 has none of it.
    assert codes(LOADED, reader=reader(offered, requested, "rospy")) == []


def test_both_places_are_named() -> None:
    for text in (LOADED, "load two as b\nload one as a\n"):
        (found,) = run(text, reader=reader(BEST_EFFORT, RELIABLE)).diagnostics
        assert found.message == (
            "reliability of topic `/scan` does not match: `a`, in line 1 of `driver.py`, offers "
            "`best_effort`, and `b`, in line 1 of `driver.py`, asks for `reliable`"
        )
        first, last = text.splitlines()
        assert marked(text, found) == last
        (label,) = found.labels
        assert marked(text, found._replace(span=label.span)) == first


def test_two_policies_are_one_message() -> None:
    (found,) = run(LOADED, reader=reader(WEAK, Qos("reliable", deadline=1.0))).diagnostics
    assert found.message == (
        "reliability and deadline of topic `/scan` do not match: `a`, in line 1 of `driver.py`, "
        "offers `best_effort` and `2 s`, and `b`, in line 1 of `driver.py`, asks for `reliable` "
        "and `1 s`"
    )


CREATED = (
    "create_node 'a' as a using rclpy\n"
    "create_message m of message_type std_msgs/String and input none\n"
    "a publish m to 'scan' of message_type std_msgs/String\n"
)
HEARD = "create_node 'b' as b using rclpy\nsubscribe b to 'scan' of message_type std_msgs/String\n"


def test_what_a_program_creates_has_the_default_profile() -> None:
    assert codes(f"{CREATED}load two as b\n", reader=reader(None, RELIABLE)) == []
    assert codes(f"{CREATED}load two as b\n", reader=reader(None, KEPT)) == ["qos-incompatible"]
    assert codes(f"load one as a\n{HEARD}", reader=reader(RELIABLE, None)) == []
    assert codes(f"load one as a\n{HEARD}", reader=reader(BEST_EFFORT, None)) == [
        "qos-incompatible"
    ]


def test_what_a_program_adds_to_a_file_may_be_as_what_is_beside_it() -> None:
    text = "load one as a\nload two as b\nsubscribe b to '/scan' of message_type std_msgs/String\n"
    files = FakeReader({"one": unit("one", topic(PUBLISHER, BEST_EFFORT)), "two": unit("two")})
    assert codes(text, reader=files) == []


def test_a_publisher_that_gets_a_message_keeps_what_it_has() -> None:
    text = (
        f"{LOADED}create_message m of message_type std_msgs/String and input none\n"
        "a publish m to 'scan' of message_type std_msgs/String\n"
    )
    found = codes(text, reader=reader(BEST_EFFORT, RELIABLE))
    assert found == ["also-sent", "qos-incompatible"]


MENDED = [
    "a stop_publishing to 'scan'\n",
    "b renames topic '/scan' to 'scans'\na renames topic 'scan' to 'lidar'\n",
]


@pytest.mark.parametrize("more", MENDED)
def test_what_ends_or_gets_another_name_is_not_told(more: str) -> None:
    assert codes(LOADED + more, reader=reader(BEST_EFFORT, RELIABLE)) == []


def test_a_renamed_topic_keeps_what_it_has() -> None:
    files = FakeReader(
        {
            "one": unit("one", topic(PUBLISHER, BEST_EFFORT, "lidar")),
            "two": unit("two", topic(SUBSCRIPTION, RELIABLE)),
        }
    )
    text = f"{LOADED}a renames topic 'lidar' to 'scan'\n"
    assert codes(LOADED, reader=files) == []
    assert codes(text, reader=files) == ["qos-incompatible"]


def test_a_guess_is_no_error() -> None:
    guess = topic(PUBLISHER, BEST_EFFORT)._replace(is_guess=True)
    files = FakeReader(
        {"one": unit("one", guess), "two": unit("two", topic(SUBSCRIPTION, RELIABLE))}
    )
    assert codes(LOADED, reader=files) == []


def test_call_sites_of_one_topic_that_differ_leave_it_open() -> None:
    both = topic(PUBLISHER, BEST_EFFORT), topic(PUBLISHER, RELIABLE)
    for several in (both, both[::-1], (both[0], topic(PUBLISHER, None))):
        files = FakeReader(
            {"one": unit("one", *several), "two": unit("two", topic(SUBSCRIPTION, RELIABLE))}
        )
        assert codes(LOADED, reader=files) == []


def test_two_types_are_told_alone() -> None:
    files = FakeReader(
        {
            "one": unit("one", topic(PUBLISHER, BEST_EFFORT, "scan", "std_msgs/String")),
            "two": unit("two", topic(SUBSCRIPTION, RELIABLE, "scan", "std_msgs/Int32")),
        }
    )
    assert codes(LOADED, reader=files) == ["topic-type-conflict"]


def test_each_pair_is_told_once() -> None:
    files = FakeReader(
        {
            "one": unit("one", topic(PUBLISHER, BEST_EFFORT)),
            "two": unit("two", topic(SUBSCRIPTION, RELIABLE)),
            "three": unit("three", topic(SUBSCRIPTION, RELIABLE)),
        }
    )
    text = "load one as a\nload two as b\nload three as c\nload one as d\n"
    assert codes(text, reader=files) == ["qos-incompatible"] * 4


def test_panels_and_graph_get_what_is_known() -> None:
    workspace = run(LOADED, reader=reader(BEST_EFFORT, None)).workspace
    (hub,) = graph_of(workspace).topics
    assert [end.qos for end in hub.ends] == [BEST_EFFORT, None]


SENT = "a publish m to 'scan' of message_type std_msgs/String{}\n"
PAIR = CREATED.rpartition("a publish")[0] + SENT + HEARD.replace("String", "String{} calling f")
REMEDIES = [
    (" with qos sensor_data", "", "with qos sensor_data"),
    (" with qos best_effort, depth 2", "", "with qos best_effort, depth 2"),
    (" at 2 hz with qos best_effort", " with qos reliable, depth 3", "best_effort, depth 3"),
    (" with qos depth 2", " with qos latched", "transient_local, depth 2"),
    ("", " with qos deadline 0.5", "with qos deadline 0.5"),
    (" with qos deadline 2", " with qos deadline 1, reliable", "reliable, deadline 2"),
]


@pytest.mark.parametrize(("sent", "heard", "words"), REMEDIES)
def test_the_remedy_is_in_words_and_lets_them_meet(sent: str, heard: str, words: str) -> None:
    text = PAIR.format(sent, heard)
    (found,) = run(text).diagnostics
    assert found.fix is not None and found.help is not None
    assert (found.code, found.fix.title) == ("qos-incompatible", f"write `{words}`")
    assert words in found.help
    assert codes(applied(text, found.fix)) == []


def test_files_have_no_fix_and_a_statement_meets_a_file() -> None:
    (found,) = run(LOADED, reader=reader(BEST_EFFORT, RELIABLE)).diagnostics
    assert found.fix is None
    text = f"load one as a\n{HEARD}"
    (found,) = run(text, reader=reader(BEST_EFFORT, None)).diagnostics
    assert found.fix is not None
    assert found.help == "no message arrives: let `b` ask for less, `with qos best_effort`"
    assert codes(applied(text, found.fix), reader=reader(BEST_EFFORT, None)) == []
    text = f"{CREATED}load two as b\n"
    (found,) = run(text, reader=reader(None, KEPT)).diagnostics
    assert found.fix is not None
    assert found.help == "no message arrives: let `a` offer more, `with qos transient_local`"
    assert codes(applied(text, found.fix), reader=reader(None, KEPT)) == []
