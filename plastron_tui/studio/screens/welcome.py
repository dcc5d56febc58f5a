"""What one sees first: recent programs, examples, the tour."""

from __future__ import annotations

from contextlib import suppress
from pathlib import Path
from typing import ClassVar

from textual import on
from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Vertical
from textual.content import Content
from textual.screen import ModalScreen
from textual.widgets import Label, OptionList, Static
from textual.widgets.option_list import Option

_LOGO = """\
       _           _
 _ __ | | __ _ ___| |_ _ __ ___  _ __
| '_ \\| |/ _` / __| __| '__/ _ \\| '_ \\
| |_) | | (_| \\__ \\ |_| | | (_) | | | |
| .__/|_|\\__,_|___/\\__|_|  \\___/|_| |_|
|_|     ROS nodes, described in sentences"""

Answer = tuple[str, str]

START = (
    ("action", "screen.new", "Write a new program", "^N"),
    ("action", "screen.open", "Open a program", "^O"),
    ("action", "screen.tour", "Take the two-minute tour", ""),
)
"""What can be started: the kind of answer, its value, its words, its key."""


class Welcome(ModalScreen["Answer | None"]):
    """Offers what to begin with; the result says what was chosen."""

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("escape", "close", "Start writing"),
        Binding("ctrl+q", "answer('screen.quit')", "Quit"),
        Binding("ctrl+n", "answer('screen.new')", "New", show=False),
        Binding("ctrl+o", "answer('screen.open')", "Open", show=False),
        Binding("f1", "answer('screen.help')", "Help", show=False),
    ]
    AUTO_FOCUS = "#welcome-list"

    def __init__(self, recent: list[str]) -> None:
        super().__init__()
        self._recent = [name for name in recent if Path(name).is_file()][:6]
        self._answers: list[Answer] = []

    def compose(self) -> ComposeResult:
        """Make the name and the list."""
        with Vertical(id="welcome"):
            yield Static(_LOGO, id="welcome-logo", markup=False)
            yield OptionList(*self._options(), id="welcome-list", compact=True)
            yield Label("↑ ↓ choose   Enter begin   Esc write at once", id="welcome-keys")

    def _options(self) -> list[Option | None]:
        options: list[Option | None] = []

        def add(kind: str, value: str, words: str, note: str) -> None:
            self._answers.append((kind, value))
            text = Content.assemble(f" {words:<26} ", (note, "$foreground 60%"))
            options.append(Option(text, id=str(len(self._answers) - 1)))

        for entry in START:
            add(*entry)
        if self._recent:
            options.append(None)
            for name in self._recent:
                path = Path(name)
                add("open", name, path.name, _home(path.parent))
        found = examples()
        if found:
            options.append(None)
            for path, words in found:
                add("example", str(path), path.stem.replace("_", " "), words)
        return options

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


def _home(folder: Path) -> str:
    with suppress(ValueError, RuntimeError):
        return f"~/{folder.relative_to(Path.home())}"
    return str(folder)


def examples() -> list[tuple[Path, str]]:
    """Return the programs that come with Plastron, each with its first comment.

    Those that load a file from beside them are left out: an example is opened as a new program.
    """
    package = Path(__file__).parents[1]
    installed, source = package / "examples", package.parents[1] / "examples"
    found = []
    with suppress(OSError, UnicodeDecodeError):
        for path in sorted((installed if installed.is_dir() else source).glob("*.plastron")):
            text = path.read_text("utf-8")
            if "\nload " not in text:
                first = text.partition("\n")[0].lstrip("/ ").rstrip(".")
                found.append((path, first.partition(": ")[2] or first))
    return found
