from __future__ import annotations

import json

import pytest

from plastron_tui.runtime.table import Screen, Watch


def topics(*rows: tuple[str, str, float, str]) -> str:
    listed = [
        {"name": name, "type": type_, "rate": rate, "count": 1, "text": text}
        for name, type_, rate, text in rows
    ]
    return json.dumps({"topics": listed})


def call(kind: str, service: str, request: str, response: str, *, failed: bool = False) -> str:
    return json.dumps(
        {
            "kind": kind,
            "service": service,
            "request": request,
            "response": response,
            "is_failure": failed,
        }
    )


@pytest.fixture
def watch() -> Watch:
    watch = Watch()
    watch.feed_topics(
        topics(
            ("/chatter", "std_msgs/String", 10.02, 'data: "hi"'),
            ("/pose", "geometry_msgs/Pose2D", 0.0, ""),
        )
    )
    return watch


def test_topics_and_services_are_aligned(watch: Watch) -> None:
    watch.feed_call(call("served", "/add", "a: 1, b: 2", "sum: 3"))
    assert watch.table(80, 20) == [
        "topic     type                  rate     last message",
        '/chatter  std_msgs/String       10.0 Hz  data: "hi"',
        "/pose     geometry_msgs/Pose2D  0.0 Hz",
        "service  calls  failed  last call",
        "/add     1      0       (a: 1, b: 2) → (sum: 3)",
    ]
    assert watch.lines()[0] == '/chatter std_msgs/String 10.0 Hz data: "hi"'


def test_a_call_seen_at_both_ends_is_one_call() -> None:
    watch = Watch()
    ends = [("served", "/add"), ("called", "/add"), ("called", "/far")]
    told = [watch.feed_call(call(kind, name, "a: 1", "b: 2")) for kind, name in ends]
    assert told == ["/add (a: 1) → (b: 2)", None, "/far (a: 1) → (b: 2)"]
    assert [row.calls for row in watch.services.values()] == [1, 1]


def test_failed_calls_are_counted() -> None:
    watch = Watch()
    watch.feed_call(call("served", "/add", "", "no", failed=True))
    watch.feed_call(call("called", "/add", "", "no", failed=True))
    watch.feed_call(call("served", "/add", "", "yes"))
    assert (watch.services["/add"].calls, watch.services["/add"].failed) == (2, 1)


@pytest.mark.parametrize("line", ["", "warning: no", "[1]", '"topics"', "{}"])
def test_what_is_no_report_is_passed_over(line: str) -> None:
    watch = Watch()
    assert not watch.feed_topics(line)
    assert watch.feed_call(line) is None


def test_the_table_fits_the_terminal(watch: Watch) -> None:
    watch.feed_topics(topics(("/wide", "a/B", 1.0, "文" * 100), ("/long", "a/B", 1.0, "x" * 100)))
    lines = watch.table(60, 4)
    assert lines[-1] == "… 2 more lines"
    assert all(len(line) <= 60 for line in watch.table(60, 20))
    assert watch.table(60, 20)[3].endswith("文…")


def test_a_message_cannot_move_the_cursor() -> None:
    watch = Watch()
    watch.feed_topics(topics(("/a", "a/B", 1.0, "\x1b[2J\r\n\u202e")))
    assert watch.table(80, 20)[1].endswith("\\x1b[2J\\r\\n\\u202e")
    assert "\x1b" not in watch.lines()[0]


def test_the_table_is_drawn_over_itself(watch: Watch) -> None:
    screen = Screen(watch, lambda: (80, 24))
    first = screen.frame()
    assert first.count("\n") == 3
    assert screen.frame() == ""
    assert screen.frame(is_forced=True) == f"\x1b[3A\r\x1b[J{first}"
    assert screen.erase() == "\x1b[3A\r\x1b[J"
    assert screen.erase() == ""
