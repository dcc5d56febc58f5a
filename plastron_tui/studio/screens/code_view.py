"""Code of a program, to be read: a file at a line, and from there the user's own editor."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import ClassVar

from textual import on
from textual.app import App, ComposeResult, SuspendNotSupported
from textual.binding import Binding, BindingType
from textual.containers import Horizontal, Vertical
from textual.widgets import Input, Label, OptionList
from textual.widgets.option_list import Option

from plastron_tui.diagnostics.terminal import visible
from plastron_tui.diagnostics.wording import counted
from plastron_tui.regular_files import read_regular, reason, stamp_of

from ..code_places import LARGEST, Place
from ..editor.external_editor import external_editor, run_editor
from ..folder_labels import shown_folder
from ..panels.code_lines import CodeLines
from ..panels.code_text import CodeText
from .dialog import Dialog

_LOOK = 2
"""Seconds after which the file is looked at again."""


class ChoosePlace(Dialog[int]):
    """Asks which of several places is meant; the result is its number, -1 for none."""

    BINDINGS: ClassVar[list[BindingType]] = [Binding("escape", "cancel", "Cancel")]

    def __init__(self, places: Sequence[Place]) -> None:
        super().__init__()
        self._places = places

    def compose(self) -> ComposeResult:
        """Make the list."""
        width = max(len(visible(place.what)) for place in self._places)
        with Vertical(id="dialog"):
            yield Label("Which one?", id="dialog-title")
            yield OptionList(
                *(Option(f"{visible(place.what):<{width}}  {_where(place)}")
                  for place in self._places),
                id="dialog-places", compact=True, markup=False,
            )  # fmt: skip
            yield Label("Enter opens it, Esc closes", id="dialog-keys")

    def on_mount(self) -> None:
        """Let the keys go to the list."""
        self.query_one(OptionList).focus()

    @on(OptionList.OptionSelected)
    def chosen(self, event: OptionList.OptionSelected) -> None:
        """Take a place."""
        self.dismiss(event.option_index)

    def action_cancel(self) -> None:
        """Take none."""
        self.dismiss(-1)


def _where(place: Place) -> str:
    where = f"{visible(place.path.parent.name)}/{visible(place.path.name)}:{place.line}"
    return where if place.text is None else f"{where}  not written yet"


class CodeView(Dialog[None]):
    """Shows a file at a line; it is read anew when it changes."""

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("escape,q", "close", "Close"),
        Binding("e,ctrl+e", "edit", "Open in $EDITOR"),
        Binding("ctrl+f,slash", "find", "Find"),
        Binding("f3", "step(1)", "Find next"),
        Binding("shift+f3,alt+p,f15", "step(-1)", "Find previous"),
        Binding("n", "turn(1)", "Next place"),
        Binding("p", "turn(-1)", "Place before"),
    ]

    def __init__(self, places: Sequence[Place], at: int = 0) -> None:
        """Show the first of some places, or another one.

        Args:
            places: the places; between them one can turn.
            at: the number of the one that is shown first.
        """
        super().__init__()
        self._places = places
        self._at = at
        self._stamp: object = None
        self._problem = ""

    @property
    def place(self) -> Place:
        """The place that is shown."""
        return self._places[self._at]

    def compose(self) -> ComposeResult:
        """Make the heading, the text and the line that finds."""
        with Vertical(id="dialog", classes="-full"):
            yield Label("", id="dialog-title", markup=False)
            yield CodeText(self._read(), self.place.line - 1, id="dialog-view")
            with Horizontal(id="code-find"):
                yield Label("find ")
                yield Input(id="code-wanted", compact=True)
                yield Label("", id="code-count")
            yield Label(self._keys(), id="dialog-keys", markup=False)

    def on_mount(self) -> None:
        """Give the text the keys, and look at the file from time to time."""
        self.query_one("#code-find").display = False
        self._view.focus()
        self._head()
        self.set_interval(_LOOK, self.look_at_disk)

    @property
    def _view(self) -> CodeText:
        return self.query_one(CodeText)

    def _read(self) -> CodeLines:
        """Return what there is to show of the place at hand."""
        place, self._problem = self.place, ""
        if place.text is not None:
            return CodeLines(place.text, place.path)
        self._stamp = stamp_of(place.path)
        try:
            return CodeLines(read_regular(place.path, LARGEST), place.path)
        except (OSError, ValueError) as error:
            self._problem = f"cannot be read: {reason(error)}"
            return CodeLines(b"", place.path)

    def _head(self) -> None:
        place = self.place
        parts = [f"{visible(place.path.name)}:{self._view.line + 1}", visible(place.what)]
        if self._problem:
            parts.append(self._problem)
        elif place.text is not None:
            parts.append("not written yet: F6 would write this")
        else:
            parts.append(shown_folder(place.path.parent))
        if len(self._places) > 1:
            parts.append(f"{self._at + 1} of {len(self._places)}")
        self.query_one("#dialog-title", Label).update("  ".join(parts))

    def _keys(self) -> str:
        keys = ["Esc closes", "Ctrl-F finds"]
        if len(self._places) > 1:
            keys.append("N shows the next place")
        if self.place.text is None:
            keys.append("E opens $EDITOR here")
        return "   ".join(keys)

    def look_at_disk(self) -> None:
        """Read the file anew where somebody has written it; the line at hand is found again."""
        place = self.place
        if place.text is not None or stamp_of(place.path) == self._stamp:
            return
        view = self._view
        before = view.code
        now = self._read()
        view.show_code(now, line_again(before, view.line, now))
        self._head()

    def action_turn(self, by: int) -> None:
        """Show the next place, or with -1 the one before."""
        if len(self._places) > 1:
            before = self.place
            self._at = (self._at + by) % len(self._places)
            if (before.path, before.text) != (self.place.path, self.place.text):
                self._view.show_code(self._read(), self.place.line - 1)
            else:
                self._view.go_to(self.place.line - 1)
            self._head()
            self.query_one("#dialog-keys", Label).update(self._keys())

    def action_edit(self) -> None:
        """Open the file in the user's editor, at the line at hand."""
        if self.place.text is not None:
            self._warn("this file is not written yet: F6 writes it")
            return
        problem = edit_in_terminal(self.app, self.place, self._view.line + 1)
        if problem is not None:
            self._warn(problem)
        self.look_at_disk()

    def _warn(self, text: str) -> None:
        self.app.notify(text, severity="warning", markup=False)

    def action_find(self) -> None:
        """Ask what to find."""
        self.query_one("#code-find").display = True
        self.query_one(Input).focus()

    @on(Input.Changed)
    def sought(self, event: Input.Changed) -> None:
        """Go to the first place from the line at hand on."""
        self._view.mark(event.value)
        self._view.find(1, here=True)
        self._count()

    @on(Input.Submitted)
    def action_next(self) -> None:
        """Go to the next place."""
        self.action_step(1)

    def action_step(self, by: int) -> None:
        """Go to the next place that was looked for, or with -1 to the one before."""
        self._view.find(by)
        self._count()

    def _count(self) -> None:
        wanted = self.query_one(Input).value
        said = f" {counted(self._view.count, 'place')}" if wanted else ""
        self.query_one("#code-count", Label).update(said)
        self._head()

    def action_close(self) -> None:
        """Close what finds, where it is open, and else the file."""
        if self.query_one("#code-find").display:
            self.query_one("#code-find").display = False
            self._view.mark("")
            self._view.focus()
        else:
            self.dismiss(None)


def line_again(before: CodeLines, line: int, now: CodeLines) -> int:
    """Return where a line of a text is in another text: the like one that is nearest."""
    end = before.starts[line + 1] if line + 1 < len(before) else len(before.text)
    wanted = before.text[before.starts[line] : end].strip()
    at, like = -1, []
    while wanted and (at := now.text.find(wanted, at + 1)) >= 0:
        like.append(now.row_at(at))
    return min(like, key=lambda row: abs(row - line), default=line)


def edit_in_terminal(app: App[object], place: Place, line: int) -> str | None:
    """Lend the terminal to the user's editor for a file, and return what went wrong."""
    command = external_editor(os.environ)
    if isinstance(command, str):
        return command
    try:
        with app.suspend():
            problem = run_editor(command, place.path, line)
    except SuspendNotSupported:
        return "this terminal cannot be lent to another editor"
    app.refresh()
    return problem
