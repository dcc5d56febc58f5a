"""The rows of a form: one for each slot, one for each field of the values."""

from __future__ import annotations

from time import monotonic
from typing import ClassVar

from rich.cells import cell_len
from textual import events
from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Horizontal
from textual.geometry import Size
from textual.message import Message
from textual.widget import Widget
from textual.widgets import Checkbox, Input, Label

from plastron_tui.language import Slot
from plastron_tui.language.declaration import Form

from .values import Entry, Path

REST_OF_PASTE = 0.1
"""Seconds within which the next piece of a paste comes: a terminal is read 4 KB at a time."""

_LABEL, _LEAST_BOX = 16, 12
"""The columns of a row's name, and those that the box has at least, as in the style sheet."""
_UNKNOWN = 1000
"""The columns of a row that is not laid out yet."""
_SHORT = 8
"""A text with fewer characters is a short one."""


class Entered(Message):
    """Something was entered in a row."""

    def __init__(self, row: Row, text: str) -> None:
        super().__init__()
        self.row = row
        self.text = text


class Reached(Message):
    """A row got the focus."""

    def __init__(self, row: Row) -> None:
        super().__init__()
        self.row = row


class Confirmed(Message):
    """Enter was pressed in a row."""


class TextBox(Input):
    """A line of text whose Up and Down belong to the form."""

    BINDINGS: ClassVar[list[BindingType]] = []
    _left_at = 0.0

    def on_focus(self) -> None:
        """Say so."""
        if isinstance(self.parent, Row):
            self.post_message(Reached(self.parent))

    def _on_paste(self, event: events.Paste) -> None:
        """Leave several lines to who has room for them: a field would keep the first.

        The last piece of a long text may be a single line.
        """
        is_going_on = monotonic() - self._left_at < REST_OF_PASTE
        if is_going_on or len(event.text.strip().splitlines()) != 1:
            self._left_at = monotonic()
            event.prevent_default()


class Turn(Checkbox, inherit_bindings=False):
    """True or false: space turns it, Enter is for the form."""

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("space,left,right", "toggle_button", "Turn", show=False),
        Binding("enter", "confirm", "Next", show=False),
    ]

    BUTTON_LEFT = BUTTON_RIGHT = ""
    """The brackets are part of what is between the sides, which have no colour of their own."""

    def get_content_height(self, container: Size, viewport: Size, width: int) -> int:
        """Return the rows that the words take: of Textual's own it is always one."""
        return Widget.get_content_height(self, container, viewport, width)

    def on_mount(self) -> None:
        """Draw what it is now."""
        self._draw()

    def watch_value(self) -> None:
        """Draw what it is now, and tell it."""
        self._draw()
        super().watch_value()

    def _draw(self) -> None:
        # Where there are no colours, a mark that is always there reads as "on".
        self.BUTTON_INNER = "[X]" if self.value else "[ ]"
        self.refresh()

    def action_confirm(self) -> None:
        """Go on."""
        self.post_message(Confirmed())

    def on_focus(self) -> None:
        """Say so."""
        if isinstance(self.parent, Row):
            self.post_message(Reached(self.parent))


class ValueTurn(Turn):
    """True, false or no value, in the row of a field."""

    def toggle(self) -> ValueTurn:
        """Turn it to the next of the three."""
        if isinstance(self.parent, Row):
            self.parent.turn()
        return self


def shortened(text: str, room: int) -> str:
    """Return of what commas part as much as there is room for, and of words where that is little.

    Args:
        text: the unit of a field and what it is, as `m/s, forward, below 0 backward`.
        room: how many columns there are.
    """
    if cell_len(text) <= room:
        return text
    parts, words = text.split(", "), text.split(" ")
    heads = [", ".join(parts[:count]) for count in range(len(parts) - 1, 1, -1)]
    heads += [f"{' '.join(words[:count])}…" for count in range(len(words) - 1, 1, -1)]
    return next((head for head in [*heads, parts[0]] if cell_len(head) <= room), text)


