"""The live panel as data: rows, columns, curves."""

from __future__ import annotations

from typing import Any

import pytest
from rich.cells import cell_len

from plastron_tui.runtime.live_graph import LiveGraph, NodeEnd
from plastron_tui.runtime.live_parts import LiveParameter
from plastron_tui.session import Session
from plastron_tui.studio.panels.live_columns import columns_of, line_of
from plastron_tui.studio.panels.live_row import Answer, Kind, LiveRow
from plastron_tui.studio.panels.live_row_places import cancelable_at
from plastron_tui.studio.panels.live_rows import (
    FOREIGN,
    NOBODY,
    WAITING,
    found_rows,
    live_rows,
)
from plastron_tui.studio.panels.live_watching import Watching, watching_of
from plastron_tui.studio.panels.sparkline import sparkline
from plastron_tui.studio.wizard.live_orders import form_for


@pytest.mark.parametrize(
    ("samples", "cells", "curve"),
    [([], 5, ""), ([1.0], 5, ""), ([2, 2, 2], 5, ""), ([0, 1], 5, "▁█"), ([0, 1, 2], 2, "▁█"),
     (range(8), 8, "▁▂▃▄▅▆▇█"), ([-1.7e308, 1.7e308], 4, "▁█"), ([1, 2], 0, "")],
)  # fmt: skip
def test_a_curve_is_between_the_least_and_the_greatest(
    samples: Any, cells: int, curve: str
) -> None:
    assert sparkline(samples, cells) == curve


@pytest.fixture
def graph() -> LiveGraph:
    graph = LiveGraph(2)
    graph.feed({
        "tell": "graph",
        "topics": [["/a\x1b[2J", "std_msgs/String", 1, 0], ["/speed", "std_msgs/Float64", 1, 1],
                   ["/cmd_vel", "geometry_msgs/Twist", 0, 1]],
        "services": [["/add", "example_interfaces/AddTwoInts"]],
        "actions": [["/count", "example_interfaces/Fibonacci", 1, ["/talker"]]],
        "nodes": ["/talker"],
    })  # fmt: skip
    for count, number in enumerate((0.25, 0.5), 1):
        fields = [["data", f"{number}", number]]
        row = {"count": count, "rate": 2.0, "text": f"{number}", "number": number, "fields": fields}
        graph.feed({"tell": "topics", "rows": {"/speed": row}})
    return graph


def drawn(
    graph: LiveGraph, width: int, unfolded: set[str], answer: Answer | None = None
) -> list[str]:
    rows = live_rows([graph], unfolded, {} if answer is None else {"2 service /add": answer})
    columns = columns_of(rows, width)
    lines = ["".join(piece.text for piece in line_of(row, columns, width)) for row in rows]
    for line in lines:
        assert cell_len(line) <= width, line
    return [line.rstrip() for line in lines]


def test_the_rows_say_what_runs(graph: LiveGraph) -> None:
    unfolded = {"2 topic /speed", "2 node /talker"}
    assert drawn(graph, 90, unfolded, answer=Answer("sum: 3")) == [
        " topics",
        f" ▸ ≈ /a\\x1b[2J           {WAITING}",
        f" ▸ ≈ /cmd_vel            {NOBODY}",
        f" ▾ ≈ /speed       2.0 Hz 0.5{'▁█':>61}",
        "       std_msgs/Float64, 1 publisher, 1 subscriber",
        f"       data              0.5{'▁█':>61}",
        " services",
        "   ◆ /add                example_interfaces/AddTwoInts",
        "       → sum: 3",
        " actions",
        "   ★ /count              example_interfaces/Fibonacci",
        " nodes",
        " ▾ ● /talker",
        "       asking for its parameters…",
        "       action /count",
    ]


