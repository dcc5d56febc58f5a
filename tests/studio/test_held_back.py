from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from studio_driver import PROGRAM, Driver, studio

from plastron_tui.studio.main import held_back


@pytest.fixture(autouse=True)
def nobody_rests(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let no time be a rest: a busy machine may take more of it for a key."""
    monkeypatch.setattr(held_back, "REST", 3600)


def wrong(driver: Driver) -> tuple[int, int, str]:
    """How many mistakes are marked, how many are listed, and what the tab says of them."""
    main = driver.main
    listed = sum(not entry.startswith("=") for entry in driver.shown("problems"))
    return len(main.editor.marks), listed, main.dock_layout._counts["problems"]


async def test_a_line_is_not_wrong_while_somebody_types_it(
    program: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    program.write_text(f"{PROGRAM}\nsubscribe nobody to 'chatter' of message_type String\n")
    async with studio(program) as driver:
        main = driver.main
        await driver.show("problems")
        assert wrong(driver) == (1, 1, 1)
        end = len(PROGRAM)
        main.editor.go_to(end)
        main.editor.focus()
        await driver.pilot.press(*"subscribe")
        await driver.until(lambda: not driver.is_missing)
        # The mistake of the other line stays, that of this one waits.
        assert wrong(driver) == (1, 1, 1)
        with monkeypatch.context() as resting:
            resting.setattr(held_back, "REST", 0.05)
            await driver.pilot.press("x")
            await driver.until(lambda: wrong(driver) == (2, 2, 2))
            await driver.pilot.press("backspace")
            await driver.until(lambda: not driver.is_missing and not main.feed.held_back.is_holding)
        await driver.pilot.press("space", *"listene")
        await driver.until(lambda: not driver.is_missing)
        assert wrong(driver) == (1, 1, 1)
        # Once the line is left, all of it is told at once.
        await driver.pilot.press("home", "up")
        assert wrong(driver) == (2, 2, 2)


def test_nothing_is_told_as_long_as_a_list_of_what_can_stand_there_is_open(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    class Resting:
        def __init__(self, _pump: object, rest: Callable[[], object]) -> None:
            self.over, self.starts = rest, 0

        def start(self, _seconds: float) -> None:
            self.starts += 1

        def stop(self) -> None: ...

    monkeypatch.setattr(held_back, "Delay", Resting)
    popup, told = SimpleNamespace(is_open=True), []
    buffer = SimpleNamespace(start=lambda row: 0, end=lambda row: 9)
    marks = SimpleNamespace(between=lambda start, end: ())
    editor: Any = SimpleNamespace(
        popup=popup, marks=marks, state=SimpleNamespace(row=3, buffer=buffer)
    )
    held: Any = held_back.HeldBack(None, editor, lambda: told.append(1))  # type: ignore[arg-type]
    held.edited()
    held._rest.over()
    assert held.is_holding and not told and held._rest.starts == 2
    popup.is_open = False
    held._rest.over()
    assert told and not held.is_holding


async def test_what_was_wrong_before_stays(program: Path) -> None:
    line = "subscribe listener to 'chat' of message_type Strin\n"
    program.write_text(PROGRAM + line)
    async with studio(program) as driver:
        await driver.show("problems")
        driver.main.editor.go_to(len(PROGRAM) + line.index("chat") + 4)
        driver.main.editor.focus()
        before = wrong(driver)
        assert before[0] >= 1
        await driver.pilot.press("x")
        await driver.until(lambda: not driver.is_missing)
        assert wrong(driver) == before


async def test_what_another_line_gets_is_shown_at_once(program: Path) -> None:
    async with studio(program) as driver:
        editor = driver.main.editor
        await driver.show("problems")
        editor.go_to(PROGRAM.index("talker' as talker") + len("talker' as talker"))
        editor.focus()
        await driver.pilot.press("x")
        await driver.until(lambda: not driver.is_missing)
        # All that names the variable is wrong now.
        assert wrong(driver)[0] >= 2
        assert all(start > editor.cursor_offset for start in editor.marks.starts())
