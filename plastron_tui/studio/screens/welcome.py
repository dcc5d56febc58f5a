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
from textual.widgets import Label, OptionList
from textual.widgets.option_list import Option

from plastron_tui.diagnostics.terminal import visible

from ..folder_labels import shown_folder, shown_name, shown_place
from ..journal import Kept
from ..key_display import key_name
from ..recipes import recipes
from .dialog import Dialog

_TITLE = "Plastron"
_ABOUT = "ROS nodes and robots, described in sentences"
_KEYS = "↑ ↓ choose   Enter opens it   Esc starts writing"
_FRAME = 4
"""Rows around the list: the border, the title, and the line with the keys."""
_GAPS = 2
"""Empty rows below the title and above the keys, where nothing has to be scrolled for them."""
_LOW = 16
"""With fewer rows there is no title."""

Answer = tuple[str, str]

START = (
    ("action", "screen.wizard", "Build nodes with the wizard", key_name("ctrl+u")),
    ("action", "screen.new", "Write a new program", key_name("ctrl+n")),
    ("action", "screen.open", "Open a program", key_name("ctrl+o")),
    ("action", "screen.tour", "Take the two-minute tour", key_name("alt+i")),
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
        Binding("alt+i", "answer('screen.tour')", "Tour", show=False),
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
        self._heads: dict[int, str] = {}
        self._rows = self._options()

    def compose(self) -> ComposeResult:
        """Make the name and the list."""
        about = Content.assemble((_TITLE, "bold $text-primary"), "   ", (_ABOUT, "$foreground 75%"))
        with Vertical(id="welcome"):
            yield Label(about, id="welcome-title")
            yield OptionList(*self._rows, id="welcome-list", compact=True)
            yield Label(_KEYS, id="welcome-keys")

    def _options(self) -> list[Option]:
        options: list[Option] = []

        def head(words: str) -> None:
            self._heads[len(options)] = words
            options.append(Option(_heading(words), disabled=True))

        def add(kind: str, value: str, words: str, note: str) -> None:
            self._answers.append((kind, value))
            text = Content.assemble(f" {words:<27} ", (note, "$foreground 60%"))
            options.append(Option(text, id=str(len(self._answers) - 1)))

        for entry in START:
            add(*entry)
        if self._kept:
            head("Not saved")
            for number, kept in enumerate(self._kept):
                note = f"not saved, {shown_place(kept)}".removesuffix(", ")
                add("kept", str(number), shown_name(kept), note)
        if self._recent:
            head("Opened lately")
            for name in self._recent:
                path = Path(name)
                add("open", name, visible(path.name), shown_folder(path.parent))
        found = recipes()
        if found:
            head("Examples that work")
            for recipe in found:
                add("recipe", str(recipe.path), recipe.title, recipe.description)
        return options

    def on_resize(self, event: events.Resize) -> None:
        """Give the list the room that there is; where that is little, the title goes."""
        title = self.query_one("#welcome-title")
        title.display = event.size.height >= _LOW
        room = event.size.height - _FRAME + (not title.display)
        options = self.query_one(OptionList)
        options.styles.max_height = max(room, 1)
        hidden = len(self._rows) - max(room, 1)
        words = f"{_KEYS}   ↓ {hidden} more below" if hidden > 0 else _KEYS
        self.query_one("#welcome-keys", Label).update(words)
        is_roomy = len(self._rows) + len(self._heads) + _GAPS <= room
        if is_roomy != self.has_class("-roomy"):
            self.set_class(is_roomy, "-roomy")
            for number, words in self._heads.items():
                options.replace_option_prompt_at_index(number, _heading(words, is_roomy))

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


def _heading(words: str, is_roomy: bool = False) -> Content:
    """Return a heading; with an empty row above it where there is room."""
    return Content.styled(("\n " if is_roomy else " ") + words, "$text-muted bold")