def test_who_is_at_a_topic_and_what_a_node_does_are_named(graph: LiveGraph) -> None:
    at = [[True, "/talker", "reliable"], [False, "/ear", "best effort, transient local"]]
    many = [[False, f"/n{number}", ""] for number in range(10)]
    graph.feed({
        "tell": "graph", "nodes": ["/talker"],
        "topics": [["/speed", "std_msgs/Float64", 1, 1, ["/ear", "/talker"], at],
                   ["/scan", "p/T", 0, 10, ["/talker"], [*many, [False, "/talker", ""]]]],
        "services": [["/add", "p/S", ["/talker"]], ["/sub", "p/S", ["/other"]]],
        "actions": [["/count", "p/A", 1, ["/talker"]]],
    })  # fmt: skip
    lines = drawn(graph, 90, {"2 topic /speed", "2 topic /scan", "2 node /talker"})
    about = lines.index("       std_msgs/Float64, 1 publisher, 1 subscriber")
    assert lines[about + 1 : about + 3] == [
        "       from /talker  reliable", "       to /ear  best effort, transient local"
    ]  # fmt: skip
    assert "       to /n7" in lines and "       and 3 more" in lines
    assert lines[lines.index(" ▾ ● /talker") + 1 :] == [
        "       asking for its parameters…",
        "       sends /speed", "       hears /scan", "       offers /add", "       action /count",
    ]  # fmt: skip


def test_nothing_is_wider_than_the_panel_and_each_name_is_seen(graph: LiveGraph) -> None:
    for width in range(30, 140, 7):
        lines = drawn(graph, width, {"2 topic /speed"}, answer=Answer("no", is_failure=True))
        for name in ("/cmd_vel", "/speed", "/add", "/talker"):
            assert any(name in line for line in lines), (width, name)
        assert any("2.0 Hz" in line and "0.5" in line for line in lines)


def test_what_is_gone_or_silent_is_marked(graph: LiveGraph) -> None:
    row = {"count": 2, "rate": 0.0, "text": "0.5", "number": 0.5}
    graph.feed({"tell": "topics", "rows": {"/speed": row}})
    assert any("/speed       silent 0.5" in line for line in drawn(graph, 60, set()))
    graph.feed({"tell": "graph", "topics": [], "services": [], "nodes": []})
    lines = drawn(graph, 60, set())
    assert sum("gone" in line for line in lines) == 6


@pytest.mark.parametrize(
    ("there", "end", "stopped", "value", "tone"),
    [(True, None, False, "", "quiet"), (False, None, False, "gone", "warning"),
     # The middleware believes for some seconds in a node that was killed.
     (True, NodeEnd("was ended by SIGKILL", True), False, "was ended by SIGKILL", "error"),
     (False, NodeEnd("finished", False), False, "finished", "quiet"),
     (False, NodeEnd("finished", False, "sum=5\x1b"), False, "finished: sum=5\\x1b", "quiet"),
     (False, None, True, "ended", "quiet"), (True, None, True, "ended", "quiet")],
)  # fmt: skip
def test_a_node_that_has_done_its_work_is_not_one_that_is_gone(
    graph: LiveGraph, there: bool, end: NodeEnd | None, stopped: bool, value: str, tone: str
) -> None:
    if end is not None:
        assert graph.mark_ended(["/talker"], end) and not graph.mark_ended(["/talker"], end)
    if not there:
        graph.feed({"tell": "graph", "topics": [], "services": [], "nodes": []})
    if stopped:
        graph.end()
    row = live_rows([graph], set(), {})[-1]
    assert (row.name, row.value, row.tone) == ("/talker", value, tone)
    assert row.is_branch == (there and end is None and not stopped)
    if end is not None and not there:
        # Somebody has started it by hand.
        graph.feed({"tell": "graph", "topics": [], "services": [], "nodes": ["/talker"]})
        assert live_rows([graph], set(), {})[-1].value == ""


@pytest.mark.parametrize(
    ("version", "seen", "shown"),
    [(2, [], ["/asker"]), (2, ["/asker"], ["/asker"]), (2, ["/other"], ["/asker", "/other"]),
     (1, ["/asker_12_345"], ["/asker_12_345"])],
)  # fmt: skip
def test_a_node_that_was_too_quick_to_be_seen_has_its_row(
    version: int, seen: list[str], shown: list[str]
) -> None:
    graph = LiveGraph(version)
    report = {"tell": "graph", "topics": [], "services": [], "nodes": seen}
    graph.feed(report)
    graph.mark_ended(["/asker"], NodeEnd("finished", False, "sum=5"))
    graph.feed({**report, "nodes": []})
    rows = [each for each in live_rows([graph], set(), {}) if each.kind is Kind.NODE]
    assert [each.name for each in rows] == shown


