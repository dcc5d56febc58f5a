"""In small windows everything is reachable: what has the focus is in sight."""

from __future__ import annotations

from pathlib import Path

import pytest
from machine import mostly_long
from studio_driver import Driver, studio
from textual.geometry import Region

from plastron_tui.studio.panels.registry import PANELS
from plastron_tui.studio.panels.styles import Piece
from plastron_tui.studio.screens.failure import Failure
from plastron_tui.studio.screens.question import Prompt, Question
from plastron_tui.studio.screens.tour import STEPS, Tour

ACTIONS = {
    "open": "ChooseFile",
    "save_as": "ChooseFile",
    "help(False)": "Help",
    "generate": "GenerateDialog",
    "menu": "ActionMenu",
    "wizard": "Wizard",
    "welcome": "Welcome",
    "tour": "Tour",
}
LINES = tuple((Piece(f"+ line {number}", "added"),) for number in range(40))
ANSWERS = [("cancel", "Cancel"), ("overwrite", "Overwrite it"), ("keep", "Keep a copy")]


async def check(driver: Driver, name: str) -> None:
    """Give all that takes keys on the screen in front the focus, one after the other."""
    screen = driver.app.screen
    window = Region(0, 0, *driver.app.size)
    for box in screen.query("#dialog, #menu, #welcome, #tour"):
        assert window.contains_region(box.region), f"{name}: {box} is at {box.region}"
    # The first page of the wizard gives the focus when it is filled.
    await driver.until(lambda: screen.focused is not None or not screen.focus_chain)
    first = screen.focused
    for _ in range(20):
        focused = screen.focused
        if focused is not None:
            # What scrolls with others is in sight now; what scrolls itself has its place.
            region = focused.region
            seen = region.intersection(window)
            assert seen.area and seen.height >= min(1, region.height), f"{name}: {focused} {region}"
            assert region.width <= window.width, f"{name}: {focused} {region}"
        await driver.pilot.press("tab")
        await driver.pilot.pause()
        if driver.app.screen is not screen or screen.focused is first:
            break


@pytest.mark.parametrize("size", mostly_long([(50, 12), (60, 20)], [(50, 12)]))
async def test_everything_is_reachable(program: Path, size: tuple[int, int]) -> None:
    async with studio(program, size) as driver:
        app, main = driver.app, driver.main
        for panel in PANELS:
            await driver.show(panel.name)
            dock = main.dock_layout.dock_of(panel.name)
            assert dock.panel.region.height >= 2, f"{panel.name}: {dock.panel.region}"
            assert dock.panel.region.width == size[0]
            tabs = dock.strip.render_line(0).text
            assert panel.title in tabs or (panel.short and panel.short in tabs)
            assert tabs.startswith("‹") or PANELS[0].title in tabs
            assert tabs.endswith("›") or PANELS[-1].title in tabs
            # The text is still there beside it, or Esc brings it back.
            await driver.press("escape")
            assert main.editor.view.has_focus
            assert main.editor.view.region.height >= 4
        for action, dialog in ACTIONS.items():
            await app.run_action(action, main)
            await driver.dialog(dialog)
            await check(driver, action)
            if isinstance(app.screen, Tour):
                for step in STEPS[1:]:
                    await driver.pilot.press("right")
                    await driver.pilot.pause()
                    await check(driver, step.title)
            while app.screen is not main:
                app.pop_screen()
                await driver.pilot.pause()
        for screen in (
            Question("Overwrite what is on the disk?", ANSWERS, text="long " * 60, lines=LINES),
            Prompt("A name", text="long " * 60),
            Failure("report\n" * 50, program),
        ):
            app.push_screen(screen)
            await driver.dialog(type(screen).__name__)
            await check(driver, type(screen).__name__)
            app.pop_screen()
            await driver.pilot.pause()
