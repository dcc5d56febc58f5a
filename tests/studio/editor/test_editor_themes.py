"""The colours of the editor."""

from __future__ import annotations

import pytest
from editor_host import PROGRAM, editing
from textual.color import Color

from plastron_tui.language.grammar import highlights_query
from plastron_tui.studio.editor.palette import ansi_palette
from plastron_tui.studio.legibility import LEAST, contrast


async def test_the_editor_follows_the_theme() -> None:
    async with editing(PROGRAM) as at:
        looks = set()
        for theme in ("textual-dark", "textual-light", "nord", "gruvbox"):
            at.app.theme = theme
            await at.pilot.pause()
            style = at.editor.view.palette.captures["keyword"]
            looks.add((str(style.color), str(at.editor.view.palette.text.bgcolor)))
        assert len(looks) == 4


async def test_all_can_be_read_in_every_theme() -> None:
    async with editing(PROGRAM) as at:
        for theme in at.app.available_themes.values():
            if theme.ansi:
                continue
            at.app.theme = theme.name
            await at.pilot.pause()
            palette = at.editor.view.palette
            looks = dict(palette.captures)
            looks |= {name: getattr(palette, name) for name in ("text", "error", "warning")}
            looks |= {name: getattr(palette, name) for name in ("selection", "popup_quiet")}
            looks |= {name: getattr(palette, name) for name in ("popup", "popup_here", "cursor")}
            for name, look in looks.items():
                whole = palette.text + look
                assert whole.color is not None
                assert whole.bgcolor is not None
                found = contrast(*map(Color.from_rich_color, (whole.color, whole.bgcolor)))
                assert found >= LEAST, (theme.name, name)


async def test_sixteen_colours_are_the_terminals_own() -> None:
    async with editing(PROGRAM) as at:
        at.app.ansi_color = True
        at.editor.view.recolor()
        await at.pilot.pause()
        color = at.editor.view.palette.captures["keyword"].color
        assert color is not None
        assert color.name == "blue"


async def test_without_colours_all_is_told_apart_by_how_it_is_written(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setenv("NO_COLOR", "1")
    async with editing("generate_node a\n") as at:
        await at.understand()
        palette = at.editor.view.palette
        looks = {"text": palette.text, "selection": palette.selection, "match": palette.match}
        looks |= {"error": palette.error_line, "bracket": palette.bracket}
        written = {name: (look.bold, look.underline, look.reverse) for name, look in looks.items()}
        assert written["selection"] != written["match"] != written["text"] != written["error"]
        assert all(look.color is None for look in palette.captures.values())


def test_every_part_of_a_program_has_its_look() -> None:
    """Words that are captured and have no look stay as pale as what is not understood."""
    query = highlights_query()
    captured = {query.capture_name(at) for at in range(query.capture_count)}
    assert captured <= set(ansi_palette().captures)
