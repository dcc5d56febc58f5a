"""Listing where something is used, and going to one of the places."""

from __future__ import annotations

from typing import TYPE_CHECKING

from textual.screen import Screen

from plastron_tui.diagnostics import counted

from ..editor.uses import lines_of, uses_at
from ..screens.line_list import LineList

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
    title = f"{uses.name}: {counted(len(lines), 'line')}"
    shown = [(line.number, line.text) for line in lines]
    chosen = await screen.app.push_screen_wait(LineList(title, shown, here))
    if chosen >= 0:
        editor.go_to(lines[chosen].place.start)
    editor.focus()
