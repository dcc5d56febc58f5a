"""The page of a form."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import takewhile
from typing import ClassVar

from rich.text import Text
from textual import on
from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Vertical, VerticalScroll
from textual.content import Content
from textual.message import Message
from textual.widget import Widget
from textual.widgets import Label, OptionList
from textual.widgets.option_list import Option

from plastron_tui.language import Slot, SlotKind
from plastron_tui.model.workspace import Workspace

from .ask import Choice
from .definition_rows import field_slots, row_path
from .filling import Filled
from .form import NEW, Form, new_words
from .form_room import IN_SIGHT, Wanted, first_choices, room_for
from .form_rows import Key, Spec, matters, specs
from .program_trial import Finding
from .rows import Entered, Reached, Row
from .strings import about
from .values import Path

_ROWS_ALONE, _ROWS_BESIDE_CHOICES = 80, 60
"""The most that the rows take of the page's height, in percent."""


class Put(Message):
    """Something was entered: a slot's text, or the value of a field."""

    def __init__(self, form: Form, slot: Slot, path: Path | None, text: str) -> None:
        super().__init__()
        self.form = form
        self.slot = slot
        self.path = path
        self.text = text


class Stepped(Message):
    """The focus is to go to the next row, or with -1 to the one before."""

    def __init__(self, by: int) -> None:
        super().__init__()
        self.by = by


class Looked(Message):
    """Another row got the focus, or its choices are wanted for another text."""


class Rows(VerticalScroll, inherit_bindings=False):
    """The rows, which scroll when the focus moves: Up and Down belong to the choices."""


