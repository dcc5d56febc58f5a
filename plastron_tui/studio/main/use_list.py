"""Listing where something is used, and going to one of the places."""

from __future__ import annotations

from typing import TYPE_CHECKING

from textual.screen import Screen

from ..editor.uses import lines_of, uses_at
from ..screens.uses import UseList

if TYPE_CHECKING:
    from ..editor import ProgramEditor


async def choose_use(screen: Screen[None], editor: ProgramEditor) -> None:
    """List the lines with what is at the editor's cursor, and go to the one that is chosen."""
    offset = editor.cursor_offset
    uses = uses_at(editor.session.document, offset, editor.completer.names.loaded_with)
    if uses is None:
        editor.warn("nothing under the cursor is used anywhere")
        return
    lines = lines_of(editor.text, uses.places)
    row = editor.state.row + 1
    here = next((at for at, line in enumerate(lines) if line.number >= row), 0)
    chosen = await screen.app.push_screen_wait(UseList(uses.name, lines, here))
    if chosen >= 0:
        editor.go_to(lines[chosen].place.start)
    editor.focus()
