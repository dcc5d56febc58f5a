"""The editor of a program."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Iterable
from functools import cached_property
from typing import TYPE_CHECKING, ClassVar

from textual import events
from textual.app import ComposeResult
from textual.binding import BindingType
from textual.containers import Vertical
from textual.message import Message
from textual.widget import Widget

from plastron_tui.diagnostics import Diagnostic, Edit, Span

from ..delay import Delay
from . import line_commands, text_commands
from .commands import BY_NAME, COMMANDS
from .completer import Completer
from .highlights import LONGEST
from .history import Selection
from .hover import Hover
from .jumps import Jumps
from .marks import Mark, Marks, worst
from .popup import Popup
from .state import EditingState, TextState
from .view import EditorView

if TYPE_CHECKING:
    from plastron_tui.language import Program
    from plastron_tui.language.expectations import Expectation
    from plastron_tui.model.workspace import Workspace
    from plastron_tui.session import Session

    from .bars import FindBar, PromptBar
    from .finder import Finder

_SETTLE = 0.1
"""Seconds after the last key at which all is measured, and coloured, anew."""


class ProgramEditor(Vertical):
    """Edits the text of a session, which stays the only owner of the text and of its tree.

    It posts `Changed` after an edit and `CursorMoved` after a move. It never asks the session
    what the program means while keys come in: whoever does, tells it by `set_diagnostics`.
    All edits go through this widget; what keys do is declared in `COMMANDS`.

    Attributes:
        state: the text, its selection and its history.
        view: what shows it.
        jumps: the places that the cursor jumped from.
        completer: what offers words.
        hover: what shows cards about words.
    """

    DEFAULT_CSS = """
    ProgramEditor { width: 1fr; height: 1fr; background: $surface; color: $foreground; }
    """

    BINDINGS: ClassVar[list[BindingType]] = [command.binding for command in COMMANDS]

    class Changed(Message):
        """The text was edited."""

        def can_replace(self, message: Message) -> bool:
            """Let one message stand for several."""
            return isinstance(message, ProgramEditor.Changed)

    class CursorMoved(Message):
        """The cursor is at another offset."""

        def __init__(self, offset: int) -> None:
            super().__init__()
            self.offset = offset

        def can_replace(self, message: Message) -> bool:
            """Let the last place stand for all."""
            return isinstance(message, ProgramEditor.CursorMoved)

    def __init__(
        self,
        session: Session,
        *,
        name: str | None = None,
        id: str | None = None,  # noqa: A002 - Textual's word
        classes: str | None = None,
    ) -> None:
        super().__init__(name=name, id=id, classes=classes)
        self.state = TextState(session)
        self.jumps = Jumps(self.state)
        self.view = EditorView(self.state, self)
        self.completer = Completer(self.state, self.view)
        self.hover = Hover(self, self.state, self.view)
        self._expected: tuple[bytes, int, Expectation] | None = None
        self._told_text = self.text
        self._told_cursor = 0
        self._settle = Delay(self, self._settled)
        self._mounting = asyncio.Lock()

    def compose(self) -> ComposeResult:
        """Make what is in sight at first: the bars would take a tenth of the time of a start."""
        yield self.view

    def focus(self, scroll_visible: bool = True) -> Widget:  # type: ignore[override]
        """Give the text the focus."""
        return self.view.focus(scroll_visible)

    def on_mouse_move(self, event: events.MouseMove) -> None:
        """Show what is said about the word that the mouse rests on."""
        self.hover.mouse_moved(event)

    def on_leave(self) -> None:
        """Show nothing of a word that the mouse has left."""
        self.hover.mouse_left()

    def on_descendant_blur(self) -> None:
        """Show nothing of a word where keys go elsewhere."""
        self.hover.close()

    def check_action(self, action: str, parameters: tuple[object, ...]) -> bool | None:
        """Leave most keys to a bar that has the focus: they are meant for what is typed there."""
        command = BY_NAME.get(str(parameters[0])) if action == "edit" else None
        if command is None:
            return True
        return (command.in_bars or not self._is_asking) and command.applies(self)

    @property
    def _is_asking(self) -> bool:
        """Whether a bar has the focus."""
        focused = self.screen.focused if self.is_mounted else None
        if focused is None or focused is self.view:
            return False
        return self in focused.ancestors

    async def action_edit(self, command: str) -> None:
        """Run a command."""
        result = BY_NAME[command].run(self)
        if result is not None:
            await result

    def type_text(self, text: str) -> None:
        """Type characters over what is selected, and offer what may follow."""
        if text != " " or not self.completer.takes_blank():
            text_commands.type_text(self.state, text)
        self.done(keeps_popup=True)
        self.offer()

    def offer(self, *, is_asked: bool = False) -> None:
        """Offer what may stand at the cursor."""
        if self.completer.is_ready:
            self.completer.offer(self.expected, is_asked=is_asked)
        else:
            self.completer.offer_later()

    def insert_text(self, text: str) -> None:
        """Put a text over what is selected, as a step of its own to undo."""
        text_commands.insert_text(self.state, text)
        self.done()

    def select_range(self, anchor: int, head: int) -> None:
        """Select a range, wherever it is in sight."""
        self.state.select(anchor, head)
        self.done()

    def accept(self) -> None:
        """Write the entry of the popup that is marked."""
        goes_on = self.completer.accept()
        self.done()
        if goes_on:
            self.offer()

    def done(self, *, scroll: bool = True, center: bool = False, keeps_popup: bool = False) -> None:
        """Show and tell what was done to the text, or with its selection."""
        if not keeps_popup:
            self.view.close_popup()
        self.completer.moved()
        self.hover.close()
        if center:
            self.view.scroll_to_cursor(center=True)
        self.view.sync(scroll=scroll)
        self._tell()

    @cached_property
    def finder(self) -> Finder:
        """What finds and replaces."""
        from .finder import Finder

        return Finder(self.state, self.view, self.done, self.jumps)

    @cached_property
    def find_bar(self) -> FindBar:
        """The bar that asks what to find, and what to put in its place."""
        from .bars import FindBar

        return FindBar(self.finder, self._leave_bar)

    @cached_property
    def prompt_bar(self) -> PromptBar:
        """The bar that asks a question."""
        from .bars import PromptBar

        return PromptBar(self._leave_bar)

    def _leave_bar(self) -> None:
        self.screen.set_focus(self.view)

    async def _mount_bar(self, bar: Widget) -> None:
        async with self._mounting:
            if not bar.is_attached:
                await self.mount(bar)

    async def find(self, *, replace: bool = False) -> None:
        """Ask what to find: what is selected, at first."""
        self.view.close_popup()
        selected = self.state.selected
        await self._mount_bar(self.find_bar)
        what = selected.decode("utf-8", "replace") if b"\n" not in selected else ""
        self.find_bar.open(what, replace=replace)

    async def ask(self, question: str, value: str, answer: Callable[[str], None]) -> None:
        """Ask a question in a line of its own; the answer goes to a function."""
        await self._mount_bar(self.prompt_bar)
        self.prompt_bar.ask(question, value, answer)

    def warn(self, text: str) -> None:
        """Say why something cannot be."""
        self.app.notify(text, severity="warning", markup=False)

    @property
    def session(self) -> Session:
        """The session whose text this is; nobody else edits it."""
        return self.state.buffer.session

    @property
    def text(self) -> bytes:
        """The whole text."""
        return self.state.buffer.text

    @property
    def cursor_offset(self) -> int:
        """The offset of the cursor, in bytes."""
        return self.state.cursor

    @property
    def selection(self) -> Selection:
        """The selected range."""
        return self.state.selection

    @property
    def popup(self) -> Popup:
        """The list of what completion offers."""
        return self.view.popup

    @property
    def marks(self) -> Marks:
        """The mistakes, where they are by now."""
        return self.view.marks

    def mark_at_cursor(self) -> Mark | None:
        """Return the worst mistake that starts on the cursor's line."""
        buffer, row = self.state.buffer, self.state.row
        return worst(self.marks.between(buffer.start(row), buffer.end(row)))

    @property
    def editing(self) -> EditingState:
        """What another `set_session` of this session needs to go on where the editor is."""
        state, (column, row) = self.state, self.view.scroll_offset
        return EditingState(state.selection, state.history, (column, row))

    def set_session(self, session: Session, before: EditingState | None = None) -> None:
        """Edit the text of another session: with a history of its own, or as it was `before`."""
        if "finder" in self.__dict__:
            self.finder.forget()
        self.state.open(session, before)
        self.view.show_anew((0, 0) if before is None else before.scroll)
        self.completer.vocabulary = None
        self._told_text = self.text
        self._told_cursor = -1
        self._tell()

    def set_diagnostics(
        self,
        diagnostics: Iterable[Diagnostic],
        meaning: tuple[Program, Workspace] | None = None,
    ) -> None:
        """Show what is wrong with the text as it is now.

        Args:
            diagnostics: those of the program; others are left out.
            meaning: the statements and the workspace that completion offers names from; without
                it those of the session, which should know them by now.
        """
        path = self.session.path
        own = [found for found in diagnostics if found.file is None or found.file == path]
        self.view.show_marks(Marks(own))
        self.view.repaint()
        from .vocabulary import Vocabulary

        program, workspace = meaning or (self.session.program, self.session.workspace)
        self.completer.learn(Vocabulary(program, workspace))

    @property
    def expected(self) -> Expectation:
        """What the language has room for at the cursor."""
        from plastron_tui.language.expectations import Expectation, expected_at

        text, cursor, known = self.text, self.state.cursor, self._expected
        if known is None or known[0] is not text or known[1] != cursor:
            buffer, row = self.state.buffer, self.state.row
            is_long = buffer.end(row) - buffer.start(row) > LONGEST
            expected = (
                Expectation(Span(cursor, cursor))
                if is_long
                else expected_at(self.session.document, cursor)
            )
            known = self._expected = text, cursor, expected
        return known[2]

    @property
    def statement_help(self) -> str:
        """A line about the statement under the cursor, the current slot between `‹` and `›`."""
        if not self.completer.is_ready:
            return ""
        from .statement_help import help_in_line

        buffer, row = self.state.buffer, self.state.row
        line = buffer.text[buffer.start(row) : buffer.end(row)]
        return help_in_line(line, self.expected, self.session)

    def go_to(self, offset: int, walk: str = "") -> None:
        """Jump to an offset, with the lines around it in sight; `Jumps` says what a walk is."""
        self.jumps.jump(offset, offset, walk)
        self.done(center=True)

    def replace(self, span: Span, text: str) -> None:
        """Replace a range, as one step to undo."""
        self.apply([Edit(span, text)])

    def apply(self, edits: Iterable[Edit]) -> None:
        """Make edits, all in terms of the text as it is now, as one step to undo."""
        self.state.edit(edits)
        self.done()

    def replace_all(self, text: bytes) -> None:
        """Replace the whole text, as one step to undo; only what differs is touched."""
        self.state.replace_all(text)
        self.done()

    def insert_statement(self, text: str) -> None:
        """Put a statement on a line of its own below the cursor's line."""
        buffer = self.state.buffer
        statement = buffer.normalized(text.rstrip("\r\n"))
        self.state.apply(*line_commands.insert_statement(buffer, self.state.cursor, statement))
        self.done()

    def undo(self) -> None:
        """Take the last step back."""
        if self.state.undo():
            self.done()

    def redo(self) -> None:
        """Make the step again that was undone last."""
        if self.state.redo():
            self.done()

    def _tell(self) -> None:
        """Post what has changed since it was last told."""
        if self.text is not self._told_text:
            self._told_text = self.text
            self._told_cursor = -1
            self.post_message(self.Changed())
            self._settle_later()
        if self.state.cursor != self._told_cursor:
            self._told_cursor = self.state.cursor
            self.post_message(self.CursorMoved(self.state.cursor))

    def _settle_later(self) -> None:
        self._settle.start(_SETTLE)

    def _settled(self) -> None:
        if b"/*" in self.text:
            # Only the tree knows which lines are in a comment, and to parse them takes time.
            _ = self.session.document.tree
        self.view.measure()
        self.view.repaint()