class FormPage(Vertical):
    """Shows a form, the choices for the row with the focus, and what is wrong."""

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("tab", "step(1)", "Next field", show=False),
        Binding("shift+tab", "step(-1)", "Field before", show=False),
        Binding("down", "choose(1)", "Next choice", show=False),
        Binding("up", "choose(-1)", "Choice before", show=False),
        Binding("pagedown", "choose(6)", "Choices on", show=False),
        Binding("pageup", "choose(-6)", "Choices back", show=False),
    ]

    def __init__(self, form: Form, start: Key | None = None) -> None:
        """Make the page; the row `start` gets the focus, where it is there, or else the first."""
        super().__init__(id="wizard-form")
        self.form = form
        self._start = start
        self.problems: tuple[Finding, ...] = ()
        self.choices: list[Choice] = []
        self._shapes: list[tuple[object, ...]] = []
        self._rows: dict[Key, Row] = {}
        self._help: dict[Key, str] = {}
        self._insists = False
        # The row that had the focus first: there the page is read before it is filled in.
        self._first: Key | None = None

    def compose(self) -> ComposeResult:
        """Make the parts; the rows come with what is known of them."""
        yield Label(about(self.form), id="wizard-about", markup=False)
        yield Rows(id="wizard-rows", can_focus=False)
        yield Label("", id="wizard-help", markup=False)
        choices = OptionList(id="wizard-choices", compact=True, markup=False)
        choices.can_focus = False
        yield choices

    async def show(
        self, filled: Filled, problems: Sequence[Finding], helps: dict[Key, str]
    ) -> None:
        """Show what is in the form now, and what is wrong with it."""
        wanted = specs(filled)
        self._help = helps
        self.problems = tuple(each for each in problems if each.form is self.form)
        shapes = [spec.shape for spec in wanted]
        if shapes != self._shapes:
            await self._build(wanted, shapes, filled.scene.workspace)
        for spec in wanted:
            if spec.key is not None:
                row = self._rows[spec.key]
                # What is being written is not written over.
                text = row.text if self._is_being_written(row, spec) else spec.text
                row.show(text, spec.note)
        wrong = {(each.slot, each.path) for each in self.problems}
        for key, row in self._rows.items():
            row.set_class(key in wrong, "-wrong")
        self.show_help()

    def _is_being_written(self, row: Row, spec: Spec) -> bool:
        has_focus = not row.is_fixed and row.box.has_focus
        if row.was_entered:
            return has_focus
        if row.path is not None:
            return has_focus and row.path in self.form.values
        return has_focus and row.slot.name in self.form.entered

    async def _build(
        self, wanted: Sequence[Spec], shapes: list[tuple[object, ...]], workspace: Workspace
    ) -> None:
        """Make the rows from the first one on that is another than before."""
        here, self._start = self.key_here or self._start, None
        pairs = zip(self._shapes, shapes, strict=False)
        kept = sum(1 for _ in takewhile(lambda pair: pair[0] == pair[1], pairs))
        self._shapes = shapes
        rows = self.query_one(Rows)
        made: list[Widget] = []
        there = [spec.key for spec in wanted[:kept] if spec.key is not None]
        self._rows = {key: self._rows[key] for key in there}
        for spec in wanted[kept:]:
            if spec.key is None or spec.slot is None:
                words = f"{spec.label}  {spec.note}" if spec.note else spec.label
                made.append(Label(words, classes="wizard-heading", markup=False))
                continue
            row = Row(
                spec.slot,
                spec.label,
                spec.text,
                note=spec.note,
                entry=spec.entry,
                is_fixed=spec.is_fixed,
                placeholder=spec.placeholder,
                path=spec.key[1],
            )
            self._rows[spec.key] = row
            made.append(row)
        await rows.remove_children(list(rows.children)[kept:])
        await rows.mount_all(made)
        if here in there:
            return
        found = None if here is None else self._rows.get(here) or self._last_of(here[0])
        if found is None or found.is_fixed:
            free = [row for row in self._rows.values() if not row.is_fixed]
            # What has to be thought of comes before what is called somehow in any case.
            found = next((row for row in free if matters(row, workspace)), next(iter(free), None))
        if found is not None:
            self._first = self._first or (found.slot.name, found.path)
            found.box.focus()
        else:
            self.screen.set_focus(None)

    def _last_of(self, slot: str) -> Row | None:
        """Return the last row of a slot, for who was in one that is gone."""
        return next((row for row in reversed(self._rows.values()) if row.slot.name == slot), None)

    @property
    def row_here(self) -> Row | None:
        """The row with the focus."""
        focused = self.screen.focused
        return next(
            (row for row in self._rows.values() if focused is not None and focused.parent is row),
            None,
        )

    @property
    def key_here(self) -> Key | None:
        """What the row with the focus is for."""
        row = self.row_here
        return None if row is None else (row.slot.name, row.path)

    def show_help(self) -> None:
        """Say what the row with the focus is for, or what is wrong with it."""
        label = self.query_one("#wizard-help", Label)
        key = self.key_here
        found = next((each for each in self.problems if (each.slot, each.path) == key), None)
        if found is None and (key is None or self._insists):
            found = next(iter(self.problems), None)
        label.set_class(found is not None, "-wrong")
        if found is not None:
            label.update(f"✗ {found.words}")
        else:
            self._insists = False
            label.update(self._help.get(key, "") if key is not None else "")
        self._share_room()

    def on_resize(self) -> None:
        """Share out another number of lines."""
        self._share_room()

    def _share_room(self) -> None:
        """Keep what is said of the row in sight, and choices for it, where there is little room."""
        width, height = self.content_size
        if not width:
            return
        about, shown = self.query_one("#wizard-about", Label), self.query_one("#wizard-help", Label)
        console = self.app.console

        def lines(text: str) -> int:
            return sum(len(Text(each).wrap(console, width)) for each in text.splitlines())

        choices = [lines(_shown(each).plain) for each in self.choices[:IN_SIGHT]]
        wanted = Wanted(
            lines(str(about.content)) + 1,
            len(self._shapes),
            lines(str(shown.content)) + 1,
            first_choices(choices),
        )
        is_read = self.key_here in (None, self._first) and not shown.has_class("-wrong")
        room = room_for(wanted, height, is_read=is_read)
        about.display = room.has_about
        rows = self.query_one(Rows)
        usual = height * (_ROWS_BESIDE_CHOICES if self.choices else _ROWS_ALONE) // 100
        rows.styles.max_height = min(usual, room.rows)

    def insist(self, finding: Finding) -> None:
        """Go to what is wrong, and say it."""
        self._insists = True
        row = self._rows.get((finding.slot, finding.path))
        if row is not None and not row.is_fixed:
            row.box.focus()
        self.show_help()

    def goes_on(self) -> bool:
        """Go from the name of a type to its first field, where that is but an example.

        Return whether it did so: what nobody has looked at is not taken along with the name.
        """
        row = self.row_here
        if row is None or row.slot.kind is not SlotKind.TYPE_NAME:
            return False
        slot = field_slots(self.form)[0]
        first = self._rows.get((slot.name, row_path(slot, 0)))
        if first is None or any(path[0] == slot.name for path in self.form.values):
            return False
        first.box.focus()
        return True

    def action_step(self, by: int) -> None:
        """Go to the next row, once the rows are those that follow from what was entered."""
        self.post_message(Stepped(by))

    def show_choices(self, choices: Sequence[Choice]) -> None:
        """List what can be taken for the row with the focus."""
        if list(choices) == self.choices:
            return
        self.choices = list(choices)
        self.set_class(bool(choices), "-has-choices")
        options = self.query_one("#wizard-choices", OptionList)
        options.clear_options()
        options.add_options(
            Option(_shown(choice), id=str(number), disabled=bool(choice.closed))
            for number, choice in enumerate(self.choices)
        )
        self._share_room()
        row = self.row_here
        if row is not None:
            texts = [_entered(row.slot, each) for each in self.choices]
            if row.text in texts:
                options.highlighted = texts.index(row.text)

    def action_choose(self, by: int) -> None:
        """Take the next choice that is open, or go to the next row where there are none."""
        row = self.row_here
        free = [number for number, each in enumerate(self.choices) if not each.closed]
        if row is None or not free:
            if by > 0:
                self.screen.focus_next("TextBox, Turn, Button")
            else:
                self.screen.focus_previous("TextBox, Turn, Button")
            return
        options = self.query_one("#wizard-choices", OptionList)
        at = options.highlighted
        if at in free:
            place = min(max(free.index(at) + by, 0), len(free) - 1)
        else:
            place = 0 if by > 0 else len(free) - 1
        options.highlighted = free[place]
        row.take(_entered(row.slot, self.choices[free[place]]))
        row.select()

    @on(OptionList.OptionSelected, "#wizard-choices")
    def chosen(self, event: OptionList.OptionSelected) -> None:
        """Take what was clicked."""
        event.stop()
        row = self.row_here
        if row is not None:
            row.take(_entered(row.slot, self.choices[int(event.option.id or 0)]))

    def on_entered(self, message: Entered) -> None:
        """Tell what was entered."""
        message.stop()
        row, text = message.row, message.text
        if row.path is None and text == new_words(row.slot):
            text = NEW
        self.post_message(Put(self.form, row.slot, row.path, text))

    def on_reached(self, message: Reached) -> None:
        """Ask for what can be said about the row."""
        message.stop()
        message.row.query_text = ""
        message.row.scroll_visible(animate=False)
        self.show_help()
        self.post_message(Looked())


def _entered(slot: Slot, choice: Choice) -> str:
    return new_words(slot) if choice.text == NEW else choice.text


def _shown(choice: Choice) -> Content:
    label = choice.label or choice.text
    quiet = "$foreground 60%"
    parts: list[str | tuple[str, str]] = [("■ ", choice.swatch)] if choice.swatch else []
    parts.append((label, "$foreground 50%" if choice.closed else "bold"))
    if choice.note:
        parts.append((f"  {choice.note}", quiet))
    if said := choice.closed or choice.about:
        parts.append((f"\n  {said}", quiet))
    return Content.assemble(*parts)
