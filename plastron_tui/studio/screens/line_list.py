"""Lines of a text, to go to one of them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import ClassVar

from textual import on
from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Vertical
from textual.widgets import Label, OptionList
from textual.widgets.option_list import Option

from plastron_tui.diagnostics.terminal import visible

from .dialog import Dialog


class LineList(Dialog[int]):
    """Lists lines; the result is the number of the one to go to, -1 for none."""

    BINDINGS: ClassVar[list[BindingType]] = [Binding("escape", "cancel", "Cancel")]

    def __init__(self, title: str, lines: Sequence[tuple[int, str]], here: int = 0) -> None:
        """Make the list.

        Args:
            title: what the lines have in common.
            lines: the number of each line, 0 for the text as a whole, and what is shown of it.
            here: which of them is the one at hand.
        """
        super().__init__()
        self._title = title
        self._rows = lines
        self._here = here

    def compose(self) -> ComposeResult:
        """Make the list."""
        digits = len(str(max(number for number, _ in self._rows)))
        with Vertical(id="dialog"):
            yield Label(visible(self._title), id="dialog-title", markup=False)
            rows = (f"{number or '':>{digits}}  {visible(text)}" for number, text in self._rows)
            yield OptionList(*map(Option, rows), id="dialog-places", compact=True, markup=False)
            yield Label("Enter goes there, Esc closes", id="dialog-keys")

    def on_mount(self) -> None:
        """Let the keys go to the list, and begin at the cursor's line."""
        lines = self.query_one(OptionList)
        lines.highlighted = self._here
        lines.focus()

    @on(OptionList.OptionSelected)
    def chosen(self, event: OptionList.OptionSelected) -> None:
        """Take a line."""
        self.dismiss(event.option_index)

    def action_cancel(self) -> None:
        """Take none."""
        self.dismiss(-1)
