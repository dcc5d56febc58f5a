"""Whatever keys come, the wizard goes on, and what it writes is right."""

from __future__ import annotations

import random
from pathlib import Path

import pytest
from machine import mostly_long
from studio_driver import studio
from wizard_courses import NODE_FILE
from wizard_driver import WizardDriver

from plastron_tui.session import Session
from plastron_tui.studio.main.screen import MainScreen

KEYS = (
    *["enter"] * 6, *["down"] * 3, *["tab"] * 3, "up", "shift+tab", "f2", "alt+left", "f3", "space",
    "left", "pagedown", "home", "end", "backspace", "ctrl+u", "delete", "a", "5", "slash",
    "apostrophe", "quotation_mark", "left_parenthesis", "comma", "minus", "T", "é",
)  # fmt: skip


@pytest.mark.parametrize("seed", mostly_long(range(3), [0]))
async def test_random_keys(two: Path, seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(MainScreen, "action_run", lambda *_: None)
    two.with_name("sonar.py").write_text(NODE_FILE)
    chance = random.Random(seed)
    async with studio(two, chance.choice([(80, 24), (60, 20), (120, 40)])) as driver:
        it = WizardDriver(driver)
        main = driver.main
        texts = [main.editor.text]
        for _ in range(40):
            if driver.app.screen is main:
                await driver.pilot.press("alt+w")
                await driver.until(lambda: it.is_open)
            elif not it.is_open:
                await driver.pilot.press("escape")  # a dialog that an entry led to
            else:
                key = chance.choice(KEYS)
                await driver.pilot.press(key)
                if chance.random() < 0.7:
                    await it.settle()
            if main.editor.text != texts[-1]:
                texts.append(main.editor.text)
        await it.settle()
        assert driver.app._exception is None
        for text in texts:
            assert Session(text, two, environ={}).diagnostics == ()
        # Each finish is one step to undo.
        for text in reversed(texts[:-1]):
            main.editor.undo()
            assert main.editor.text == text
