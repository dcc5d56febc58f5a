"""The editor of a program."""

from __future__ import annotations

from typing import TypeAlias

from textual.widget import Widget

from . import base
from .coding import CodingActions
from .editing import EditingActions
from .finding import FindingActions
from .moving import MovingActions
from .view import EditorView


class ProgramEditor(MovingActions, EditingActions, FindingActions, CodingActions):
    """Edits the text of a session, which stays the only owner of the text and of its tree.

    It posts `Changed` after an edit and `CursorMoved` after a move. It never asks the session
    what the program means while keys come in: whoever does, tells it by `set_diagnostics`.
    All edits go through this widget.
    """

    Changed: TypeAlias = base.Changed
    CursorMoved: TypeAlias = base.CursorMoved

    def on_editor_view_typed(self, message: EditorView.Typed) -> None:
        """Write what was typed or pasted."""
        message.stop()
        if message.is_paste:
            self.insert_text(message.text)
        else:
            self.type_text(message.text)

    def focus(self, scroll_visible: bool = True) -> Widget:  # type: ignore[override]
        """Give the text the focus."""
        return self.view.focus(scroll_visible)
