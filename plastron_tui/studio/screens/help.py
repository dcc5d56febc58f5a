"""Help: what the part with the focus is for, its keys, and all actions."""

from __future__ import annotations

from collections.abc import Iterable
from typing import ClassVar

from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Vertical
from textual.widgets import Label

from plastron_tui.language import DECLARATIONS

from ..actions import grouped
from ..panels.registry import PANELS
from ..panels.styles import Line, Lines, Piece
from ..panels.text_view import TextView
from .dialog import Dialog

ABOUT = {
    "editor": ("The editor", "One statement a line. While you type, a list offers what can stand "
               "there: Tab takes it, Esc closes it. F1 says what the word at the cursor means, "
               "and so does the mouse when it rests on one. A problem is underlined, with its "
               "message beside it."),
    **{panel.name: (panel.title, panel.about) for panel in PANELS},
}  # fmt: skip
"""What each part is for, by its id."""


class Help(Dialog[None]):
    """Shows help for the part that has the focus."""

    BINDINGS: ClassVar[list[BindingType]] = [Binding("escape,f1,q", "close", "Close")]
    AUTO_FOCUS = "TextView"

    def __init__(self, part: str, keys: Iterable[tuple[str, str]], actions: Lines) -> None:
        """Make the help.

        Args:
            part: the id of the part that has the focus.
            keys: its keys and what they do.
            actions: the actions of the studio, in lines.
        """
        super().__init__()
        self.title_, self.about = ABOUT.get(part, ABOUT["editor"])
        self._lines: list[Line] = [*self._key_lines(keys)]
        if part == "editor":
            self._lines += [*statement_lines()]
        self._lines += actions

    @staticmethod
    def _key_lines(keys: Iterable[tuple[str, str]]) -> Iterable[Line]:
        rows = list(keys)
        if rows:
            yield (Piece("Keys here", "primary"),)
            for key, what in rows:
                yield (Piece(f"  {key:<13} ", "accent"), Piece(what))
            yield ()

    def compose(self) -> ComposeResult:
        """Make the text."""
        with Vertical(id="dialog", classes="-tall"):
            yield Label(self.title_, id="dialog-title")
            yield Label(self.about, id="dialog-text", markup=False)
            yield TextView(tuple(self._lines), id="dialog-view")
            yield Label("Esc closes", id="dialog-keys")

    def action_close(self) -> None:
        """Close."""
        self.dismiss(None)


def statement_lines() -> Iterable[Line]:
    """Yield the statements of the language, as they are declared."""
    yield (Piece("Statements", "primary"),)
    for declaration in DECLARATIONS.values():
        yield (Piece(f"  {declaration.usage}", "strong"),)
        yield (Piece(f"      {declaration.summary}", "quiet"),)
        yield (Piece(f"      {declaration.example}", "string"),)
    yield ()


def action_lines(keys: Iterable[tuple[str, str]]) -> Lines:
    """Return all actions in lines, under their headings; `keys` has the key of each by its id."""
    of = dict(keys)
    lines: list[Line] = []
    for group, actions in grouped():
        lines.append((Piece(group, "primary"),))
        for action in actions:
            key = of.get(action.id, "")
            what = action.help.rstrip(".")
            lines.append(
                (
                    Piece(f"  {key or 'menu':<18}", "accent" if key else "dim"),
                    Piece(f"{action.title:<28}"),
                    Piece(what, "quiet"),
                )
            )
        lines.append(())
    return tuple(lines)
