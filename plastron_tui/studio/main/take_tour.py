"""The tour, as the main screen takes it."""

from __future__ import annotations

from textual.geometry import Region
from textual.screen import Screen

from .active_program import ActiveProgram
from .dock_layout import DockLayout
from .file_actions import FileActions


async def take_tour(
    screen: Screen[None], program: ActiveProgram, files: FileActions, layout: DockLayout
) -> None:
    """Take the tour, with a recipe when there is no text."""
    from ..recipes import recipes
    from ..screens.tour import Tour

    def region_of(panel: str | None) -> Region:
        """Return where a panel is, or the editor."""
        return (program.editor if panel is None else layout.dock_of(panel)).region

    if not program.text.strip():
        for recipe in recipes()[:1]:
            await files.take_recipe(recipe)
    await screen.app.push_screen_wait(Tour(layout.bring, region_of))
    program.editor.focus()
