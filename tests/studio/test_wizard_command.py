"""`plastron wizard`: the studio, with the wizard in front."""

from __future__ import annotations

from pathlib import Path

import pytest
from studio_driver import Driver, leave_behind
from test_terminal import Terminal, start
from test_terminal import terminal as terminal

from plastron_tui.studio.app import StudioApp


def test_the_wizard_is_in_front_and_writes_into_the_file(
    terminal: Terminal, tmp_path: Path
) -> None:
    start(terminal, "wizard", "mine.plastron", "--target", "rclpy")
    terminal.wait(lambda screen: "What do you want?" in screen)
    terminal.keys("Enter")
    terminal.wait(lambda screen: "create_node 'talker' as talker" in screen)
    terminal.keys("Escape")
    terminal.wait(lambda screen: "What do you want?" in screen)
    terminal.keys("Escape")
    terminal.wait(lambda screen: "no nodes yet" in screen)
    terminal.keys("C-q")
    terminal.wait_end()
    assert not (tmp_path / "mine.plastron").exists()


@pytest.mark.parametrize("name", [None, "mine.plastron", "mine"])
async def test_there_is_no_welcome_before_it(
    name: str | None, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    app = StudioApp(None if name is None else Path(name), first="wizard")
    async with app.run_test() as pilot:
        driver = Driver(app, pilot)
        await driver.dialog("Wizard")
        assert app.main.open.path == (None if name is None else Path("mine.plastron"))
        await pilot.press("escape")
        await driver.back()


async def test_what_was_not_saved_is_offered_before(tmp_path: Path) -> None:
    path = tmp_path / "mine.plastron"
    path.write_text("// saved\n")
    text = "// saved\n// not saved\n"
    leave_behind(path, text)
    app = StudioApp(path, first="wizard")
    async with app.run_test() as pilot:
        driver = Driver(app, pilot)
        await driver.dialog("Question")
        await pilot.press("enter")
        await driver.dialog("Wizard")
        assert app.main.open.text == text.encode()
