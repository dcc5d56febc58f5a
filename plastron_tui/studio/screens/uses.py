"""The lines of the program on which something is used, to go to one of them."""

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
from plastron_tui.diagnostics.wording import counted

from ..editor.uses import UseLine
from .dialog import Dialog


class UseList(Dialog[int]):
    """Lists lines; the result is the number of the one to go to, -1 for none."""

    BINDINGS: ClassVar[list[BindingType]] = [Binding("escape", "cancel", "Cancel")]

    def __init__(self, name: str, lines: Sequence[UseLine], here: int) -> None:
        """Make the list.

        Args:
            name: what is used on the lines.
            lines: the lines.
            here: the number of the one that the cursor is on.
        """
        super().__init__()
        self._used = name
        self._rows = lines
        self._here = here

    def compose(self) -> ComposeResult:
        """Make the list."""
        digits = len(str(self._rows[-1].number))
        title = f"{visible(self._used)}: {counted(len(self._rows), 'line')}"
        with Vertical(id="dialog"):
            yield Label(title, id="dialog-title", markup=False)
            yield OptionList(
                *(Option(f"{each.number:>{digits}}  {visible(each.text)}") for each in self._rows),
                id="dialog-places", compact=True, markup=False,
            )  # fmt: skip
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
