"""What one sees first: recent programs, recipes, the tour."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import ClassVar

from textual import events, on
from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Vertical
from textual.content import Content
from textual.widgets import Label, OptionList, Static
from textual.widgets.option_list import Option

from plastron_tui.diagnostics.terminal import visible

from ..folder_labels import shown_folder, shown_name, shown_place
from ..journal import Kept
from ..recipes import recipes
from .dialog import Dialog

_LOGO = """\
       _           _
 _ __ | | __ _ ___| |_ _ __ ___  _ __
| '_ \\| |/ _` / __| __| '__/ _ \\| '_ \\
| |_) | | (_| \\__ \\ |_| | | (_) | | | |
| .__/|_|\\__,_|___/\\__|_|  \\___/|_| |_|
|_|     ROS nodes, described in sentences"""

_LOGO_ROWS = 7
_FRAME = 3
"""Rows around the list: the border, and the line with the keys."""

Answer = tuple[str, str]

START = (
    ("action", "screen.wizard", "Build nodes with the wizard", "^U"),
    ("action", "screen.new", "Write a new program", "^N"),
    ("action", "screen.open", "Open a program", "^O"),
    ("action", "screen.tour", "Take the two-minute tour", ""),
)
"""What can be started: the kind of answer, its value, its words, its key."""


class Welcome(Dialog["Answer | None"]):
    """Offers what to begin with; the result says what was chosen."""

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("escape", "close", "Start writing"),
        Binding("ctrl+q", "answer('screen.quit')", "Quit"),
        Binding("ctrl+u,alt+w", "answer('screen.wizard')", "Wizard", show=False),
        Binding("ctrl+n", "answer('screen.new')", "New", show=False),
        Binding("ctrl+o", "answer('screen.open')", "Open", show=False),
        Binding("f1", "answer('screen.help(False)')", "Help", show=False),
    ]
    AUTO_FOCUS = "#welcome-list"

    def __init__(self, recent: list[str], kept: Sequence[Kept] = ()) -> None:
        """Make the page.

        Args:
            recent: the files of late, the latest first.
            kept: what was not saved when a studio ended; the answer has its number here.
        """
        super().__init__()
        self._kept = kept[:6]
        self._recent = [name for name in recent if Path(name).is_file()][:6]
        self._answers: list[Answer] = []
        self._rows = self._options()

    def compose(self) -> ComposeResult:
        """Make the name and the list."""
        with Vertical(id="welcome"):
            yield Static(_LOGO, id="welcome-logo", markup=False)
            yield OptionList(*self._rows, id="welcome-list", compact=True)
            yield Label("↑ ↓ choose   Enter begin   Esc write at once", id="welcome-keys")

    def _options(self) -> list[Option | None]:
        options: list[Option | None] = []

        def add(kind: str, value: str, words: str, note: str) -> None:
            self._answers.append((kind, value))
            text = Content.assemble(f" {words:<27} ", (note, "$foreground 60%"))
            options.append(Option(text, id=str(len(self._answers) - 1)))

        for entry in START:
            add(*entry)
        if self._kept:
            options.append(None)
            for number, kept in enumerate(self._kept):
                note = f"not saved, {shown_place(kept)}".removesuffix(", ")
                add("kept", str(number), shown_name(kept), note)
        if self._recent:
            options.append(None)
            for name in self._recent:
                path = Path(name)
                add("open", name, visible(path.name), shown_folder(path.parent))
        found = recipes()
        if found:
            options.append(None)
            for recipe in found:
                add("recipe", str(recipe.path), recipe.title, recipe.description)
        return options

    def on_resize(self, event: events.Resize) -> None:
        """Give the list the room that there is; the name goes where all of it does not fit."""
        options = self.query_one(OptionList)
        room = event.size.height - _FRAME
        rows = len(self._rows)
        self.query_one("#welcome-logo").display = rows + _LOGO_ROWS <= room
        options.styles.max_height = max(room, 1)

    @on(OptionList.OptionSelected)
    def selected(self, event: OptionList.OptionSelected) -> None:
        """Take what was chosen."""
        self.dismiss(self._answers[int(event.option.id or 0)])

    def action_answer(self, call: str) -> None:
        """Do an action of the main screen."""
        self.dismiss(("action", call))

    def action_close(self) -> None:
        """Begin to write."""
        self.dismiss(None)
