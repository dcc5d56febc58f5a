"""Mistakes of the line that somebody types: they are shown once the line is left, or one rests.

A sentence that is half written is always wrong, and nobody has to be told.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING

from textual.message_pump import MessagePump

from plastron_tui.diagnostics import Diagnostic
from plastron_tui.diagnostics.terminal import visible

from ..delay import Delay

if TYPE_CHECKING:
    from ..editor import ProgramEditor

REST = 1.0
"""Seconds without a key in the editor after which somebody rests."""


class HeldBack:
    """Tells which mistakes are not shown yet.

    Those are the mistakes of the line that is typed in, but for those that it had before.
    """

    def __init__(
        self, pump: MessagePump, editor: ProgramEditor, show: Callable[[], object]
    ) -> None:
        """Hold nothing back yet.

        Args:
            pump: what the time is told to.
            editor: where somebody types.
            show: shows what is no longer held back.
        """
        self._editor = editor
        self._show = show
        self._row: int | None = None
        self._known: frozenset[str] = frozenset()
        self._rest = Delay(pump, self._paused)

    @property
    def _line(self) -> tuple[int, int]:
        """The offsets at which the cursor's line starts and ends."""
        state = self._editor.state
        return state.buffer.start(state.row), state.buffer.end(state.row)

    def edited(self) -> None:
        """Hold back what the cursor's line has wrong from now on."""
        row = self._editor.state.row
        if row != self._row:
            self._row = row
            there = self._editor.marks.between(*self._line)
            self._known = frozenset(mark.message for mark in there)
        self._rest.start(REST)

    def moved(self) -> None:
        """Show all when the cursor has left the line; else wait anew."""
        if self._row is None:
            return
        if self._editor.state.row == self._row:
            self._rest.start(REST)
        else:
            self.rest()

    def _paused(self) -> None:
        """Show all that is wrong, but not beside a list of what can stand there: that is read."""
        if self._row is not None and self._editor.popup.is_open:
            self._rest.start(REST)
        else:
            self.rest()

    @property
    def is_holding(self) -> bool:
        """Whether somebody types, and has not rested since."""
        return self._row is not None

    def rest(self) -> None:
        """Show all that is wrong."""
        if self._row is not None:
            self.clear()
            self._show()

    def clear(self) -> None:
        """Hold nothing back any more."""
        self._row = None
        self._rest.stop()

    def of(self, diagnostics: Iterable[Diagnostic]) -> frozenset[Diagnostic]:
        """Return those of the mistakes of the text as it is that are held back."""
        if self._row is None:
            return frozenset()
        start, end = self._line
        return frozenset(
            each
            for each in diagnostics
            if each.file is None
            and each.span is not None
            and start <= each.span.start <= end
            and visible(each.message) not in self._known
        )
