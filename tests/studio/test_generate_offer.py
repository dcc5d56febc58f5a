"""A program that generates nothing: what is missing is said, and written if that is wanted."""

from __future__ import annotations

from pathlib import Path

import pytest
from studio_driver import PROGRAM, studio
from textual.widgets import Label

from plastron_tui.generating.nothing import missing_statements
from plastron_tui.session import Session
from plastron_tui.studio import running

IDLE = "".join(line for line in PROGRAM.splitlines(True) if not line.startswith("generate"))
BOTH = ("generate_node talker", "generate_node listener")
ROBOT = "create_robot 'cart' as cart\n"


@pytest.mark.parametrize(
    ("text", "missing"),
    [
        ("", ()),
        (IDLE, BOTH),
        # A node without anything to do counts where no other one is there.
        (IDLE + "create_node 'more' as more\n", BOTH),
        ("create_node 'more' as more\n", ("generate_node more",)),
        (ROBOT, ("generate_robot cart",)),
        (ROBOT + IDLE, BOTH),
    ],
)
def test_the_statements_that_are_missing(text: str, missing: tuple[str, ...]) -> None:
    assert missing_statements(Session(text.encode()).workspace) == missing


async def test_what_is_missing_is_added_by_enter(
    program: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    started = []

    def start(path: Path, *_: object) -> None:
        started.append(path.read_text())
        raise OSError("a stand-in")

    monkeypatch.setattr(running, "Running", start)
    program.write_text(IDLE)
    async with studio(program) as driver:
        await driver.pilot.press("f5")
        question = await driver.dialog("Question")
        said = str(question.query_one("#dialog-text", Label).content)
        assert said.splitlines()[1:] == list(BOTH)
        await driver.pilot.press("escape")
        await driver.back()
        assert driver.text == IDLE and not started
        # Keys that come before the question is there are for it.
        await driver.pilot.press("f5", "enter")
        await driver.until(lambda: bool(started))
        assert started[0].split("\n")[-3:] == [*BOTH, ""]
        driver.main.editor.undo()
        assert driver.text == IDLE
        await driver.settle()
        await driver.pilot.press("f6")
        await driver.dialog("Question")
        await driver.pilot.press("enter")
        dialog = await driver.dialog("GenerateDialog")
        assert len(dialog.plan.files) == 2
        await driver.pilot.press("escape")
        await driver.back()
        driver.main.editor.replace_all(ROBOT.encode())
        await driver.press("f5")
        assert "there is no node to run yet" in driver.notes()
