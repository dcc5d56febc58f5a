"""What is pasted into the wizard is not lost, and chooses nothing by accident."""

from __future__ import annotations

from pathlib import Path

import pytest
from textual import events
from wizard_driver import wizard

from plastron_tui.studio.terminal_driver import Burst
from plastron_tui.studio.wizard.menu_page import Item
from plastron_tui.studio.wizard.pasted import entry_for, insertion, lines_of, preview

ITEMS = [Item("make a node", "node"), Item("closed", "robot", closed="not now"), Item("a service")]
LINES = "create_node 'ear' as ear\r\nsubscribe ear to 'chatter' of message_type String\r\n"


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("node", 0),
        (" Service ", 2),
        ("robot", None),
        ("make a node", None),
        ("", None),
        ("x", None),
    ],
)
def test_a_word_finds_an_entry(text: str, found: int | None) -> None:
    assert entry_for(text, ITEMS) == found


@pytest.mark.parametrize(
    ("program", "text", "after"),
    [("", "a\rb", "a\nb\n"), ("x", "\n\na\r\n", "x\na\n"), ("x\n", "a\n\nb", "x\na\n\nb\n")],
)
def test_lines_go_behind_the_program(program: str, text: str, after: str) -> None:
    edit = insertion(program.encode(), lines_of(text))
    assert program + edit.text == after
    assert edit.span.start == len(program)


def test_of_many_lines_the_first_are_shown() -> None:
    assert preview(["a", "b"]) == "a\nb"
    assert preview(["a"] * 20).endswith("a\n… and 12 more")


async def test_a_paste_onto_a_menu_and_onto_a_form(two: Path) -> None:
    async with wizard(two) as it:
        first = it.here
        it.driver.app.post_message(events.Paste("launch"))
        await it.driver.until(lambda: it.here != first)
        assert "start" in it.here
        before = it.driver.text
        it.driver.app.post_message(events.Paste(LINES))
        await it.driver.dialog("Question")
        await it.pilot.press("escape")
        await it.driver.until(lambda: it.is_open)
        assert it.driver.text == before
        await it.pick("make a node")
        # A long one comes in pieces, and what comes as keys answers no question.
        for piece in (LINES[:30], LINES[30:]):
            it.driver.app.post_message(events.Paste(piece))
        question = await it.driver.dialog("Question")
        letters = "look into it\r"
        keys = [events.Key("enter" if each == "\r" else each, each) for each in letters]
        it.driver.app.post_message(Burst(letters * 6, keys * 6))
        await it.pilot.pause()
        assert it.driver.app.screen is question
        await it.pilot.press("enter")
        await it.driver.until(lambda: it.is_open)
        await it.settle()
        assert it.driver.text == before + LINES.replace("\r\n", "\n")
        assert "ear" in it.screen.course.session.workspace.nodes
        it.driver.app.post_message(events.Paste("watcher\n"))
        await it.driver.until(lambda: it.rows["name"] == "watcher")
