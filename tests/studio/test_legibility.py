"""What is to be read can be read: every pair of colours, in every theme."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as some
from machine import mostly_long
from rich.segment import Segment
from rich.style import Style
from studio_driver import PROGRAM, Driver, studio
from textual.color import Color
from textual.theme import BUILTIN_THEMES

from plastron_tui.studio.editor.palette import themed_palette
from plastron_tui.studio.legibility import LEAST, LEGIBLE, contrast, legible, legible_style

COLORS = some.tuples(*[some.integers(0, 255)] * 3).map(lambda parts: Color(*parts))
BLACK, WHITE = Color(0, 0, 0), Color(255, 255, 255)


def test_contrast_is_that_of_wcag() -> None:
    assert contrast(BLACK, WHITE) == pytest.approx(21)
    assert contrast(WHITE, Color.parse("#777777")) == pytest.approx(4.48, abs=0.01)


@given(COLORS, COLORS)
def test_any_text_can_be_read_on_any_background(front: Color, back: Color) -> None:
    moved = legible(front, back)
    assert contrast(moved, back) >= LEAST
    assert moved == front or contrast(front, back) < LEAST
    style = Style(color=front.rich_color, bgcolor=back.rich_color, bold=True)
    for each in (style, style + Style(reverse=True)):
        read = legible_style(each, BLACK) or each
        colors = [Color.from_rich_color(color) for color in (read.color, read.bgcolor)]
        assert contrast(*colors) >= LEAST
        assert read.bold and read.reverse == each.reverse


def test_the_editor_can_be_read_in_every_theme() -> None:
    for name, theme in BUILTIN_THEMES.items():
        variables = theme.to_color_system().generate()
        front, back = (Color.parse(variables[each]) for each in ("foreground", "background"))
        palette = themed_palette(variables, front, back)
        looks = [palette.text + look for look in (*palette.captures.values(), palette.gutter)]
        looks += [palette.selection, palette.cursor, palette.popup, palette.popup_quiet]
        for look in (*looks, palette.popup_here):
            assert theme.ansi or legible_style(look, back) is None, (name, look)


def test_the_terminals_own_colours_stay_its_own() -> None:
    cyan_on_white = Style(color="cyan", bgcolor="white")
    assert legible_style(cyan_on_white, BLACK) == cyan_on_white + Style(color="black")
    yellow_on_blue = Style(color="blue", bgcolor="black")
    assert legible_style(yellow_on_blue, WHITE) == yellow_on_blue + Style(color="bright_white")
    for known_to_the_terminal in (Style(color="cyan"), Style(color="default", bgcolor="default")):
        unknown = Color.parse("ansi_default")
        assert legible_style(known_to_the_terminal, unknown) is None


@pytest.mark.parametrize(
    ("back", "color"),
    [
        ("white", "black"),
        ("black", "bright_white"),
        ("blue", "bright_white"),
        ("#ffff00", "#000000"),
    ],
)
@pytest.mark.parametrize("front", [None, "default"])
def test_letters_of_the_terminals_own_colour_are_on_its_own_ground_alone(
    back: str, color: str, front: str | None
) -> None:
    unknown = Color.parse("ansi_default")
    style = Style(color=front, bgcolor=back)
    assert legible_style(style, unknown) == style + Style(color=color)


def test_what_is_not_read_keeps_its_colour() -> None:
    faint = Style(color="#202020", bgcolor="#000000")
    line = [Segment(text, faint) for text in ("a", "─│", "■ ", "⣿", "  ", "×37")]
    done = LEGIBLE.apply(line, BLACK)
    assert [each.style is faint for each in done] == [False, True, True, True, True, False]
    assert [each.text for each in done] == [each.text for each in line]


def pale(driver: Driver) -> Iterator[tuple[str, str, float]]:
    """Yield what is on the screen with less contrast than it takes to read it."""
    for strip in driver.app.screen._compositor.render_strips():
        for text, style, _ in strip:
            if not (style and style.color and style.bgcolor and any(map(str.isalnum, text))):
                continue
            if style.color.triplet and style.bgcolor.triplet:
                found = contrast(*map(Color.from_rich_color, (style.color, style.bgcolor)))
                if found < LEAST:
                    yield text.strip(), str(style), round(found, 2)


THEMES = [name for name, theme in BUILTIN_THEMES.items() if not theme.ansi]


PALE = ["solarized-light"]


@pytest.mark.parametrize("themes", mostly_long([PALE, THEMES], ["1"], lambda each: str(len(each))))
async def test_every_screen_can_be_read_in_every_theme(themes: list[str], program: Path) -> None:
    program.write_text(PROGRAM + "subscrib listener\nsubscribe listener to 'scan' of message_type ")
    async with studio(program, (120, 40)) as driver:

        async def look() -> None:
            await driver.pilot.pause()
            for name in themes:
                driver.app.theme = name
                await driver.pilot.pause()
                assert list(pale(driver)) == [], (name, type(driver.app.screen).__name__)

        driver.app.notify("a message in the corner", severity="warning", timeout=1000)
        await driver.press("ctrl+end", "ctrl+space")
        assert driver.main.editor.popup.is_open
        await look()
        await driver.press("escape", "shift+up")
        await look()
        await driver.press("x")
        await driver.pilot.press("ctrl+q")
        await driver.dialog("Question")
        await look()
        await driver.press("escape")
        await driver.back()
        await driver.pilot.press("ctrl+u")
        screen = await driver.dialog("Wizard")
        await driver.until(lambda: screen.is_settled)
        await driver.press("down")
        await look()
        await driver.press("up", "enter")
        await driver.until(lambda: screen.is_settled)
        await look()
