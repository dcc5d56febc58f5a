"""When completion is offered, and how what was chosen is written."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.diagnostics import Span

from .history import Selection
from .preload import is_preloaded
from .state import Splice, TextState
from .view import EditorView

if TYPE_CHECKING:
    from plastron_tui.language.expectations import Expectation

    from .vocabulary import Vocabulary

_SMALL = 64 * 1024
"""A text of so many bytes is understood at once; a longer one waits for its diagnostics."""


class _Given(NamedTuple):
    """A blank that completion left behind a word.

    Attributes:
        text: the text with it.
        splice: what writes the word without it, in terms of the text before.
    """

    text: bytes
    splice: Splice


class Completer:
    """Offers in a view's popup what may stand at the cursor of a text.

    Attributes:
        vocabulary: the names of the program, as of its last diagnostics; None before those.
        waits: whether those are on their way, so that nothing has to be understood for a key.
    """

    def __init__(self, state: TextState, view: EditorView) -> None:
        self.vocabulary: Vocabulary | None = None
        self.waits = False
        self._without_names: tuple[bytes, int, bool] | None = None
        self._state = state
        self._view = view
        self._replaced = Span(0, 0)
        self._given: _Given | None = None

    def offer(self, expected: Expectation, *, is_asked: bool = False) -> None:
        """Offer what is expected at the cursor; where nobody asked for it, not on an empty line."""
        state = self._state
        if not state.selection.is_empty or (
            not is_asked and expected.starts_line and not expected.prefix
        ):
            self._view.close_popup()
            return
        names = self.names
        self._offer(expected, names, is_asked=is_asked)
        if self.vocabulary is None:
            self._without_names = (state.buffer.text, state.cursor, self._view.popup.is_open)

    @property
    def is_ready(self) -> bool:
        """Whether what is offered needs no module that is not there yet."""
        return not self.waits or is_preloaded()

    def offer_later(self) -> None:
        """Offer, once the names are known, what may stand at the cursor then."""
        state = self._state
        self._without_names = (state.buffer.text, state.cursor, self._view.popup.is_open)

    def learn(self, vocabulary: Vocabulary) -> None:
        """Take the names of the program; what was offered without them is offered anew."""
        self.vocabulary = vocabulary
        before, self._without_names = self._without_names, None
        state = self._state
        if before == (state.buffer.text, state.cursor, self._view.popup.is_open):
            from plastron_tui.language.expectations import expected_at

            self.offer(expected_at(state.buffer.session.document, state.cursor))

    def _offer(self, expected: Expectation, names: Vocabulary, *, is_asked: bool) -> None:
        from .completion import candidates, candidates_by_purpose, detail_of

        session = self._state.buffer.session
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
            from .vocabulary import Vocabulary

            session = self._state.buffer.session
            if self.waits or self._state.buffer.size > _SMALL:
                from plastron_tui.language.lowering import Program
                from plastron_tui.model.workspace import Workspace

                return Vocabulary(Program(()), Workspace())
            self.vocabulary = Vocabulary(session.program, session.workspace)
        return self.vocabulary

    def _replaced_by(self, expected: Expectation) -> Span:
        """Return the range that a candidate replaces: the word, or the quote so far."""
        span, prefix = expected.span, expected.prefix
        written = self._state.buffer.text[span.start : span.end]
        is_open = prefix[:1] == "'" and not (len(written) > 1 and written.endswith(b"'"))
        return Span(span.start, self._state.cursor if is_open else span.end)

    def accept(self) -> bool:
        """Write what is marked in the popup, and what follows it if the line ends there.

        Where the sentence goes on, that is a blank at least: True says that there is one.
        """
        candidate, span = self._view.popup.current, self._replaced
        if candidate is None:
            return False
        state, buffer = self._state, self._state.buffer
        end = buffer.end(buffer.row(span.end))
        rest = buffer.text[span.end : end]
        text = candidate.text
        if candidate.after and (not rest.strip() or candidate.after == "="):
            text += candidate.after if not rest.startswith(b"=") else ""
        new = text.encode("utf-8")
        before = buffer.text[buffer.start(buffer.row(span.start)) : span.start]
        is_given = not rest.strip() and not text.endswith(" ") and goes_on(before + new)
        splice = (span.start, end if is_given else span.end, new)
        state.history.close()
        self._write(splice, b" " if is_given else b"")
        self._given = _Given(buffer.text, splice) if is_given else None
        return is_given

    def _write(self, splice: Splice, blank: bytes) -> None:
        start, end, new = splice
        at = start + len(new) + len(blank)
        self._state.apply([(start, end, new + blank)], Selection(at, at))

    def takes_blank(self) -> bool:
        """Tell whether the blank that is typed is there already, and let it count as typed."""
        given, state = self._given, self._state
        self._given = None
        if given is None or given.text is not state.buffer.text:
            return False
        start, _, new = given.splice
        return state.selection == (start + len(new) + 1,) * 2

    def take_blank_back(self) -> None:
        """Remove the blank that was left for a next word, because there is none."""
        given, state = self._given, self._state
        self._given = None
        if given is None or given.text is not state.buffer.text:
            return
        selection = state.selection
        start, _, new = given.splice
        after = start + len(new)
        # In the place of the step that wrote the word: it is undone at once.
        state.undo()
        self._write(given.splice, b"")
        state.select(*(at - (at > after) for at in selection))

    def moved(self) -> None:
        """Leave no blank behind at the end of a line that the cursor has left."""
        given, buffer = self._given, self._state.buffer
        if given is None:
            return
        if given.text is not buffer.text:
            self._given = None
        elif self._state.row != buffer.row(given.splice[0]):
            self.take_blank_back()


def goes_on(line: bytes) -> bool:
    """Tell whether the sentence that a line begins with needs another word."""
    from plastron_tui.language import Document, Slot
    from plastron_tui.language.expectations import expected_at

    expected = expected_at(Document(line + b" "), len(line) + 1)
    if expected.declaration is None:
        return bool(expected.keywords)
    slot = expected.slot
    if slot is not None and slot.kind.form.is_open and expected.written:
        return False
    return isinstance(expected.element, (str, Slot))