class Row(Horizontal):
    """A name and what is entered for it.

    Attributes:
        slot: the slot of the statement.
        entry: the field of the values, None for the slot itself.
        path: the field of the values, or of a definition, that the row is for.
        query_text: what was written, while a choice is looked at.
        was_entered: whether somebody entered something here, though nobody may know it yet.
    """

    def __init__(
        self,
        slot: Slot,
        label: str,
        text: str,
        *,
        note: str = "",
        entry: Entry | None = None,
        is_fixed: bool = False,
        placeholder: str = "",
        path: Path | None = None,
    ) -> None:
        super().__init__(classes="wizard-row")
        self.path = path
        self.slot = slot
        self.entry = entry
        self.query_text = ""
        self.was_entered = False
        self.is_fixed = is_fixed
        self._label = label
        self._text = text
        self._note = note
        self._placeholder = placeholder
        self._fit()

    def _fit(self) -> None:
        """Leave the room that a short number does not need to what it means."""
        entry = self.entry
        is_number = entry is not None and entry.python in (int, float) and not entry.type.is_array
        self.set_class(is_number and len(self._text) < _SHORT, "-number")
        # A value that is not seen whole beside what it means is seen alone.
        self.set_class(cell_len(self._text) >= self._room - self._noted, "-long")

    @property
    def _room(self) -> int:
        """The columns of the box and of what stands beside it; many where that is not known."""
        return (self.content_size.width or _UNKNOWN) - _LABEL

    @property
    def _noted(self) -> int:
        """The columns that the words beside the box take at most."""
        least = max(0, self._room - _LEAST_BOX - 1)
        return min(cell_len(self._note) + 1, least) if self._note and not self.is_fixed else 0

    @property
    def is_switch(self) -> bool:
        """Whether it is either true or false."""
        return self._is_flag or (self.entry is not None and self.entry.is_switch)

    @property
    def _is_flag(self) -> bool:
        """Whether it is a word that stands there or not."""
        return self.entry is None and self.slot.kind.form is Form.FLAG

    @property
    def _is_on(self) -> bool:
        return self._text == (self.slot.kind.placeholder if self._is_flag else "True")

    def compose(self) -> ComposeResult:
        """Make the name, the box and the note."""
        yield Label(self._label, classes="wizard-label", markup=False)
        if self.is_fixed:
            yield Label(self._text, classes="wizard-fixed", markup=False)
        elif self.is_switch:
            yield ValueTurn(self._switch_words, self._is_on, compact=True)
        else:
            yield TextBox(self._text, compact=True, placeholder=self._placeholder,
                          select_on_focus=True, classes="wizard-box")  # fmt: skip
        classes = "wizard-note -reason" if self.is_fixed else "wizard-note"
        yield Label(self._note, classes=classes, markup=False)

    @property
    def _switch_words(self) -> str:
        if self._is_flag:
            return "yes" if self._is_on else "no"
        return self._text or f"{self._placeholder} (default)"

    def turn(self) -> None:
        """Go on to the next of: no value, true, false; or to yes or no."""
        if self._is_flag:
            self.take("" if self._is_on else self.slot.kind.placeholder)
            return
        self.take({"": "True", "True": "False"}.get(self._text, ""))

    @property
    def text(self) -> str:
        """What is entered."""
        return self._text

    def show(self, text: str, note: str) -> None:
        """Show another text; nobody is told that it was entered."""
        if note != self._note:
            self._note = note
            self._show_note()
        if text == self._text:
            return
        self._text = text
        self._fit()
        if self.is_fixed:
            self.query_one(".wizard-fixed", Label).update(text)
            return
        box = self.box
        with box.prevent(Input.Changed, Checkbox.Changed):
            if isinstance(box, Checkbox):
                box.value = self._is_on
                box.label = self._switch_words
            elif isinstance(box, Input):
                box.value = text

    def on_resize(self) -> None:
        """Say beside the box as much as there is room for."""
        self._fit()
        self._show_note()

    def _show_note(self) -> None:
        label = self.query_one(".wizard-note", Label)
        is_number = self.has_class("-number")
        room = label.content_size.width if is_number else max(0, self._noted - 1)
        label.update(shortened(self._note, room) if room else self._note)

    def align(self, label: int, note: int) -> None:
        """Give the name and the note so many columns; what is entered gets the rest."""
        self.query_one(".wizard-label").styles.width = label + 1
        self.query_one(".wizard-note").styles.width = note + 1

    @property
    def box(self) -> Widget:
        """What takes the focus."""
        return self.query_one("TextBox, Turn")

    def take(self, text: str) -> None:
        """Enter a text, as if it was written."""
        self.was_entered = True
        self.show(text, self._note)
        box = self.box
        if isinstance(box, Input):
            box.cursor_position = len(text)
        self.post_message(Entered(self, text))

    def select(self) -> None:
        """Select what is entered, as after Tab: what is typed then takes its place.

        What ends in a space is a beginning, such as a field's type: what is typed goes behind it.
        """
        box = self.box
        if isinstance(box, Input) and not box.value.endswith(" "):
            box.select_all()

    def on_input_changed(self, event: Input.Changed) -> None:
        """Tell what was written."""
        event.stop()
        if event.value != self._text:
            self.was_entered = True
            self._text = self.query_text = event.value
            self._fit()
            self.post_message(Entered(self, event.value))

    def on_input_submitted(self, event: Input.Submitted) -> None:
        """Go on."""
        event.stop()
        self.post_message(Confirmed())

    def on_click(self, event: events.Click) -> None:
        """Let a click on the name lead to the box."""
        if not self.is_fixed:
            self.box.focus()
