"""A question with a few answers, and, where that helps, a text to look at."""

from __future__ import annotations

from collections.abc import Sequence
from time import monotonic
from typing import ClassVar

from textual import events, on
from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Horizontal, Vertical
from textual.content import Content
from textual.widgets import Button, Input, Label

from plastron_tui.diagnostics.terminal import visible, visible_text

from ..key_order import Unread
from ..panels.styles import Lines
from ..panels.text_view import TextView
from .dialog import Dialog


class Question(Dialog[str], Unread):
    """Asks; the result is the id of the answer, "" for none."""

    takes_bursts = True
    """A text that comes as keys answers nothing."""

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("escape", "answer('')", "Cancel"),
        Binding("left", "app.focus_previous", show=False),
        Binding("right", "app.focus_next", show=False),
    ]

    def __init__(
        self,
        title: str,
        answers: Sequence[tuple[str, str]],
        *,
        text: str = "",
        lines: Lines | None = None,
        is_unasked: bool = False,
    ) -> None:
        """Make a question.

        Args:
            title: the question.
            answers: the id and the words of each answer; the first one is the safe one. A
                letter that starts the words, pressed, gives the answer too.
            text: an explanation.
            lines: something to look at, a diff say.
            is_unasked: whether it comes by itself, while somebody may be typing.
        """
        super().__init__()
        self._title = title
        self._answers = list(answers)
        self._text = text
        self._lines = lines
        self.is_unasked = is_unasked

    def compose(self) -> ComposeResult:
        """Make the question and its answers."""
        with Vertical(id="dialog"):
            yield Label(visible(self._title), id="dialog-title", markup=False)
            if self._text:
                yield Label(visible_text(self._text), id="dialog-text", markup=False)
            if self._lines is not None:
                yield TextView(self._lines, id="dialog-view")
            with Horizontal(id="dialog-buttons"):
                for number, (id_, words) in enumerate(self._answers):
                    variant = "primary" if number == 0 else "default"
                    label = self._label(number, words)
                    yield Button(label, id=id_, variant=variant, compact=True)  # type: ignore[arg-type]

    def _label(self, number: int, words: str) -> Content:
        """Return the words of an answer, the letter underlined that gives it."""
        letters = [each[:1].lower() for _, each in self._answers]
        is_first = letters.index(letters[number]) == number
        return Content.assemble((words[:1], "underline" if is_first else ""), words[1:])

    def on_mount(self) -> None:
        """Let Enter give the first answer."""
        self.appeared = monotonic()
        self.query(Button).first().focus()

    def on_resize(self, event: events.Resize) -> None:
        """Take the height of what there is to look at."""
        if self._lines is not None:
            self.take_height(len(self._lines), self._text, event.size)

    @on(Button.Pressed)
    def pressed(self, event: Button.Pressed) -> None:
        """Answer."""
        self.dismiss(event.button.id or "")

    def on_key(self, event: events.Key) -> None:
        """Take the first letter of an answer for the answer."""
        if event.is_printable:
            for id_, words in self._answers:
                if event.character and event.character.lower() == words[0].lower():
                    self.dismiss(id_)
                    return

    def action_answer(self, answer: str) -> None:
        """Answer."""
        self.dismiss(answer)


class Prompt(Dialog[str]):
    """Asks for a line of text; the result is the line, "" for none."""

    BINDINGS: ClassVar[list[BindingType]] = [Binding("escape", "cancel", "Cancel")]

    def __init__(self, title: str, value: str = "", *, text: str = "") -> None:
        super().__init__()
        self._title = title
        self._value = value
        self._text = text

    def compose(self) -> ComposeResult:
        """Make the question and the line."""
        with Vertical(id="dialog"):
            yield Label(visible(self._title), id="dialog-title", markup=False)
            if self._text:
                yield Label(visible_text(self._text), id="dialog-text", markup=False)
            yield Input(self._value, id="dialog-input", compact=True, select_on_focus=True)

    @on(Input.Submitted)
    def submitted(self, event: Input.Submitted) -> None:
        """Take the line."""
        self.dismiss(event.value.strip())

    def action_cancel(self) -> None:
        """Take nothing."""
        self.dismiss("")
