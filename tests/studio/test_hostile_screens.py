"""Whatever a file's name or text holds, no screen of the studio lets a terminal obey it."""

from __future__ import annotations

import sys
from pathlib import Path

from hostile import NAME, OBEYED, PAYLOAD, PROGRAM, on_terminal
from rich.segment import Segment
from studio_driver import Driver, studio
from textual.color import Color

from plastron_tui.studio.control_characters import ONLY_TEXT

# What each action brings to the front; a program with mistakes is not generated.
DIALOGS = {
    "open": "ChooseFile", "save_as": "ChooseFile", "help": "Help", "generate": "MainScreen",
    "menu": "ActionMenu", "wizard": "Wizard", "welcome": "Welcome",
    "new": "MainScreen", "tour": "Tour",
}  # fmt: skip


def screen_text(driver: Driver) -> str:
    strips = driver.app.screen._compositor.render_strips()
    return "\n".join(segment.text for strip in strips for segment in strip)


async def test_no_screen_shows_what_a_terminal_obeys(tmp_path: Path) -> None:
    folder = tmp_path / f"folder{NAME}"
    folder.mkdir()
    path = folder / f"{NAME}.plastron"
    path.write_text(PROGRAM)
    seen = {}
    async with studio(path) as driver:
        driver.app.profile.remembered.opened(path)
        seen["main"] = screen_text(driver)
        driver.app.notify(f"said {PAYLOAD}", markup=False)
        await driver.until(lambda: bool(driver.app._notifications))
        seen["notes"] = "".join(note.message for note in driver.app._notifications)
        for name, dialog in DIALOGS.items():
            await driver.app.run_action(name, driver.main)
            await driver.pilot.pause()
            await driver.dialog(dialog)
            seen[name] = screen_text(driver)
            while driver.app.screen is not driver.main:
                driver.app.pop_screen()
                await driver.pilot.pause()
    assert {name for name, text in seen.items() if OBEYED.search(text.replace("\n", ""))} == set()
    assert "p\\x1b]0;OWNED" in seen["main"]
    assert "said \\x1b]0;OWNED" in seen["notes"]
    assert seen.keys() == {"main", "notes", *DIALOGS}


def test_a_terminal_is_sent_nothing_of_a_name(tmp_path: Path) -> None:
    path = tmp_path / f"{NAME}.plastron"
    path.write_text(PROGRAM)
    told = []

    def answer(said: str) -> bytes:
        if not told and "OWNED" in said:
            told.append(said)
            return b"\x11"  # Ctrl-Q
        return b""

    command = [sys.executable, "-m", "plastron_tui", path.name]
    said = on_terminal(command, tmp_path, answer=answer)
    assert "\\x1b]0;OWNED" in said
    for payload in ("\x1b]0;", "\x9b", "\x90", "\u202e", "\u2066", "\x1b[35;5m"):
        assert payload not in said


def test_what_is_taken_out_moves_nothing() -> None:
    line = [Segment(f"a{PAYLOAD}b"), Segment("ä\u00a0\u3000👩\u200d🚀")]
    before = sum(segment.cell_length for segment in line)
    after = ONLY_TEXT.apply(line, Color(0, 0, 0))
    assert sum(segment.cell_length for segment in after) == before
    assert after[0].text == "a]0;OWNED[35;5mX2Jqgnpb"
    assert after[1] == line[1]
    assert ONLY_TEXT.apply([Segment("a\udcffb")], Color(0, 0, 0))[0].text == "a�b"
