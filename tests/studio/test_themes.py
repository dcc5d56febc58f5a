"""The editor follows every theme, and settings last."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from pathlib import Path

import pytest
from rich.style import Style
from studio_driver import PROGRAM, Driver, studio
from textual.color import Color
from textual.theme import BUILTIN_THEMES, Theme
from textual.widget import Widget
from textual.widgets import OptionList

from plastron_tui.studio.config import config_file
from plastron_tui.studio.theme_colours import DEFAULT_THEME, grounds_of, usual_theme


def read(widget: Widget) -> Iterator[tuple[str, Style]]:
    for row in range(widget.size.height):
        for segment in widget.render_line(row):
            if segment.text.strip() and segment.style is not None:
                yield segment.text.strip(), segment.style


@pytest.mark.parametrize("theme", BUILTIN_THEMES.values(), ids=lambda theme: theme.name)
def test_the_text_has_the_brightest_ground_of_a_theme(theme: Theme) -> None:
    colours = theme.to_color_system().generate()
    grounds = grounds_of(colours)
    assert set(grounds) == {colours["background"], colours["surface"]}
    text, panels = map(Color.parse, grounds)
    if not theme.name.startswith("ansi"):
        assert text.brightness >= panels.brightness


def test_a_terminal_of_sixteen_colours_begins_with_them() -> None:
    assert usual_theme({"TERM": "linux"}) == usual_theme({"TERM": "x-16color"}) == "ansi-dark"
    assert usual_theme({"TERM": "linux", "COLORTERM": "truecolor"}) == DEFAULT_THEME
    assert usual_theme({}) == usual_theme({"TERM": "xterm-256color"}) == DEFAULT_THEME


@pytest.mark.long
async def test_the_editor_follows_every_theme(program: Path) -> None:
    async with studio(program, (200, 60)) as driver:
        for name in driver.app.available_themes:
            driver.app.theme = name
            await driver.settle()
            await follows(driver, name)


@pytest.mark.parametrize("name", ["ansi-light", "solarized-light"])
async def test_a_theme_is_drawn_from_the_start_as_after_a_change(program: Path, name: str) -> None:
    config_file().parent.mkdir(parents=True)
    config_file().write_text(f"theme: {name}\n")
    async with studio(program) as driver:
        shown = driver.app.export_screenshot()
        for theme in ("dracula", name):
            driver.app.theme = theme
            await driver.settle()
        assert driver.app.export_screenshot() == shown
        await driver.press("f1", "f1")
        await driver.dialog("Help")


async def follows(driver: Driver, name: str) -> None:
    """See that the editor is dark in a dark theme and light in a light one."""
    theme = driver.app.get_theme(name)
    assert theme is not None
    backs = Counter(
        Color.from_rich_color(style.bgcolor)
        for _, style in read(driver.main.editor.view)
        if style.bgcolor is not None and style.bgcolor.triplet is not None
    )
    if not name.startswith("ansi"):
        [(back, _)] = backs.most_common(1)
        assert (back.brightness < 0.5) == theme.dark


@pytest.mark.parametrize(
    ("action", "key", "focus", "check"),
    [
        ("editor.duplicate", "ctrl+b", "", lambda text: text.count("create_node 'talker'") == 2),
        ("editor.toggle_comment", "f11", "", lambda text: text.startswith("// create_node")),
        ("panel.end", "x", "nodes", lambda text: "stop_publishing" in text),
        ("panel.generate", "ctrl+b", "nodes", lambda text: text.count("generate_node") == 1),
    ],
)
async def test_keys_of_the_editor_and_of_panels_are_remapped(
    program: Path, action: str, key: str, focus: str, check: object
) -> None:
    config_file().parent.mkdir(parents=True)
    config_file().write_text(f"keys:\n  {action}: {key}\n")
    if action == "panel.generate":
        program.write_text(PROGRAM.replace("generate_node talker\n", "")
                           .replace("generate_node listener\n", ""))  # fmt: skip
    async with studio(program) as driver:
        if focus:
            await driver.show(focus)
            await driver.press("home", "down")
        await driver.press(key)
        assert check(driver.text)  # type: ignore[operator]
        assert not driver.notes() or "generated" in driver.notes()


async def test_hidden_panels_and_the_panel_in_front_are_remembered(program: Path) -> None:
    async with studio(program, (80, 24)) as driver:
        driver.main.action_show("graph")
        await driver.settle()
        await driver.press("escape")
        await driver.pilot.press("ctrl+q")
        await driver.until(lambda: driver.app._exit)
    async with studio(program, (80, 24)) as driver:
        assert driver.main.dock_layout.is_in_sight("graph")
        await driver.press("f9")
        await driver.pilot.press("ctrl+q")
        await driver.until(lambda: driver.app._exit)
    async with studio(program, (80, 24)) as driver:
        assert not any(dock.display for dock in driver.main.dock_layout.docks)
        await driver.press("f9")
        assert driver.main.dock_layout.is_in_sight("graph")


async def test_the_footer_shows_the_few_keys_that_matter(program: Path) -> None:
    async with studio(program, (80, 24)) as driver:
        bar = driver.main.query_one("KeyBar")
        assert all(word in bar.render_line(0).text for word in ("F1 Help", "Save", "Ctrl-Q Quit"))
        driver.main.action_show("nodes")
        await driver.settle()
        await driver.until(lambda: "Rename" in bar.render_line(0).text)
        await driver.press("down")
        await driver.until(lambda: "End it" in bar.render_line(0).text)


async def test_a_theme_is_seen_while_it_is_marked_and_goes_with_escape(program: Path) -> None:
    async with studio(program, (80, 24)) as driver:
        app, remembered = driver.app, driver.app.profile.remembered
        before = app.theme
        await driver.pilot.press("alt+t")
        dialog = await driver.dialog("ThemeMenu")
        listed = dialog.query_one(OptionList)
        present = str(listed.get_option_at_index(listed.highlighted).prompt)
        assert present == f"● {before}"
        await driver.pilot.press("n")
        await driver.until(lambda: app.theme == "nord")
        await driver.pilot.press("escape")
        await driver.back()
        assert (app.theme, remembered.theme) == (before, None)
        # Enter takes what is marked, at rest or not.
        await driver.pilot.press("alt+t")
        await driver.dialog("ThemeMenu")
        await driver.pilot.press("n", "enter")
        await driver.back()
        assert (app.theme, remembered.theme) == ("nord", "nord")
