"""A value that a running node was given is written into the program."""

from __future__ import annotations

from pathlib import Path

import pytest
from stand_in_nodes import asked, live, wait_shown, watch_stand_in
from studio_driver import studio

from plastron_tui.ros.parameters import ParameterType
from plastron_tui.session import Session
from plastron_tui.studio.analysis import analyse
from plastron_tui.studio.parameter_default import default_span
from plastron_tui.studio.wizard.parameter_kinds import parameter_entry
from plastron_tui.studio.wizard.sent_values import written_setting

PROGRAM = """\
create_node 'talker' as it
it has_parameter 'speed' of parameter_type float with default 0.5 between 0 and 1
create_message m of message_type Float64 and input parameter 'speed'
it publish m to 'b' of message_type Float64 at 1 hz
generate_node it
"""
TAKEN = "it no_longer_has_parameter 'speed'\n"


@pytest.mark.parametrize(
    ("program", "node", "parameter", "found"),
    [
        (PROGRAM, "/talker", "speed", True),
        (PROGRAM, "/left/talker", "speed", True),
        (PROGRAM, "/talker", "height", False),
        (PROGRAM, "/listener", "speed", False),
        (PROGRAM + TAKEN, "/talker", "speed", False),
    ],
)
def test_the_default_is_found_where_one_node_has_it(
    program: str, node: str, parameter: str, found: bool
) -> None:
    analysis = analyse(Session(program.encode()), lambda: None)
    span = default_span(analysis, node, parameter)
    assert (span is not None and program[span.start : span.end] == "0.5") is found


@pytest.mark.parametrize(
    ("type_", "text", "written"),
    [("float", " 0.8", "0.8"), ("float", "inf", None), ("int", "-3", "-3"),
     ("bool", "off", "False"),
     ("string", 'a "b"', '"a \\"b\\""'), ("string", '" a"', '" a"'),
     ("float_list", "1, 2.5", "[1, 2.5]"), ("string_list", '"a, b", c', '["a, b", "c"]')],
)  # fmt: skip
def test_a_value_is_written_as_programs_have_it(type_: str, text: str, written: str | None) -> None:
    kind = ParameterType(type_)
    assert written_setting(parameter_entry("p", kind), kind, text) == written


async def test_a_value_that_was_set_goes_into_the_program(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    orders = watch_stand_in(tmp_path, monkeypatch)
    path = tmp_path / "talk.plastron"
    path.write_text(PROGRAM)
    async with studio(path, (80, 24)) as driver:
        runner, title = driver.main.runner, driver.main._title
        await driver.show("live")
        await driver.press("f5")
        await wait_shown(driver, "≈ /chatter")
        assert not runner.is_older
        await driver.press("end", "right")
        await wait_shown(driver, "speed")
        await driver.press("down", "s")
        await driver.dialog("LiveForm")

        await driver.pilot.press(*["backspace"] * 3, *"0.8", "tab", "tab", "enter")
        await driver.back()
        assert asked(orders, "set")[-1]["value"] == 0.8
        written = PROGRAM.replace("default 0.5", "default 0.8")
        await driver.until(lambda: driver.text == written)
        await driver.settle()
        assert "the program begins with speed 0.8 now" in driver.notes()
        # The node has that value: what runs is not older for it. It is for another change.
        assert not runner.is_older and "older" not in title.text
        driver.main.editor.focus()
        await driver.press("ctrl+end")
        await driver.type("// a comment\n")
        assert not runner.is_older
        await driver.type("create_node 'b' as b\n")
        assert runner.is_older and "F5 stops, Alt-R runs anew" in title.text
        # Nodes that run go on where the text has a mistake.
        await driver.type("no")
        await driver.press("alt+r")
        await driver.until(lambda: "1 problem has to be fixed first" in driver.notes())
        assert runner.is_running and not runner._run.is_stopping
        driver.main.editor.focus()
        await driver.press("backspace", "backspace")
        started = runner._run.started_at
        await driver.press("alt+r")
        await driver.until(lambda: runner.is_running and runner._run.started_at > started)
        assert not runner.is_older and path.read_text() == driver.text
        assert live(driver).is_attached
