"""Keys that come before the wizard has a page for them do what they do for a slow user."""

from __future__ import annotations

import asyncio
import time
from collections.abc import Awaitable, Callable, Sequence
from pathlib import Path
from typing import Any

import pytest
from machine import mostly_long
from studio_driver import studio
from test_terminal import Terminal, start
from test_terminal import terminal as terminal
from textual import events
from textual.widgets import Button
from wizard_courses import TWO_NODES
from wizard_driver import SMALL, WizardDriver

from plastron_tui.studio.wizard.form_page import FormPage
from plastron_tui.studio.wizard.menu_page import Menu
from plastron_tui.studio.wizard.rows import Row
from plastron_tui.studio.wizard.screen import Wizard
from plastron_tui.studio.wizard.view import View

WAYS = {
    "the first menu": ["down", "down"],
    "a key of no menu": ["x", "5", "down"],
    "two pages on": ["enter", *"horn", "enter", "down"],
    "a value": ["enter", "enter", "down", "enter", "end", "s", "tab", "down", "down", "enter"],
    "back": ["enter", *"horn", "enter", "f2", "end", "s"],
    "a choice": ["down", "enter", "down", "enter", "down"],
    "another type": [
        *("enter", "enter", *["down"] * 4, "enter", "tab", "down", "down", "down", "tab", "x"),
        *("shift+tab", "up", "tab", "y"),
    ],
    "to the end": ["enter", *"horn", *["enter"] * 6],
    "away and on": ["down", "enter", "escape", "escape", "x"],
    "away at once": ["escape", "y"],
    "from the end": ["enter", *["enter"] * 6, "escape", "z"],
}

SLOWED = ("two pages on", "a value", "a choice", "to the end")
"""What is also gone where what hears of a key takes its time."""

HEARS = [
    (Menu, "on_option_list_option_selected"),
    (Row, "on_input_changed"),
    (Row, "on_input_submitted"),
    (FormPage, "on_entered"),
    (FormPage, "on_reached"),
]


def slowed(hear: Callable[[Any, Any], None]) -> Callable[[Any, Any], Awaitable[None]]:
    async def slow(self: Any, message: Any) -> None:
        await asyncio.sleep(0.02)
        hear(self, message)

    return slow


async def state(it: WizardDriver) -> tuple[object, ...]:
    """Return all that keys change."""
    await it.settle()
    if not it.is_open:
        return it.driver.text, it.driver.main.editor.cursor_offset
    shown: object = None
    if it.screen.query(Menu):
        shown = it.here
    elif it.screen.query(FormPage):
        shown = it.rows, it.form.key_here
    return it.driver.text, it.title, shown, it.statements, it.screen.is_done


async def quickly(it: WizardDriver, keys: Sequence[str]) -> None:
    """Send keys as a terminal does that has them all at once."""
    for key in keys:
        it.driver.app.post_message(events.Key(key, key if len(key) == 1 else None))
    await it.driver.all_in()


async def slowly(it: WizardDriver, keys: Sequence[str]) -> None:
    """Send keys as somebody does who looks at what each of them does."""
    for key in keys:
        await it.press(key)
        await it.driver.all_in()
        await it.settle()


# What has the focus counts for the first key alone. The other ways are gone further down.
@pytest.mark.long
@pytest.mark.parametrize(
    "case",
    [
        *((way, "editor") for way in WAYS if way not in SLOWED),
        ("to the end", "nodes"),
        ("away at once", "nodes"),
    ],
)
async def test_a_burst_does_what_single_keys_do(here: Path, case: tuple[str, str]) -> None:
    way, focus = case
    states = []
    for send in (slowly, quickly):
        path = here / f"{send.__name__}.plastron"
        path.write_text(TWO_NODES)
        async with studio(path, SMALL) as driver:
            if focus == "nodes":
                await driver.press("alt+1")
                assert driver.main.panels["nodes"].has_focus
            it = WizardDriver(driver)
            await send(it, ["ctrl+u", *WAYS[way]])
            states.append(await state(it))
    assert states[1] == states[0]


@pytest.mark.parametrize("way", mostly_long(SLOWED, ["a value"]))
async def test_a_key_waits_for_all_that_follows_from_the_one_before(
    here: Path, way: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """However long what has the focus, and what is around it, takes to pass on what it heard."""
    states = []
    for number, send in enumerate((slowly, quickly, quickly)):
        if number == 2:
            for type_, name in HEARS:
                monkeypatch.setattr(type_, name, slowed(getattr(type_, name)))
        path = here / f"{number}.plastron"
        path.write_text(TWO_NODES)
        async with studio(path, SMALL) as driver:
            it = WizardDriver(driver)
            await send(it, ["ctrl+u", *WAYS[way]])
            states.append(await state(it))
    assert states[1:] == states[:1] * 2


async def test_keys_pressed_in_one_go_reach_the_first_page(here: Path) -> None:
    async with studio(None, SMALL) as driver:
        it = WizardDriver(driver)
        await driver.pilot.press("ctrl+u", "enter", *"horn", "enter", "down", "up", "enter")
        await driver.all_in()
        await it.settle()
        assert it.statements[0] == "create_node 'horn' as horn"
        assert len(it.statements) > 1
        assert driver.text == ""


async def test_leaving_while_a_page_is_on_its_way(
    here: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """What was to be shown then has nowhere to go; that is no mistake."""
    view = Wizard._view

    def slow(self: Wizard, *asked: Any) -> View:
        time.sleep(0.1)
        return view(self, *asked)

    async def go_slowly(self: Button) -> None:
        await asyncio.sleep(0.4)

    async with studio(None, SMALL) as driver:
        it = WizardDriver(driver)
        await it.press("ctrl+u")
        await it.settle()
        monkeypatch.setattr(Wizard, "_view", slow)
        monkeypatch.setattr(Button, "on_unmount", go_slowly, raising=False)
        await quickly(it, ["enter", "escape", "escape", "z"])
        await driver.until(lambda: driver.text == "z" and not it.is_open)
        await driver.app.workers.wait_for_complete()
        await driver.pilot.pause()
        assert driver.app.screen is driver.main
        assert driver.text == "z"


async def test_what_is_typed_before_the_key_stays_in_the_text(here: Path) -> None:
    async with studio(None, SMALL) as driver:
        it = WizardDriver(driver)
        await quickly(it, [*"ab", "ctrl+u", "enter", *"horn"])
        await it.settle()
        assert driver.text == "ab"
        assert it.statements == ("create_node 'horn' as horn",)


def test_keys_of_a_terminal_that_come_at_once(terminal: Terminal, tmp_path: Path) -> None:
    start(terminal, "mine.plastron")
    terminal.wait(lambda screen: "no nodes yet" in screen)
    terminal.keys("C-u", "Enter", "h", "o", "r", "n", "Enter", "Down", "Up")
    terminal.wait(lambda screen: "create_node 'horn' as horn" in screen and "step 2" in screen)
    for title in ("Make a node", "What do you want?"):
        terminal.keys("Escape")
        terminal.wait(lambda screen: f" {title}" in screen.splitlines()[0])  # noqa: B023
    terminal.keys("Escape")
    terminal.wait(lambda screen: "and forget" in screen)
    terminal.keys("Right", "Enter")
    terminal.wait(lambda screen: "no nodes yet" in screen)
    terminal.keys("C-s")
    terminal.wait(lambda screen: "saved mine.plastron" in screen)
    assert (tmp_path / "mine.plastron").read_text() == ""
