"""The choice of colours: each theme is seen while the mark is on it."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any, ClassVar

from textual import events, on
from textual.app import App, ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Vertical
from textual.widgets import Label, OptionList
from textual.widgets.option_list import Option

from ..delay import Delay
from .dialog import Dialog

_AROUND = 4
"""Rows around the list: the frame, the title, the keys."""

_REST = 0.15
"""Seconds that the mark rests on a theme before it is put on: to draw all anew takes its time."""


class ThemeMenu(Dialog[str]):
    """Offers the themes; the result is the one that was chosen, or the one before."""

    BINDINGS: ClassVar[list[BindingType]] = [Binding("escape", "cancel", "Cancel")]
    AUTO_FOCUS = "#theme-list"

    def __init__(self, names: list[str], present: str, put_on: Callable[[str], object]) -> None:
        """Make the menu.

        Args:
            names: the names of the themes, in their order.
            present: the one that is on.
            put_on: puts a theme on, by its name.
        """
        super().__init__()
        self._names = names
        self._present = present
        self._put_on = put_on
        self._pause = Delay(self, self._preview)

    def compose(self) -> ComposeResult:
        """Make the list, with a sign at the theme that is on."""
        options = [
            Option(f"{'●' if name == self._present else ' '} {name}") for name in self._names
        ]
        with Vertical(id="themes"):
            yield Label("Theme", id="dialog-title")
            yield OptionList(*options, id="theme-list", compact=True, markup=False)
            yield Label("Enter takes it, Esc goes back", id="dialog-keys")

    def on_resize(self, event: events.Resize) -> None:
        """Give the list the rows that there are."""
        super().on_resize(event)
        self.query_one(OptionList).styles.max_height = max(1, event.size.height - _AROUND)

    def on_mount(self) -> None:
        """Put the mark on the theme that is on."""
        if self._present in self._names:
            self.query_one(OptionList).highlighted = self._names.index(self._present)

    @on(OptionList.OptionHighlighted)
    def marked(self) -> None:
        """Show the theme as soon as the mark rests."""
        self._pause.start(_REST)

    def _preview(self) -> None:
        at = self.query_one(OptionList).highlighted
        if at is not None:
            self._put_on(self._names[at])

    def on_key(self, event: events.Key) -> None:
        """Go to the next theme that starts with a letter."""
        letter = (event.character or "").lower()
        options = self.query_one(OptionList)
        start = (options.highlighted or 0) + 1
        for step in range(len(self._names)):
            at = (start + step) % len(self._names)
            if letter.isalpha() and self._names[at].startswith(letter):
                options.highlighted = at
                event.stop()
                return

    @on(OptionList.OptionSelected)
    def chosen(self, event: OptionList.OptionSelected) -> None:
        """Take the theme."""
        self._pause.stop()
        self.dismiss(self._names[event.option_index])

    def action_cancel(self) -> None:
        """Put the theme on again that was on before."""
        self._pause.stop()
        self.dismiss(self._present)


def choose_theme(
    app: App[Any], before: str | None, remember: Callable[[str | None], object]
) -> None:
    """Ask for a theme, and put it on.

    Args:
        app: the app.
        before: the theme that is remembered.
        remember: remembers a theme for the next start: none of those that were only looked at.
    """
    present = app.theme

    def put_on(name: str) -> None:
        app.theme = name

    def taken(name: str | None) -> None:
        put_on(name or present)
        remember(before if name in (None, present) else name)

    app.push_screen(ThemeMenu(list(_names(app)), present, put_on), taken)


def _names(app: App[Any]) -> Iterator[str]:
    """Yield the names of the themes, the dark ones first."""
    themes = sorted(app.available_themes.values(), key=lambda each: (not each.dark, each.name))
    return (theme.name for theme in themes)
