"""The panel with what nodes print: repeated lines, colours, the filter, reading further up."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as some
from studio_driver import Driver, studio
from textual.widgets._toast import Toast

from plastron_tui.runtime.child import Exit, Process
from plastron_tui.runtime.labels import ended_node, is_own, split_label
from plastron_tui.studio.app import StudioApp
from plastron_tui.studio.panels import output_log
from plastron_tui.studio.panels.log_view import wrapped
from plastron_tui.studio.panels.output_log import OutputLog, printed_record
from plastron_tui.studio.panels.styles import Piece


def shown(log: OutputLog) -> list[str]:
    return ["".join(piece.text for piece in log.line(record)) for record in log.records]


def log_of(*lines: str) -> OutputLog:
    log = OutputLog()
    for line in lines:
        log.add([printed_record(line)])
    return log


@pytest.mark.parametrize(
    ("lines", "wanted"),
    [
        (["a | x"] * 37, ["a | x  ×37"]),
        (["a | x", "b | y"] * 3, ["a | x  ×3", "b | y  ×3"]),
        (["a | x", "a | y", "a | x"], ["a | x", "a | y", "a | x"]),
        (["a | ", "a | "], ["a | ", "a | "]),
        (["| a file | lines |"] * 2, ["| a file | lines |  ×2"]),
        (["x", "x"], ["x  ×2"]),
        # What is far above was perhaps read and forgotten: it is said again.
        (
            ["a | x", *(f"b | {number}" for number in range(9)), "a | x"],
            ["a | x", *(f"b | {number}" for number in range(9)), "a | x"],
        ),
        # The numbers of a scan are no lines that anybody reads.
        (
            [f"a | ranges=array('f', [{', '.join(['0.5', '-1e-05', 'inf', 'nan'] * 90)}]) [1, 2]"],
            ["a | ranges=array('f', [0.5, -1e-05, inf, nan, … 356 more]) [1, 2]"],
        ),
        (["a | " + "x" * 5000], ["a | " + "x" * 4000 + " … and 1,000 characters more"]),
    ],
)
def test_repeated_lines_are_counted(lines: list[str], wanted: list[str]) -> None:
    assert shown(log_of(*lines)) == wanted


def test_a_line_says_when_it_came_last() -> None:
    log = OutputLog()
    for at in (0.5, 3661.87):
        log.add([replace(printed_record("a | x"), at=at)])
    (record,) = log.records
    line = log.line(record, with_time=True)
    # Half an hour is the least that time zones differ by.
    assert line[0].text.endswith(":01.8 ") and [piece.text for piece in line[1:]] == [
        "a | ", "x", "  ×2"
    ]  # fmt: skip
    # What follows in a second row stands below the text.
    (_, second) = wrapped((*line[:2], Piece("so many words " * 2)), 36)
    assert second[0].text == " " * len(line[0].text + "a | ")


@given(some.lists(some.tuples(some.sampled_from("abc"), some.sampled_from("xyz"))))
def test_every_line_is_counted_once(printed: list[tuple[str, str]]) -> None:
    log = log_of(*(f"{node} | {text}" for node, text in printed))
    for pair in set(printed):
        times = sum(each.times for each in log.records if (each.node, each.text) == pair)
        assert times == printed.count(pair)


def test_nodes_have_their_colours_and_levels_too() -> None:
    log = log_of("a   | one", "bb  | [WARN] two", "a   | [INFO] no error here", "plastron | three")
    tones = [[piece.tone for piece in log.line(record)] for record in log.records]
    assert tones[0][0] == tones[2][0] != tones[1][0]
    assert tones[3][0] not in (tones[0][0], tones[1][0])
    assert [line[1] for line in tones] == ["", "warning", "", ""]


def test_what_a_run_says_of_a_node_that_fails_is_understood() -> None:
    process = Process("talker", ("python3",))
    for end in (Exit(process, -9), Exit(process, 1), Exit(process, None, "no such file")):
        found = ended_node(f"plastron | talker {end.words}: KeyError: 'x'")
        assert found is not None and found.node == "talker" and found.how.startswith(end.words)
        assert found.is_failure
    found = ended_node(f"plastron | talker {Exit(process, 0).words}")
    assert found == ("talker", "finished") and not found.is_failure
    assert ended_node("other | talker died with exit status 1") is None


@pytest.mark.parametrize(
    ("line", "label", "rest", "is_the_runs"),
    [
        ("talker   | hello", "talker   | ", "hello", False),
        ("plastron | talker died", "plastron | ", "talker died", True),
        # A node may be called nearly so, and print the name.
        ("plastron_demo | hello", "plastron_demo | ", "hello", False),
        ("plastron is here", "", "plastron is here", False),
        ("a | b | c", "a | ", "b | c", False),
        # What a build prints as a table is of no node.
        ("plastron talker | 3 files", "", "plastron talker | 3 files", False),
        ("", "", "", False),
    ],
)
def test_what_stands_before_a_line_is_told_from_it(
    line: str, label: str, rest: str, is_the_runs: bool
) -> None:
    assert split_label(line) == (label, rest)
    assert is_own(line) == is_the_runs


def test_so_much_text_is_kept() -> None:
    log = log_of(*(f"a | {number:04}{'x' * 3000}" for number in range(400)))
    assert sum(len(record.text) for record in log.records) > 0.99 * output_log.MOST_TEXT
    assert sum(len(record.text) for record in log.records) <= output_log.MOST_TEXT
    assert log.records[-1].text.startswith("0399")


@given(some.lists(some.lists(some.integers(0, 3), max_size=12)))
def test_a_change_tells_which_records_are_other_ones(steps: list[list[int]]) -> None:
    log = OutputLog()
    known: list[str] = []
    for numbers in steps:
        change = log.add(printed_record(f"n{number % 2} | {number}") for number in numbers)
        known = [*known[change.dropped : change.start], *shown(log)[change.start :]]
        assert known == shown(log)


async def test_the_output_can_be_read_and_filtered_while_nodes_print(
    program: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    most = 300
    monkeypatch.setattr(output_log, "MOST_RECORDS", most)
    async with studio(program, (80, 24)) as driver:
        main = driver.main
        output = main.panels["output"]
        main.dock_layout.reveal("output")
        await driver.settle()
        # The editor keeps the focus: who starts nodes goes on to write.
        assert main.focused is main.editor.view
        output.begin("plastron run talk.plastron")
        output.add(f"talker | {number} {'long ' * 30}" for number in range(most - 1))
        await driver.pilot.pause()
        assert output.view.is_vertical_scroll_end
        await driver.show("output")
        await driver.press("pageup", "pageup")
        before = output.view.render_line(0).text
        output.add(f"listener | {number}" for number in range(50))
        await driver.pilot.pause()
        assert output.view.render_line(0).text == before
        assert len(output.lines) == most
        width = output.view.outer_size.width - 1
        assert output.view.rows == tuple(
            row for line in output.lines for row in wrapped(line, width)
        )
        await driver.press("slash", *"LISTENER", "space", "7")
        wanted = {f"listener | {number}" for number in (7, *range(17, 50, 10))}
        assert set(output.text.splitlines()) == wanted
        output.add(["talker | no", "listener | 77"])
        await driver.pilot.pause()
        assert set(output.text.splitlines()) == wanted | {"listener | 77"}
        # What comes again is counted where it stands, whatever stands between that is not shown.
        output.add(["listener | 77"])
        await driver.pilot.pause()
        wanted.add("listener | 77  ×2")
        assert set(output.text.splitlines()) == wanted
        assert "6 of 300" in str(output.query_one("#output-count").content)
        await driver.press("enter")
        assert output.view.has_focus
        await driver.press("t")
        assert set(output.text.splitlines()).isdisjoint(wanted)
        await driver.press("t")
        assert set(output.text.splitlines()) == wanted
        await driver.press("slash", "escape")
        assert len(output.lines) == most
        assert output.view.has_focus


async def test_notes_stand_above_the_lines_below_and_once(
    program: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    # It would go by itself, and nothing be proved.
    monkeypatch.setattr(StudioApp, "NOTIFICATION_TIMEOUT", 3600)
    program.write_text("nonsense\n")
    app = StudioApp(program)
    app.animation_level = "none"
    async with app.run_test(size=(50, 12), notifications=True) as pilot:
        driver, main = Driver(app, pilot), app.main
        await driver.back()
        await driver.press("f5", "f5")
        await driver.until(lambda: len(main.query(Toast)) > 0)
        await driver.pilot.pause()
        assert len(main.query(Toast)) == 1
        toast = main.query_one(Toast).region
        assert toast.x >= 0 and toast.bottom <= app.size.height - 2
        # It goes when it is dealt with, without waiting for its time.
        main.editor.replace_all(b"create_node 'a' as a\n")
        await driver.settle()
        await driver.until(lambda: not main.query(Toast))
