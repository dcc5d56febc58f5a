"""Frames show which part has the focus; small windows spend no cell on them."""

from __future__ import annotations

from pathlib import Path

from studio_driver import studio
from textual.pilot import Pilot
from textual.widget import Widget

from plastron_tui.studio.app import StudioApp
from plastron_tui.studio.panels.dock import Edge


def colour(widget: Widget) -> str:
    """Return the colour of the frame's line at the upper left corner of a dock's tabs."""
    segment = next(each for each in widget.render_line(0) if "─" in each.text)
    assert segment.style is not None and segment.style.color is not None
    return segment.style.color.name


def lit_in(strip: Widget) -> tuple[str, str, str]:
    """Return the text of tabs that is filled with a colour, and what is before and behind it."""
    drawn = list(strip.render_line(0))
    lit = [at for at, each in enumerate(drawn) if each.style is not None and each.style.reverse]
    first, end = (lit[0], lit[-1] + 1) if lit else (0, 0)
    parts = (drawn[:first], drawn[first:end], drawn[end:])
    before, filled, behind = ("".join(each.text for each in part) for part in parts)
    assert len({each.style for each in parts[1]}) <= 1
    return before, filled, behind


async def resize(pilot: Pilot[None], app: StudioApp, columns: int, rows: int) -> None:
    await pilot.resize_terminal(columns, rows)
    await pilot.pause()
    assert app.size == (columns, rows)


async def test_frames_show_the_focus_and_go_where_room_is_short(program: Path) -> None:
    async with studio(program, (160, 45)) as driver:
        main = driver.main
        outline, _, bottom = main.dock_layout.docks
        edge = main.query_one("#outline-edge", Edge)
        quiet = colour(outline.strip)
        # The side next to the editor is the edge that can be dragged: no column is spent twice.
        assert outline.strip.render_line(0).text.startswith("╭─ Nodes")
        assert [edge.render_line(y).text for y in (0, 1, edge.size.height - 1)] == list("╮│╯")
        assert outline.panel.region.width == outline.region.width - 1
        assert bottom.strip.render_line(0).text.endswith("─╮")
        assert bottom.panel.region.right == bottom.region.right - 1
        assert main.editor.styles.border_top[0] == "round"
        editor_lit = main.editor.styles.border_top[1]
        await driver.show("nodes")
        assert colour(outline.strip) != quiet
        assert colour(bottom.strip) == quiet
        assert edge.has_class("-focused")
        assert main.editor.styles.border_top[1] != editor_lit
        await driver.press("escape")
        assert colour(outline.strip) == quiet
        await resize(driver.pilot, driver.app, 80, 24)
        dock = main.dock_layout.front
        assert dock.strip.render_line(0).text.startswith(" Nodes")
        assert dock.panel.region.width == 80
        assert dock.panel.region.height == dock.region.height - 1
        assert main.editor.view.region.width == 80
        # The name that is filled with a colour touches no other one, and its count is part of it.
        await driver.show("messages")
        await driver.until(lambda: lit_in(dock.strip)[1])
        assert lit_in(dock.strip)[:2] == (" Nodes Topics Services ", "Messages")
        await resize(driver.pilot, driver.app, 160, 45)
        await driver.show("topics")
        await driver.until(lambda: "Topics" in lit_in(outline.strip)[1])
        before, lit, behind = lit_in(outline.strip)
        assert before.endswith(" ") and lit == "Topics 1"
        assert behind.startswith(" ")
