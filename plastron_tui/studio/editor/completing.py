"""The keys and the moments at which completion is offered and taken."""

from __future__ import annotations

from typing import ClassVar

from textual.binding import Binding, BindingType

from plastron_tui.diagnostics import Span
from plastron_tui.language.lowering import lower

from .base import EditorBase
from .completion import (
    Candidate,
    Vocabulary,
    candidates,
    candidates_by_purpose,
    detail_of,
)
from .history import Selection

_SMALL = 64 * 1024
"""A text of so many bytes is understood at once; a longer one waits for its diagnostics."""


class CompletingActions(EditorBase):
    """Offers what may stand at the cursor."""

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("ctrl+@,ctrl+space,f4", "complete", "Complete", show=False, id="editor.complete"),
        Binding("tab", "accept", "Complete", show=False, id="editor.accept"),
        Binding("escape", "dismiss", "Close the list", show=False, id="editor.dismiss"),
    ]

    def check_action(self, action: str, parameters: tuple[object, ...]) -> bool | None:
        """Leave Escape to others while there is nothing to close."""
        if action == "dismiss":
            has_work = self.popup.is_open or not self.selection.is_empty
            return has_work and super().check_action(action, parameters)
        return super().check_action(action, parameters)

    def action_complete(self) -> None:
        """Offer what may stand at the cursor, however little is typed."""
        self._offer(is_asked=True)

    def action_accept(self) -> None:
        """Take what is marked in the list; without a list, offer one, and take what is alone."""
        if self.popup.is_open:
            self.accept()
            return
        self._offer(is_asked=True)
        if len(self.popup.candidates) == 1:
            self.accept()

    def action_dismiss(self) -> None:
        """Close the list, or let go of what is selected."""
        if self.popup.is_open:
            self.view.close_popup()
        else:
            self.state.move(self.state.cursor)
            self.done()

    def complete_typed(self) -> None:
        """Offer what may follow what was just typed."""
        self._offer(is_asked=False)

    def names(self) -> Vocabulary:
        """Return the names of the program, as of its last diagnostics."""
        if self.vocabulary is None:
            session = self.session
            if self.state.buffer.size > _SMALL:
                return Vocabulary(lower(type(session.document)()), type(session.workspace)())
            self.vocabulary = Vocabulary(session.program, session.workspace)
        return self.vocabulary

    def _offer(self, *, is_asked: bool) -> None:
        expected = self.expected
        if not self.selection.is_empty or (
            not is_asked and expected.starts_line and not expected.prefix
        ):
            self.view.close_popup()
            return
        names, session = self.names(), self.session
        found = candidates(expected, names, session)
        if not found and is_asked:
            found = candidates_by_purpose(expected, names, session)
        if not found or (len(found) == 1 and found[0].text == expected.prefix):
            self.view.close_popup()
            return
        self.view.offer(
            found,
            lambda candidate: detail_of(candidate, expected, names, session),
            self._replaced().start,
        )

    def _replaced(self) -> Span:
        """Return the range that a candidate replaces: the word, or the quote so far."""
        span, prefix = self.expected.span, self.expected.prefix
        written = self.text[span.start : span.end]
        is_open = prefix[:1] == "'" and not (len(written) > 1 and written.endswith(b"'"))
        return Span(span.start, self.state.cursor if is_open else span.end)

    def accept(self) -> None:
        """Write what is marked in the list, and what follows it if the line ends there."""
        candidate = self.popup.current
        if candidate is not None:
            self._write(candidate)

    def _write(self, candidate: Candidate) -> None:
        span = self._replaced()
        buffer = self.state.buffer
        rest = buffer.text[span.end : buffer.end(buffer.row(span.end))]
        text = candidate.text
        if candidate.after and (not rest.strip() or candidate.after == "="):
            text += candidate.after if not rest.startswith(b"=") else ""
        new = text.encode("utf-8")
        at = span.start + len(new)
        self.state.history.close()
        self.state.apply([(span.start, span.end, new)], Selection(at, at))
        self.done()
