"""What is drawn again is what would be drawn if all were, and asks fewer widgets."""

from __future__ import annotations

from pathlib import Path
from random import Random

import pytest
from rich.console import Console
from studio_driver import studio
from textual import events
from textual._compositor import Compositor
from textual.geometry import Region, Size
from textual.screen import Screen

from plastron_tui.studio.main.screen import MainScreen
from plastron_tui.studio.sparing_compositor import draw_sparingly


def regions(random: Random, width: int, height: int) -> set[Region]:
    """Return what may have changed on a screen of a size."""
    found = set()
    for _ in range(random.randint(1, 5)):
        x, y = random.randrange(-2, width), random.randrange(-2, height)
        found.add(Region(x, y, random.randint(1, width), random.choice((1, 1, 2, height))))
    return {each for part in found if (each := part.intersection(Region(0, 0, width, height)))}


def drawn(compositor: Compositor, changed: set[Region], *, plain: bool) -> str:
    """Return what goes to the terminal."""
    compositor._dirty_regions = set(changed)
    update = (Compositor if plain else type(compositor)).render_partial_update(compositor)
    assert update is not None
    return update.render_segments(Console())


async def test_what_has_changed_is_drawn_as_with_all_around_it(program: Path) -> None:
    random = Random(7)
    async with studio(program, (100, 30)) as driver:
        compositor = driver.main._compositor
        for focus in ("editor", "problems"):
            if focus != "editor":
                await driver.show(focus)
            for _ in range(150):
                changed = regions(random, 100, 30)
                if changed:
                    sparing = drawn(compositor, changed, plain=False)
                    assert sparing == drawn(compositor, changed, plain=True), changed


async def test_what_is_behind_is_not_asked(program: Path) -> None:
    async with studio(program, (100, 30)) as driver:
        compositor, view = driver.main._compositor, driver.main.editor.view
        region, clip = compositor.visible_widgets[view]
        line = region.intersection(clip).crop_size((100, 1))
        compositor._changed = (line,)
        assert [each[0] for each in compositor._get_renders(line)] == [region]
        compositor._changed = ()


async def test_the_first_frame_is_drawn_as_a_whole_once(
    program: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    drawn: list[Compositor] = []
    sizes: list[Size] = []

    def draw(compositor: Compositor, simplify: bool = False) -> object:
        drawn.append(compositor)
        return whole(compositor, simplify=simplify)

    def lay_out(screen: MainScreen, size: Size) -> None:
        sizes.append(size)
        resized(screen, size)

    whole, resized = Compositor.render_full_update, MainScreen._screen_resized
    monkeypatch.setattr(MainScreen, "_screen_resized", lay_out)
    monkeypatch.setattr(Compositor, "render_full_update", draw)
    async with studio(program, (100, 30)) as driver:
        assert drawn == [driver.main._compositor]
        size = driver.app.size
        sizes.clear()
        driver.main.post_message(events.Resize(size, size))
        await driver.pilot.pause()
        assert sizes == []
        await driver.pilot.resize_terminal(90, 20)
        assert Size(90, 20) in sizes


def test_a_screen_that_is_put_together_otherwise_is_left_alone() -> None:
    screen = Screen[None]()
    other = screen._compositor = object()  # type: ignore[assignment]
    draw_sparingly(screen)
    assert screen._compositor is other
