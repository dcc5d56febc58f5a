"""Help: what the part with the focus is for, its keys, and all actions."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import ClassVar

from textual import events
from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Vertical
from textual.widgets import Label

from ..panels.registry import PANELS
from ..panels.styles import Lines
from ..panels.text_view import TextView
from .dialog import Dialog, text_width
from .help_lines import action_lines, key_lines, statement_lines

ABOUT = {
    "editor": ("The editor", "One statement a line. While you type, a list offers what can stand "
               "there: Tab takes it, Esc closes it. Without a list, Tab completes the word before "
               "the cursor. F1 says what the word at the cursor means, and so does the mouse when "
               "it rests on one. A problem is underlined, with its message beside it."),
    **{panel.name: (panel.title, panel.about) for panel in PANELS},
}  # fmt: skip
"""What each part is for, by its id."""


class Help(Dialog[None]):
    """Shows help for the part that has the focus."""

    BINDINGS: ClassVar[list[BindingType]] = [Binding("escape,f1,q", "close", "Close")]
    AUTO_FOCUS = "TextView"

    def __init__(
        self, part: str, keys: Iterable[tuple[str, str]], actions: Mapping[str, str]
    ) -> None:
        """Make the help.

        Args:
            part: the id of the part that has the focus.
            keys: its keys and what they do.
            actions: the key of each action of the studio, by its id.
        """
        super().__init__()
        self.title_, self.about = ABOUT.get(part, ABOUT["editor"])
        self._has_statements = part == "editor"
        self._keys = list(keys)
        self._actions = actions

    def lines(self, width: int) -> Lines:
        """Return what is shown below the sentences about the part: the keys first."""
        found = [*key_lines(self._keys, width), *action_lines(self._actions, width)]
        if self._has_statements:
            found += statement_lines(width)
        return tuple(found)

    def on_resize(self, event: events.Resize) -> None:
        """Break the lines for another width."""
        super().on_resize(event)
        self.query_one(TextView).show(self.lines(text_width(event.size)))

    def compose(self) -> ComposeResult:
        """Make the text."""
        with Vertical(id="dialog", classes="-tall"):
            yield Label(self.title_, id="dialog-title")
            yield Label(self.about, id="dialog-text", markup=False)
            yield TextView(self.lines(text_width(self.app.size)), id="dialog-view")
            yield Label("Esc closes", id="dialog-keys")

    def action_close(self) -> None:
        """Close."""
        self.dismiss(None)
