"""The editor of a program."""

from __future__ import annotations

from typing import TypeAlias

from textual.app import ComposeResult
from textual.widget import Widget

from . import base
from .coding import CodingActions
from .editing import EditingActions
from .finding import FindingActions
from .moving import MovingActions


class ProgramEditor(MovingActions, EditingActions, FindingActions, CodingActions):
    """Edits the text of a session, which stays the only owner of the text and of its tree.

    It posts `Changed` after an edit and `CursorMoved` after a move. It never asks the session
    what the program means while keys come in: whoever does, tells it by `set_diagnostics`.
    All edits go through this widget.
    """

    Changed: TypeAlias = base.Changed
    CursorMoved: TypeAlias = base.CursorMoved

    def compose(self) -> ComposeResult:
        """Make the parts, and be told of keys and of the mouse."""
        self.view.owner = self
        yield from super().compose()

    def typed(self, text: str) -> None:
        """Write what was typed."""
        self.type_text(text)

    def pasted(self, text: str) -> None:
        """Write what was pasted."""
        self.insert_text(text)

    def selected(self, anchor: int, head: int) -> None:
        """Select what the mouse selected."""
        self.state.select(anchor, head)
        self.done()

    def picked(self) -> None:
        """Take the entry that the mouse picked."""
        self.accept()

    def focus(self, scroll_visible: bool = True) -> Widget:  # type: ignore[override]
        """Give the text the focus."""
        return self.view.focus(scroll_visible)
