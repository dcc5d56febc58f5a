"""What the mouse does: it is never needed, and does what one expects of it."""

from __future__ import annotations

from pathlib import Path

import pytest
from studio_driver import PROGRAM, SIZES, Driver, studio
from textual import events
from textual.geometry import Offset

from plastron_tui.studio.panels.dock import Edge, TabStrip
from plastron_tui.studio.panels.key_bar import KeyBar


async def click(driver: Driver, widget: object, x: int, y: int = 0) -> None:
    await driver.pilot.click(widget, offset=Offset(x, y))  # type: ignore[arg-type]
    await driver.settle()


def line(driver: Driver, widget: object) -> str:
    return str(widget.render_line(0).text)  # type: ignore[attr-defined]


async def drag(driver: Driver, widget: object, x: int, y: int) -> None:
    """Press the mouse on a widget, and let it go at a place of the screen."""
    await driver.pilot.mouse_down(widget)  # type: ignore[arg-type]
    await driver.pilot.hover(offset=Offset(x, y))
    await driver.pilot.mouse_up(offset=Offset(x, y))
    await driver.settle()


@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("title", ["Topics", "Messages", "Services"])
async def test_a_tab_is_clicked(program: Path, size: tuple[int, int], title: str) -> None:
    async with studio(program, size) as driver:
        strip = driver.main.dock_layout.outline.strip
        await click(driver, strip, line(driver, strip).index(title) + 1)
        assert driver.main.dock_layout.is_in_sight(title.lower())
        assert driver.main.panels[title.lower()].has_focus


@pytest.mark.parametrize("size", SIZES)
async def test_an_entry_is_clicked_and_its_sign_folds_it(
    program: Path, size: tuple[int, int]
) -> None:
    async with studio(program, size) as driver:
        nodes = driver.main.panels["nodes"]
        await click(driver, nodes, 8, 3)
        assert driver.main.editor.cursor_offset == PROGRAM.index("subscribe")
        await click(driver, nodes, 1, 0)
        assert len(driver.shown("nodes")) == 3
        await click(driver, nodes, 1, 0)
        assert len(driver.shown("nodes")) == 4


@pytest.mark.parametrize("size", SIZES)
async def test_a_key_of_the_footer_is_clicked(program: Path, size: tuple[int, int]) -> None:
    async with studio(program, size) as driver:
        bar = driver.main.query_one(KeyBar)
        await driver.pilot.click(bar, offset=Offset(line(driver, bar).index("Generate"), 0))
        await driver.dialog("GenerateDialog")


async def test_the_edges_of_the_docks_are_dragged(program: Path) -> None:
    async with studio(program, (200, 60)) as driver:
        main = driver.main
        left, right = main.query_one("#outline-edge", Edge), main.query_one("#result-edge", Edge)
        await drag(driver, left, 50, 10)
        assert main.dock_layout.outline.size.width == 50
        await drag(driver, right, 120, 10)
        assert main.dock_layout.result.size.width == 79
        await drag(driver, main.dock_layout.bottom.query_one(TabStrip), 90, 30)
        assert abs(main.dock_layout.bottom.region.y - 30) <= 1


async def test_the_wheel_scrolls_a_panel_that_has_no_focus(program: Path) -> None:
    program.write_text("".join(f"create_node 'n{at}' as n{at}\n" for at in range(60)))
    async with studio(program) as driver:
        nodes = driver.main.panels["nodes"]
        assert nodes.scroll_offset.y == 0
        await driver.pilot._post_mouse_events([events.MouseScrollDown], nodes, offset=(5, 5))
        await driver.settle()
        assert nodes.scroll_offset.y > 0
        assert driver.main.editor.view.has_focus
