"""The line below a panel in which words are typed that have to be in what it shows."""

from __future__ import annotations

from collections.abc import Callable
from typing import ClassVar

from textual import on
from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Horizontal
from textual.widgets import Input, Label


class FilterBar(Horizontal):
    """A field for words, and how much has them."""

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("escape", "close", "Show all"),
        Binding("enter,down,up", "keep", "Back to the lines"),
    ]

    def __init__(
        self,
        panel: str,
        placeholder: str,
        on_words: Callable[[tuple[str, ...]], object],
        leave: Callable[[], object],
    ) -> None:
        """Make the line.

        Args:
            panel: the name of the panel, which its ids begin with.
            placeholder: what is seen in the empty field.
            on_words: called with the words, in lower case, when they have changed.
            leave: gives the focus back to the panel.
        """
        super().__init__(id=f"{panel}-filter", classes="panel-filter")
        self._on_words, self._leave = on_words, leave
        self.field = Input(id=f"{panel}-words", compact=True, placeholder=placeholder)
        self._count = Label("", id=f"{panel}-count")

    def compose(self) -> ComposeResult:
        """Make the field, and what it found."""
        yield Label("filter")
        yield self.field
        yield self._count

    def ask(self) -> None:
        """Have words typed."""
        self.display = True
        self.screen.set_focus(self.field)
        self.field.select_all()

    def say(self, shown: int, there: int) -> None:
        """Say how much is shown of how much."""
        self._count.update(f"{shown:,} of {there:,}")

    @on(Input.Changed)
    def words_changed(self, message: Input.Changed) -> None:
        """Tell the words."""
        message.stop()
        self._on_words(tuple(message.value.lower().split()))

    @on(Input.Submitted)
    def words_taken(self, message: Input.Submitted) -> None:
        """Go back to what was found."""
        message.stop()
        self.action_keep()

    def action_close(self) -> None:
        """Show all again."""
        self.field.value = ""
        self.display = False
        self.action_keep()

    def action_keep(self) -> None:
        """Go back to the panel."""
        self._leave()
