"""A form for what is sent to nodes that run: a message, a request, a parameter's value."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any, ClassVar

from rich.cells import cell_len, set_cell_size
from textual import on
from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Horizontal, Vertical, VerticalScroll
from textual.types import CSSPathType
from textual.widgets import Button, Label

from plastron_tui.diagnostics.terminal import visible
from plastron_tui.language import DECLARATIONS
from plastron_tui.language.statements import CreateMessage

from ..screens.dialog import Dialog
from .rows import Confirmed, Entered, Reached, Row, shortened
from .sent_values import Wrong
from .style_sheets import STYLES
from .values import Entry, Heading, Path

_WIDEST_UNIT = 12
_WIDEST_NOTE = 16
"""Columns of what stands beside a field; the whole of it is below, where the focus is."""
Check = Callable[[Mapping[Path, str]], Any]
"""Makes what is sent of what was entered; a `Wrong` where that does not fit."""


def notes_of(fields: Sequence[Entry]) -> dict[Path, str]:
    """Return what stands beside each field: its unit, in a column of its own, and its type."""
    units = {each.path: "" if each.meaning is None else each.meaning.unit for each in fields}
    units = {path: unit if cell_len(unit) <= _WIDEST_UNIT else "" for path, unit in units.items()}
    width = max(map(cell_len, units.values()), default=0)
    gap = 2 if width else 0
    return {
        each.path: set_cell_size(units[each.path], width + gap) + shortened(each.note, _WIDEST_NOTE)
        for each in fields
    }


class LiveForm(Dialog["dict[Path, str] | None"]):
    """Asks for values, and gives them once they fit; None where nothing is to be sent.

    Attributes:
        given: what was entered, by field.
        edited: the field that was written in last, () where nothing was.
        start: the field that has the focus at first, None for the first one.
        ask: sends what was entered while the form stays, and tells whether that could be done;
            `answered` ends it then. None where it ends at once, and gives what was entered.
        other_verb: what a button says that does more than send it, "" for no such button.
        is_other: whether that one was pressed last.
    """

    CSS_PATH: ClassVar[CSSPathType | None] = STYLES
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("escape", "cancel", "Cancel"),
        Binding("down", "app.focus_next", show=False),
        Binding("up", "app.focus_previous", show=False),
    ]

    def __init__(
        self,
        title: str,
        verb: str,
        form: Sequence[Entry | Heading],
        check: Check,
        given: Mapping[Path, str],
        about: str = "",
        last: Entry | None = None,
        start: Path | None = None,
    ) -> None:
        """Make a form.

        Args:
            title: what it is for.
            verb: what the button says: `Send`, `Call`, `Set`.
            form: the fields.
            check: tells whether what was entered fits.
            given: what is entered at first.
            about: a line about it.
            last: a field that is always in sight, below those of the form.
            start: the field that has the focus at first; None for the first one.
        """
        super().__init__()
        self.given = dict(given)
        self.edited: Path = ()
        self.ask: Callable[[dict[Path, str]], bool] | None = None
        self.other_verb, self.is_other = "", False
        self._is_waiting = False
        self._title, self._verb, self._about = title, verb, about
        self._form = form
        self.start = start
        self._last = last
        self._check = check
        fields = [each for each in (*form, last) if isinstance(each, Entry)]
        self._notes = notes_of(fields)
        self._labelled = max((2 * len(each.path) - 2 + cell_len(each.path[-1]) for each in fields),
                             default=0)  # fmt: skip

    def compose(self) -> ComposeResult:
        """Make a row for each field."""
        has_values = any(isinstance(each, Entry) for each in self._form)
        with Vertical(id="dialog"):
            yield Label(visible(self._title), id="dialog-title", markup=False)
            if self._about or not has_values:
                words = self._about or "it takes no values"
                yield Label(visible(words), id="dialog-text", markup=False)
            classes = "" if self._last is None else "-has-last"
            with VerticalScroll(id="live-rows", classes=classes, can_focus=False):
                for each in self._form:
                    label = "  " * (len(each.path) - 1) + visible(each.path[-1])
                    if isinstance(each, Heading):
                        yield Label(f"{label}  {each.note}", classes="wizard-heading", markup=False)
                        continue
                    yield self._row(each, label)
            if self._last is not None:
                yield self._row(self._last, visible(self._last.path[-1]))
            yield Label("", id="wizard-help", markup=False)
            with Horizontal(id="dialog-buttons"):
                yield Button(self._verb, id="send", variant="primary", compact=True)
                if self.other_verb:
                    yield Button(self.other_verb, id="send-other", compact=True)
                yield Button("Cancel", id="cancel", compact=True)

    def _row(self, entry: Entry, label: str) -> Row:
        slot = DECLARATIONS[CreateMessage].slots[-1]
        text = self.given.get(entry.path, "")
        note = self._notes[entry.path]
        return Row(slot, label, text, note=note, entry=entry, path=entry.path,
                   placeholder=entry.default)  # fmt: skip

    def on_mount(self) -> None:
        """Have the same columns in all rows; begin at the field to start with."""
        rows = list(self.query(Row))
        for row in rows:
            row.align(self._labelled, max(map(cell_len, self._notes.values())))
        first = next((row for row in rows if row.path == self.start), rows[0] if rows else None)
        (self.query_one("#send", Button) if first is None else first.box).focus()

    @on(Entered)
    def entered(self, message: Entered) -> None:
        """Note what was entered, and tell at once where it does not fit."""
        message.stop()
        path = message.row.path
        if path is not None:
            if message.text != self.given.get(path, ""):
                self.edited = path
            self.given[path] = message.text
        found = self._check(self.given)
        self._say(found if isinstance(found, Wrong) else None)

    @on(Reached)
    def reached(self, message: Reached) -> None:
        """Bring the row in sight, and say what its field is."""
        message.stop()
        message.row.scroll_visible(animate=False)
        label = self.query_one("#wizard-help", Label)
        entry = message.row.entry
        if not label.has_class("-wrong") and entry is not None:
            known = entry.comment if entry.meaning is None else entry.meaning.said
            parts = (known, entry.note if entry.type.is_array or not known else "")
            label.update(visible("; ".join(filter(None, parts))))

    @on(Confirmed)
    def confirmed(self, message: Confirmed) -> None:
        """Send it, if it fits."""
        message.stop()
        self._send()

    @on(Button.Pressed)
    def pressed(self, event: Button.Pressed) -> None:
        """Send it, or leave."""
        if event.button.id in ("send", "send-other"):
            self._send(is_other=event.button.id == "send-other")
        else:
            self.dismiss(None)

    def action_cancel(self) -> None:
        """Send nothing."""
        self.dismiss(None)

    def _send(self, *, is_other: bool = False) -> None:
        if self._is_waiting:
            return
        self.is_other = is_other
        found = self._check(self.given)
        if not isinstance(found, Wrong):
            if self.ask is None:
                self.dismiss(self.given)
            elif self.ask(self.given):
                self._is_waiting = True
                self._say(None)
                self.query_one("#wizard-help", Label).update("waiting for the node's answer…")
            else:
                self._say(Wrong("nothing runs that could take it"))
            return
        self._say(found)
        row = next((each for each in self.query(Row) if each.path == found.path), None)
        if row is not None:
            row.box.focus()

    def answered(self, text: str, *, is_failure: bool) -> None:
        """End, or say why what was sent was not taken."""
        self._is_waiting = False
        if is_failure:
            self._say(Wrong(text, next(iter(self.given), None)))
        else:
            self.dismiss(self.given)

    def _say(self, wrong: Wrong | None) -> None:
        label = self.query_one("#wizard-help", Label)
        label.set_class(wrong is not None, "-wrong")
        label.update("" if wrong is None else f"✗ {visible(wrong.message)}")
        for row in self.query(Row):
            row.set_class(wrong is not None and row.path == wrong.path, "-wrong")