@pytest.mark.parametrize(
    ("own", "version", "topics", "nodes"),
    [((), 2, ["/a", "/b", "/c"], ["/x", "/y"]),
     (("/y",), 2, ["/b", "/c", "-/a"], ["/y", "-/x"]),
     (("/x",), 2, ["/a", "/c", "-/b"], ["/x", "-/y"]),
     # Of a topic nobody said whose it is, and a node of ROS 1 has a number behind its name.
     (("/n",), 1, ["/a", "/b", "/c"], ["/n_12_345"])],
)  # fmt: skip
def test_what_the_program_does_not_have_comes_behind_and_is_marked(
    own: tuple[str, ...], version: int, topics: list[str], nodes: list[str]
) -> None:
    graph = LiveGraph(version, own=frozenset(own) or None, domain="7")
    there = ["/x", "/y"] if version == 2 else ["/n_12_345"]
    at = [[node] for node in there] if version == 2 else [there, there]
    graph.feed({"tell": "graph", "topics": [["/a", "p/T", 1, 0, at[0]], ["/b", "p/T", 1, 0, at[1]],
                                            ["/c", "p/T", 1, 0]],
                "services": [["/a", "p/S", at[0]], ["/b", "p/S", at[1]], ["/c", "p/S"]],
                "actions": [["/a", "p/A", 1, at[0]], ["/b", "p/A", 1, at[1]], ["/c", "p/A", 1, []]],
                "nodes": there})  # fmt: skip
    rows = live_rows([graph], set(), {})
    for kind, wanted in ((Kind.TOPIC, topics), (Kind.SERVICE, topics), (Kind.ACTION, topics),
                         (Kind.NODE, nodes)):  # fmt: skip
        shown = [f"{'-' * row.is_foreign}{row.name}" for row in rows if row.kind is kind]
        assert shown == wanted
    foreign = [row.value for row in rows if row.kind is not Kind.TOPIC and row.is_foreign]
    assert all(value.endswith(FOREIGN) for value in foreign)
    assert [row.name for row in rows if row.kind is Kind.HEADING] == [
        "topics, domain 7", "services", "actions", "nodes"
    ]  # fmt: skip


@pytest.mark.parametrize(
    ("state", "is_over", "is_failure", "shown", "tone"),
    [("accepted", False, False, "▶ order: 5 → accepted, n: 1", "success"),
     ("succeeded", True, False, "✓ order: 5 → succeeded, n: 1", ""),
     ("canceled", True, False, "– order: 5 → canceled, n: 1", ""),
     ("aborted", True, True, "✗ order: 5 → aborted, n: 1", "error")],
)  # fmt: skip
def test_a_goal_stands_below_its_action(
    graph: LiveGraph, state: str, is_over: bool, is_failure: bool, shown: str, tone: str
) -> None:
    goal = {"tell": "goal", "id": 3, "name": "/count", "sent": "order: 5", "state": state,
            "text": "n: 1", "is_over": is_over, "is_failure": is_failure}  # fmt: skip
    graph.feed(goal)
    assert f"       {shown}" in drawn(graph, 80, set())
    rows = live_rows([graph], set(), {})
    at = next(at for at, row in enumerate(rows) if row.kind is Kind.GOAL)
    assert rows[at].tone == tone and rows[at - 1].kind is Kind.ACTION
    # It can be canceled there, or at its action, as long as it is worked on.
    found = [cancelable_at(rows, place) for place in (at, at - 1)]
    assert [each and each.goal for each in found] == ([None, None] if is_over else [3, 3])
    # Of many goals that are over the last ones are seen.
    for number in range(4, 20):
        graph.feed({**goal, "id": number, "is_over": True})
    goals = [row for row in live_rows([graph], set(), {}) if row.kind is Kind.GOAL]
    assert len(goals) == (5 if is_over else 6) and goals[-1].key.endswith(" 19")


