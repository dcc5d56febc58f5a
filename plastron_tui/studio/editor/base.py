"""What all parts of the editor share: its text, its view, and what happens after each action."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import cached_property
from typing import TYPE_CHECKING

from textual.app import ComposeResult
from textual.containers import Vertical
from textual.message import Message
from textual.reactive import reactive
from textual.timer import Timer

from plastron_tui.diagnostics import Diagnostic, Edit, Span
from plastron_tui.language.expectations import Expectation, expected_at

from . import line_commands
from .completion import Vocabulary
from .highlights import LONGEST
from .history import Selection
from .marks import Mark, Marks, worst
from .state import TextState
from .statement_help import help_of
from .view import EditorView

if TYPE_CHECKING:
    from plastron_tui.language import Program
    from plastron_tui.model.workspace import Workspace
    from plastron_tui.session import Session

    from .bars import FindBar, PromptBar

_SETTLE = 0.1
"""Seconds after the last key at which all is measured, and coloured, anew."""

_IN_BARS = frozenset({"undo", "redo", "find", "replace", "find_next", "find_previous"})
"""What keys do with the text while a bar has the focus."""


_BARS = 0.3
"""Seconds after the start at which the bars are made."""


class Changed(Message, namespace="program_editor"):
    """The text was edited."""

    def can_replace(self, message: Message) -> bool:
        """Let one message stand for several."""
        return isinstance(message, Changed)


class CursorMoved(Message, namespace="program_editor"):
    """The cursor is at another offset."""

    def __init__(self, offset: int) -> None:
        super().__init__()
        self.offset = offset

    def can_replace(self, message: Message) -> bool:
        """Let the last place stand for all."""
        return isinstance(message, CursorMoved)


class EditorBase(Vertical):
    """A text, the view of it, and the bars and the popup around it."""

    DEFAULT_CSS = """
    EditorBase { width: 1fr; height: 1fr; background: $surface; color: $foreground; }
    """

    statement_help: reactive[str] = reactive("")
    """A line about the statement under the cursor, the current slot between `‹` and `›`."""

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
        self.view = EditorView(self.state)
        self._has_bars = False
        self._bars_timer: Timer | None = None
        self._needs_bars: list[Callable[[], object]] = []
        self.popup = self.view.popup
        self.vocabulary: Vocabulary | None = None
        self._told_text = self.state.buffer.text
        self._told_cursor = 0
        self._settle: Timer | None = None
        self.expected: Expectation = expected_at(session.document, 0)

    def check_action(self, action: str, parameters: tuple[object, ...]) -> bool | None:
        """Leave most keys to a bar that has the focus: they are meant for what is typed there."""
        return action in _IN_BARS or not self.is_mounted or self._has_no_bar_focus

    @property
    def _has_no_bar_focus(self) -> bool:
        focused = self.screen.focused
        if focused is None or focused is self.view:
            return True
        if not self._has_bars:
            return True
        return not {self.find_bar, self.prompt_bar} & set(focused.ancestors_with_self)

    @cached_property
    def find_bar(self) -> FindBar:
        """The bar that asks what to find, and what to put in its place."""
        from .bars import FindBar

        return FindBar()

    @cached_property
    def prompt_bar(self) -> PromptBar:
        """The bar that asks a question."""
        from .bars import PromptBar

        return PromptBar()

    def compose(self) -> ComposeResult:
        """Make what is in sight at first: the bars would take a tenth of the time of a start."""
        yield self.view

    def on_mount(self) -> None:
        """Make the rest when there is something to see, and the first key had its time."""
        self._bars_timer = self.set_timer(_BARS, self._add_bars)

    async def _add_bars(self) -> None:
        if self._bars_timer is None:
            return
        self._bars_timer.stop()
        self._bars_timer = None
        await self.mount(self.find_bar, self.prompt_bar)
        self._has_bars = True
        for action in self._needs_bars:
            action()
        self._needs_bars.clear()

    def with_bars(self, action: Callable[[], object]) -> None:
        """Do something with the bars, as soon as they are there."""
        if self._has_bars:
            action()
        else:
            self._needs_bars.append(action)
            self.call_later(self._add_bars)

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

    def set_session(self, session: Session) -> None:
        """Edit the text of another session, with a history of its own."""
        self.view.close_popup()
        self.state = TextState(session)
        self.view.set_state(self.state)
        self.vocabulary = None
        self._told_text = self.state.buffer.text
        self._told_cursor = -1
        self._tell_cursor()

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
        self.view.set_marks(Marks(own))
        self.view.repaint()
        program, workspace = meaning or (self.session.program, self.session.workspace)
        self.vocabulary = Vocabulary(program, workspace)

    @property
    def marks(self) -> Marks:
        """The mistakes, where they are by now."""
        return self.view.marks

    def mark_at_cursor(self) -> Mark | None:
        """Return the worst mistake that starts on the cursor's line."""
        buffer, row = self.state.buffer, self.state.row
        return worst(self.marks.between(buffer.start(row), buffer.end(row)))

    def go_to(self, offset: int) -> None:
        """Put the cursor at an offset, with the lines around it in sight."""
        self.state.move(offset)
        self.done(center=True)

    def select(self, span: Span) -> None:
        """Select a range, with the lines around it in sight."""
        self.state.select(span.start, span.end)
        self.done(center=True)

    def replace(self, span: Span, text: str) -> None:
        """Replace a range, as one step to undo."""
        self.apply([Edit(span, text)])

    def apply(self, edits: Iterable[Edit]) -> None:
        """Make edits, all in terms of the text as it is now, as one step to undo."""
        normalized = self.state.buffer.normalized
        splices = [(edit.span.start, edit.span.end, normalized(edit.text)) for edit in edits]
        splices.sort()
        head = line_commands.shifted(splices, self.state.cursor)
        self.state.apply(splices, Selection(head, head))
        self.done()

    def replace_all(self, text: bytes) -> None:
        """Replace the whole text, as one step to undo; only what differs is touched."""
        old = self.text
        start = common_prefix(old, text)
        end = common_prefix(old[start:][::-1], text[start:][::-1])
        row, cell = self.state.row, self.state.buffer.cell(self.state.cursor)
        self.state.apply([(start, len(old) - end, text[start : len(text) - end])])
        row = min(row, self.state.buffer.row_count - 1)
        self.state.move(self.state.buffer.at_cell(row, cell))
        self.done()

    def insert_statement(self, text: str) -> None:
        """Put a statement on a line of its own below the cursor's line."""
        statement = self.state.buffer.normalized(text.rstrip("\r\n"))
        buffer = self.state.buffer
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

    def done(self, *, scroll: bool = True, center: bool = False) -> None:
        """Show and tell what an action did. Every action ends with it."""
        self.view.close_popup()
        if center:
            self.view.scroll_to_cursor(center=True)
        self.view.sync(scroll=scroll)
        self.tell()

    def tell(self) -> None:
        """Post what has changed since it was last told."""
        if self.text is not self._told_text:
            self._told_text = self.text
            self._told_cursor = -1
            self.post_message(Changed())
            self._settle_later()
        self._tell_cursor()

    def _tell_cursor(self) -> None:
        if self.state.cursor != self._told_cursor:
            self._told_cursor = self.state.cursor
            self.expected = self._expected()
            self.statement_help = help_of(self.expected)
            self.post_message(CursorMoved(self.state.cursor))

    def _expected(self) -> Expectation:
        buffer, row, cursor = self.state.buffer, self.state.row, self.state.cursor
        if buffer.end(row) - buffer.start(row) > LONGEST:
            return Expectation(Span(cursor, cursor))
        return expected_at(self.session.document, cursor)

    def _settle_later(self) -> None:
        if self._settle is None:
            self._settle = self.set_timer(_SETTLE, self._settled)
        else:
            self._settle.reset()

    def _settled(self) -> None:
        self._settle = None
        if b"/*" in self.text:
            # Only the tree knows which lines are in a comment, and to parse them takes time.
            _ = self.session.document.tree
        self.view.measure()
        self.view.repaint()


def common_prefix(one: bytes, other: bytes) -> int:
    """Return how many bytes two texts have in common at their start."""
    low, high = 0, min(len(one), len(other))
    while low < high:
        middle = (low + high + 1) // 2
        if one[low:middle] == other[low:middle]:
            low = middle
        else:
            high = middle - 1
    return low
