"""When completion is offered, and how what was chosen is written."""

from __future__ import annotations

from plastron_tui.diagnostics import Span
from plastron_tui.language.expectations import Expectation
from plastron_tui.language.lowering import lower

from .completion import candidates, candidates_by_purpose, detail_of
from .history import Selection
from .state import TextState
from .view import EditorView
from .vocabulary import Vocabulary

_SMALL = 64 * 1024
"""A text of so many bytes is understood at once; a longer one waits for its diagnostics."""


class Completer:
    """Offers in a view's popup what may stand at the cursor of a text.

    Attributes:
        vocabulary: the names of the program, as of its last diagnostics; None before those.
    """

    def __init__(self, state: TextState, view: EditorView) -> None:
        self.vocabulary: Vocabulary | None = None
        self._state = state
        self._view = view
        self._replaced = Span(0, 0)

    def offer(self, expected: Expectation, *, is_asked: bool = False) -> None:
        """Offer what is expected at the cursor; where nobody asked for it, not on an empty line."""
        state, session = self._state, self._state.buffer.session
        if not state.selection.is_empty or (
            not is_asked and expected.starts_line and not expected.prefix
        ):
            self._view.close_popup()
            return
        names = self.names
        found = candidates(expected, names, session)
        if not found and is_asked:
            found = candidates_by_purpose(expected, names, session)
        if not found or (len(found) == 1 and found[0].text == expected.prefix):
            self._view.close_popup()
            return
        self._replaced = self._replaced_by(expected)
        self._view.offer(
            found,
            lambda candidate: detail_of(candidate, expected, names, session),
            self._replaced.start,
        )

    @property
    def names(self) -> Vocabulary:
        """The names of the program, as it was last understood; a short one is understood now."""
        if self.vocabulary is None:
            session = self._state.buffer.session
            if self._state.buffer.size > _SMALL:
                return Vocabulary(lower(type(session.document)()), type(session.workspace)())
            self.vocabulary = Vocabulary(session.program, session.workspace)
        return self.vocabulary

    def _replaced_by(self, expected: Expectation) -> Span:
        """Return the range that a candidate replaces: the word, or the quote so far."""
        span, prefix = expected.span, expected.prefix
        written = self._state.buffer.text[span.start : span.end]
        is_open = prefix[:1] == "'" and not (len(written) > 1 and written.endswith(b"'"))
        return Span(span.start, self._state.cursor if is_open else span.end)

    def accept(self) -> None:
        """Write what is marked in the popup, and what follows it if the line ends there."""
        candidate, span = self._view.popup.current, self._replaced
        if candidate is None:
            return
        state, buffer = self._state, self._state.buffer
        rest = buffer.text[span.end : buffer.end(buffer.row(span.end))]
        text = candidate.text
        if candidate.after and (not rest.strip() or candidate.after == "="):
            text += candidate.after if not rest.startswith(b"=") else ""
        new = text.encode("utf-8")
        at = span.start + len(new)
        state.history.close()
        state.apply([(span.start, span.end, new)], Selection(at, at))
