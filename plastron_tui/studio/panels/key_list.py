"""The keys of where one is, at the side of the text."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import ClassVar

from rich.cells import cell_len
from textual.binding import Binding, BindingType

from .log_view import LogView
from .styles import Line, Lines, Piece

Row = tuple[str, str]
"""A key and what it does."""


def key_lines(groups: Iterable[tuple[str, Sequence[Row]]]) -> Lines:
    """Return keys under headings, those that have any."""
    kept = [(heading, [row for row in rows if row[0]]) for heading, rows in groups]
    width = max((cell_len(key) for _, rows in kept for key, _ in rows), default=0)
    lines: list[Line] = []
    for heading, rows in kept:
        if rows:
            lines.append((Piece(heading, "primary"),))
            lines += [
                (Piece(f" {' ' * (width - cell_len(key))}{key}  ", "accent"), Piece(what))
                for key, what in rows
            ]
            lines.append(())
    return tuple(lines[:-1])


class KeyList(LogView):
    """Shows keys; those of what has the focus come first, and change with it."""

    DEFAULT_CSS = """
    #key-list {
        height: 100%; overflow-x: hidden; max-width: 60%; border: round $foreground 25%;
        border-title-color: $foreground; border-subtitle-color: $foreground 80%;
    }
    #key-list:focus { border: round $accent; }
    """
    BINDINGS: ClassVar[list[BindingType]] = [Binding("escape", "screen.keys", "Close")]

    def __init__(self, make: Callable[[], Lines], close_key: str) -> None:
        """Make the list.

        Args:
            make: makes the lines for what has the focus now.
            close_key: the key that takes the list away.
        """
        super().__init__(make(), id="key-list")
        self._make = make
        self.border_title = "Keys"
        self.border_subtitle = f"{close_key} closes" if close_key else ""

    def on_mount(self) -> None:
        """Follow the focus."""
        self.screen.bindings_updated_signal.subscribe(self, lambda _: self._follow())

    def _follow(self) -> None:
        """Show the keys of what has the focus, unless that is the list itself."""
        if self.is_attached and not self.has_focus:
            self.show(self._make())
