"""Keys that come before a dialog is there, or after it has its answer, do what they are for."""

from __future__ import annotations

import time
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import pytest
from machine import mostly_long
from studio_driver import PROGRAM, Driver, studio
from textual import events
from textual.widgets import Button, Input

from plastron_tui.studio import code_places
from plastron_tui.studio.actions import key_owners
from plastron_tui.studio.key_order import ASKING, OPENING
from plastron_tui.studio.screens.question import Question
from plastron_tui.studio.terminal_driver import Burst
from plastron_tui.studio.wizard.statement_view import StatementView

OTHER = "// another program\n"


async def quickly(driver: Driver, *keys: str) -> None:
    """Send keys as a terminal does that has them all at once."""
    for key in keys:
        driver.app.post_message(events.Key(key, key if len(key) == 1 else None))
    app = driver.app
    await driver.until(lambda: app._keys_worker is None or app._keys_worker.is_finished)


@pytest.mark.parametrize(
    "keys", mostly_long([["enter"], ["ctrl+u"], ["alt+w"]], ["enter"], lambda keys: keys[0])
)
async def test_the_welcome_leads_on_to_the_wizard(tmp_path: Path, keys: Sequence[str]) -> None:
    async with studio(None, (80, 24), welcome=True) as driver:
        await driver.dialog("Welcome")
        await quickly(driver, *keys, "enter", *"horn")
        wizard = await driver.dialog("Wizard")
        await driver.until(lambda: bool(wizard.query(StatementView)))
        shown = wizard.query_one(StatementView)
        await driver.until(lambda: shown.lines[0].startswith("create_node 'horn' as horn"))
        assert driver.text == ""


@pytest.mark.parametrize("again", [1, 3])
async def test_an_answer_pressed_for_again_is_for_what_comes_next(
    program: Path, again: int
) -> None:
    async with studio(program) as driver:
        answers: list[str | None] = []
        question = Question("Well?", [("yes", "Yes"), ("no", "No")])
        driver.app.push_screen(question, answers.append)
        await driver.dialog("Question")
        button = question.query(Button).first()
        for _ in range(1 + again):
            question.post_message(Button.Pressed(button))
        await driver.back()
        assert answers == ["yes"]


async def test_a_question_that_comes_by_itself_is_not_answered_by_what_is_typed(
    program: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("plastron_tui.studio.key_order.QUIET", 3600.0)
    async with studio(program) as driver:
        answers: list[str | None] = []
        for _ in range(2):
            question = Question("Well?", [("yes", "Yes"), ("no", "No")], is_unasked=True)
            driver.app.push_screen(question, answers.append)
            await driver.until(lambda question=question: question.appeared is not None)
            await driver.pilot.press("n", "o", "enter")
            assert driver.app.screen is question
            # It is no answer: it goes where it was meant to.
            driver.app.post_message(events.Paste("// pasted\n"))
            driver.app.post_message(Burst("// sent\r", []))
            await driver.until(lambda: len(driver.app._kept) == 5)
            await driver.pilot.press("escape")
            await driver.back()
        assert answers == ["", ""]
        typed = "no\n// pasted\n// sent\n"
        await driver.until(lambda: driver.text == typed * 2 + PROGRAM)


async def test_lines_that_come_as_keys_are_put_in_as_they_are(program: Path) -> None:
    lines = "node1 pub\rto 'a'\r"
    async with studio(program) as driver:
        driver.app.post_message(Burst(lines, []))
        driver.app.post_message(events.Key("ctrl+j", None))
        await driver.until(lambda: driver.text == "node1 pub\nto 'a'\n\n" + PROGRAM)
        assert not driver.main.editor.popup.is_open


async def test_letters_typed_blindly_are_no_answer(
    program: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("plastron_tui.studio.key_order.QUIET", 3600.0)
    async with studio(program) as driver:
        await driver.type("x")
        await quickly(driver, "ctrl+q", *"dont")
        question = await driver.dialog("Question")
        await driver.pilot.pause()
        assert question.is_current and not driver.app._kept
        # With the arrows one has seen it, and a letter counts at once.
        await driver.pilot.press("right", "c")
        await driver.back()
        assert driver.main.open.is_changed


async def test_a_file_is_opened_by_a_name_typed_at_once(program: Path) -> None:
    program.with_name("other.plastron").write_text(OTHER)
    async with studio(program) as driver:
        await quickly(driver, "ctrl+o", *"other", "enter", *"xy")
        await driver.back()
        await driver.until(lambda: driver.text == "xy" + OTHER)
        assert driver.main.open.path == program.with_name("other.plastron")
    assert program.read_text() == PROGRAM


async def test_a_new_program_is_saved_under_a_name_typed_at_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    async with studio(None) as driver:
        await quickly(driver, *"ab", "ctrl+s", *"new", "enter", *"cd")
        await driver.back()
        await driver.until(lambda: driver.text == "abcd")
    assert Path("new.plastron").read_text() == "ab"


async def test_the_files_are_written_by_an_enter_at_once(program: Path) -> None:
    async with studio(program) as driver:
        await quickly(driver, "f6", "enter")
        await driver.until((program.parent / "output" / "talker_pub.py").exists)


@pytest.mark.parametrize("key", ["ctrl+f", "ctrl+r"])
async def test_what_is_looked_for_is_typed_at_once(program: Path, key: str) -> None:
    async with studio(program) as driver:
        await quickly(driver, key, *"listener", "enter")
        await driver.settle()
        assert driver.text == PROGRAM


async def test_a_name_typed_at_once_goes_into_the_box(program: Path) -> None:
    async with studio(program) as driver:
        await driver.press("ctrl+home", "down", "down")
        await quickly(driver, "f2", *"speaker", "enter")
        await driver.back()
        await driver.settle()
        assert "speaker publish greeting" in driver.text


def test_what_opens_something_is_there() -> None:
    assert set(ASKING) | set(OPENING) <= {owner.id for owner in key_owners()}


async def test_keys_behind_that_of_a_panel_are_for_what_it_opens(
    program: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    async with studio(program, (80, 24)) as driver:
        await driver.show("nodes")
        await quickly(driver, "r", "end", *"s2", "enter")
        await driver.until(lambda: "create_node 'talkers2'" in driver.text)
        await driver.settle()
        assert driver.text == PROGRAM.replace("talker", "talkers2")
        # A file is looked for in a thread.
        find = code_places.find_code

        def find_late(*given: Any) -> Any:
            time.sleep(0.1)
            return find(*given)

        monkeypatch.setattr(code_places, "find_code", find_late)
        await driver.show("nodes")
        for key in ("c", "slash", *"rclpy"):
            driver.app.post_message(events.Key(key, "/" if key == "slash" else key))
        view = await driver.dialog("CodeView")
        await driver.until(lambda: any(each.value == "rclpy" for each in view.query(Input)))
        await driver.pilot.press("escape", "escape", "escape")
        await driver.back()
        # A text that comes as keys is no order to a panel, nor to the files that would be written.
        text = driver.text
        await driver.show("nodes")
        for opened in ("MainScreen", "GenerateDialog"):
            driver.app.post_message(
                Burst("dgrc\r", [events.Key("d", "d"), events.Key("enter", "\r")])
            )
            await driver.pilot.pause()
            assert type(driver.app.screen).__name__ == opened
            assert driver.text == text and not (program.parent / "output").exists()
            await driver.pilot.press("f6")
            await driver.dialog("GenerateDialog")
        await driver.pilot.press("escape")
        await driver.back()
        for panel in ("output", "live"):
            await driver.show(panel)
            await quickly(driver, "slash", *"words")
            assert driver.main.focused.value == "words"