def test_what_is_sent_at_a_rate_is_ended_at_its_topic(graph: LiveGraph) -> None:
    graph.feed({"tell": "sending", "name": "/speed", "rate": 12.5, "text": "1.5"})
    assert "       ▶ sending at 12.5 hz: 1.5" in drawn(graph, 80, set())
    rows = live_rows([graph], {"2 topic /speed"}, {})
    found = {row.kind for at, row in enumerate(rows) if cancelable_at(rows, at) is not None}
    assert found == {Kind.TOPIC, Kind.SENDING, Kind.FIELD, Kind.NOTE}
    owners = {each.owner for at in range(len(rows)) if (each := cancelable_at(rows, at))}
    assert owners == {"/speed"}
    # What fails is told in the place of it, and there is nothing to end.
    failed = {"tell": "sending", "name": "/speed", "rate": 0, "text": "", "problem": "no\nway"}
    graph.feed(failed)
    assert "       ⚠ not sent any more: no\\nway" in drawn(graph, 80, set())
    assert not any(row.is_sent_to for row in live_rows([graph], set(), {}))


@pytest.mark.parametrize(
    ("words", "names", "count"),
    [((), ["problem", "topics", "/a\\x1b[2J", "/cmd_vel", "/speed", "type", "data", "services",
           "/add", "actions", "/count", "nodes", "/talker"], 6),
     (("float64",), ["problem", "topics", "/speed", "type", "data"], 1),
     (("add",), ["problem", "services", "/add"], 1),
     (("nowhere",), ["problem"], 0)],
)  # fmt: skip
def test_words_find_what_has_them_in_its_name_or_type(
    graph: LiveGraph, words: tuple[str, ...], names: list[str], count: int
) -> None:
    graph.problem = "problem"
    rows, found = found_rows(live_rows([graph], {"2 topic /speed"}, {}), words)
    shown = ["type" if row.kind is Kind.NOTE and row.depth else row.name for row in rows]
    assert (shown, found) == (names, count)


def test_a_long_name_is_cut_before_the_part_that_tells() -> None:
    name = "/very/long/namespace/of/the/robot/wheel_ticks"
    rows = [LiveRow("k", Kind.TOPIC, name, name)]
    for width in (50, 80):
        line = "".join(piece.text for piece in line_of(rows[0], columns_of(rows, width), width))
        assert "wheel_ticks " in line and "…" in line and cell_len(line) <= width


def test_what_nobody_watches_is_what_was_seen_last(graph: LiveGraph) -> None:
    graph.is_watched, graph.problem = False, "not watched"
    rows = live_rows([graph], set(), {})
    assert (rows[0].name, rows[0].tone) == ("not watched", "error")
    speed = next(row for row in rows if row.name == "/speed")
    assert (speed.rate, speed.value, speed.tone) == ("2.0 Hz", "0.5", "quiet")
    columns = columns_of(rows, 90)
    tones = {piece.tone for row in rows[1:] for piece in line_of(row, columns, 90)}
    assert "primary" not in tones


def test_what_the_network_says_is_only_shown() -> None:
    wild = "/x\x1b]0;y\x07\u202e"
    graph = LiveGraph(2, problem=wild)
    graph.feed({"tell": "graph", "topics": [[wild, wild, 1, 1]], "services": [[wild, wild]],
                "actions": [[wild, wild, 1, [wild]]], "nodes": [wild]})  # fmt: skip
    row = {"count": 1, "rate": 1, "text": wild, "number": 1, "fields": [[wild, wild, None]]}
    graph.feed({"tell": "topics", "rows": {wild: row}})
    graph.feed({"tell": "sending", "name": wild, "rate": 1, "text": wild})
    graph.feed({"tell": "goal", "id": 1, "name": wild, "sent": wild, "state": wild, "text": wild,
                "is_over": False, "is_failure": False})  # fmt: skip
    parameter = {"name": wild, "value": wild, "type": "string", "range": None, "about": wild,
                 "is_read_only": True}  # fmt: skip
    graph.feed({"tell": "parameters", "node": wild, "rows": [parameter]})
    graph.problem = wild
    rows = live_rows([graph], {f"2 topic {wild}", f"2 node {wild}"}, {
        f"2 service {wild}": Answer(wild)
    })  # fmt: skip
    assert {row.kind for row in rows} == set(Kind)
    for width in (40, 120):
        columns = columns_of(rows, width)
        drawn = "".join(piece.text for row in rows for piece in line_of(row, columns, width))
        assert drawn.isprintable() and "\u202e" not in drawn


