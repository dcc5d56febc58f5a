"""Colours: every theme can be read, the editor follows it, and settings last."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from pathlib import Path

import pytest
from rich.style import Style
from studio_driver import PROGRAM, Driver, studio
from textual.color import Color
from textual.widget import Widget

from plastron_tui.studio.config import config_file

LEAST = 2.5
"""The least contrast of text that is to be read, where W3C asks for 3 of large text."""


def luminance(color: Color) -> float:
    parts = [part / 255 for part in (color.r, color.g, color.b)]
    linear = [
        part / 12.92 if part <= 0.03928 else ((part + 0.055) / 1.055) ** 2.4 for part in parts
    ]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def contrast(style: Style) -> float | None:
    """Return the contrast of a style by W3C's definition, None for the terminal's own colours."""
    front, back = style.color, style.bgcolor
    if front is None or back is None or front.triplet is None or back.triplet is None:
        return None
    dark, light = sorted(luminance(Color.from_rich_color(part)) for part in (front, back))
    return (light + 0.05) / (dark + 0.05)


def read(widget: Widget) -> Iterator[tuple[str, Style]]:
    for row in range(widget.size.height):
        for segment in widget.render_line(row):
            if segment.text.strip() and segment.style is not None:
                yield segment.text.strip(), segment.style


@pytest.mark.long
async def test_every_theme_can_be_read_and_the_editor_follows(program: Path) -> None:
    program.write_text(PROGRAM + "subscrib listener\n")
    async with studio(program, (200, 60)) as driver:
        main = driver.main
        for name in driver.app.available_themes:
            driver.app.theme = name
            await driver.settle()
            panels = main.panels
            for widget in (panels["nodes"], panels["problems"], panels["preview"]._view,
                           main.query_one("#title"), main.query_one("#status")):  # fmt: skip
                for text, style in read(widget):
                    found = contrast(style)
                    assert found is None or found >= LEAST, (name, widget, text, found)
            await follows(driver, name)


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
        await driver.until(lambda: "Stop it" in bar.render_line(0).text)
