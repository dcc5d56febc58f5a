"""Finding and replacing in the text of an editor."""

from __future__ import annotations

from collections.abc import Callable

from .search import Search
from .state import Splice, TextState
from .view import EditorView


class Finder:
    """Goes through the matches of a search, marks them in the view, and replaces them."""

    def __init__(self, state: TextState, view: EditorView, done: Callable[[], None]) -> None:
        """Find in a text.

        Args:
            state: the text.
            view: what shows it.
            done: shows what was done to the text.
        """
        self.search = Search()
        self._searched = b""
        self._state = state
        self._view = view
        self._done = done

    @property
    def _here(self) -> tuple[int, int]:
        return self._state.selection.start, self._state.selection.end

    @property
    def count(self) -> str:
        """Which of the matches is selected, or why there are none; empty without a search."""
        search = self.search
        if search.problem or search.pattern is None:
            return search.problem
        if not search.spans:
            return "none"
        at = search.spans.index(self._here) + 1 if self._here in search.spans else "–"
        return f"{at} of {len(search.spans)}"

    def find(self, what: str, *, is_regex: bool, is_case_sensitive: bool) -> None:
        """Look for something else, and go to the first match from the cursor on."""
        self.search = Search.make(what, is_regex=is_regex, is_case_sensitive=is_case_sensitive)
        self._run()
        self._view.painter.matches = self.search.within
        self._select(self.search.step(self._here[0], 1))

    def step(self, by: int) -> None:
        """Go to the next match, or with -1 to the one before."""
        self._run_if_edited()
        start, end = self._here
        is_at_match = start < end or self._here in self.search.spans
        self._select(self.search.step(start + 1 if by > 0 and is_at_match else start, by))

    def replace(self, template: str) -> None:
        """Replace the selected match, and go to the next one.

        Raises:
            ValueError: the template names a group that is not there.
        """
        self._run_if_edited()
        if self._here in self.search.spans:
            self._replace([self._here], template)
        self.step(1)

    def replace_all(self, template: str) -> int:
        """Replace all matches, as one step to undo; return how many there were.

        Raises:
            ValueError: the template names a group that is not there.
        """
        self._run_if_edited()
        return self._replace(self.search.spans, template)

    def stop(self) -> None:
        """Mark the matches no longer."""
        self._view.painter.matches = None
        self._view.refresh()

    def _run(self) -> None:
        self._searched = self._state.buffer.text
        self.search.run(self._searched)
        self._view.refresh()

    def _run_if_edited(self) -> None:
        if self._searched is not self._state.buffer.text:
            self._run()

    def _select(self, span: tuple[int, int] | None) -> None:
        if span is not None:
            self._state.select(*span)
            self._done()

    def _replace(self, spans: list[tuple[int, int]], template: str) -> int:
        normalized = self._state.buffer.normalized
        splices: list[Splice] = [
            (*span, normalized(self.search.replaced(span, template))) for span in spans
        ]
        self._state.apply(splices)
        self._done()
        self._run()
        return len(splices)