def test_two_generations_are_told_apart_and_problems_said(graph: LiveGraph) -> None:
    other = LiveGraph(1)
    other.problem = "the master\x1b is gone"
    rows = live_rows([graph, other], set(), {})
    assert rows[0].name == "ROS 2 topics"
    assert (rows[-1].kind, rows[-1].name) == (Kind.NOTE, "the master\\x1b is gone")


@pytest.mark.parametrize(
    "name",
    ["/日本語/トピック", "/a\x1b[2J\n\t\u202eb", "/e\u0301\u200d👩\u200d🚀", "/" + "w" * 300],
)
@pytest.mark.parametrize("width", [12, 80, 200])
def test_whatever_is_long_or_strange_takes_a_row(name: str, width: int) -> None:
    long = "x\n日本\x1b[31m" * 20_000
    graph = LiveGraph(2)
    graph.feed({"tell": "graph", "topics": [[name, name, 1, 1]], "services": [[name, name]],
                "nodes": [name]})  # fmt: skip
    fields = [["data", long, None], [name, str([*range(10_000)]), 0.5]]
    graph.feed({"tell": "topics", "rows": {name: {"count": 1, "rate": 2.0, "text": long,
                                                  "number": 0.5, "fields": fields}}})  # fmt: skip
    about = {"range": None, "about": long, "is_read_only": False}
    graph.feed({"tell": "parameters", "node": name, "rows": [
        {"name": name, "value": long, "type": "string", **about},
        {"name": "list", "value": [*range(10_000)], "type": "int_list", **about},
    ]})  # fmt: skip
    unfolded = {f"2 topic {name}", f"2 node {name}"}
    rows = live_rows([graph], unfolded, {f"2 service {name}": Answer(long)})
    kinds = [Kind.HEADING, Kind.TOPIC, Kind.NOTE, Kind.FIELD, Kind.FIELD, Kind.HEADING,
             Kind.SERVICE, Kind.ANSWER, Kind.HEADING, Kind.NODE, Kind.PARAMETER,
             Kind.PARAMETER]  # fmt: skip
    assert [row.kind for row in rows] == kinds
    columns = columns_of(rows, width)
    for row in rows:
        line = "".join(piece.text for piece in line_of(row, columns, width))
        assert line.isprintable() and cell_len(line) <= max(width, 40)
        # What no window shows is not carried along: it would be measured with every key.
        assert len(row.value) < 5000
    # Nor does a field take it.
    assert isinstance(form_for(rows[-2], Session(b""), {}), str)
    assert not isinstance(
        form_for(rows[-1]._replace(parameter=LiveParameter("p", 1, "int")), Session(b""), {}), str
    )


def test_each_generation_is_asked_for_its_own_alone() -> None:
    graphs = []
    for version in (1, 2):
        graph = LiveGraph(version)
        topics = [["/both", "std_msgs/String", 1, 0], [f"/of{version}", "std_msgs/String", 1, 0]]
        graph.feed({"tell": "graph", "topics": topics, "services": [], "nodes": [f"/n{version}"]})
        graphs.append(graph)
    unfolded = {"1 topic /both", "2 topic /of2", "1 node /n1", "2 node /n2"}
    rows = live_rows(graphs, unfolded, {})
    everything = range(len(rows))
    wanted = Watching(("/both", "/of1"), ("/both",), ("/n1",))
    assert watching_of(rows, everything, 1, unfolded) == wanted
    wanted = Watching(("/both", "/of2"), ("/of2",), ("/n2",))
    assert watching_of(rows, everything, 2, unfolded) == wanted
    cursor = next(row for row in rows if row.key == "2 topic /both")
    assert watching_of(rows, everything, 2, set(), cursor).full == ("/both",)
    # Of a node that is unfolded the parameters may be in sight, wherever it is; a topic is not.
    assert watching_of(rows, range(0), 2, unfolded) == Watching(nodes=("/n2",))
