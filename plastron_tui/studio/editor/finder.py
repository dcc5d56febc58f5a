"""Finding and replacing in the text of an editor."""

from __future__ import annotations

from collections.abc import Callable

from .jumps import Jumps
from .search import Found, Search
from .search_thread import SearchThread
from .state import Splice, TextState
from .view import EditorView


class Finder:
    """Goes through the matches of a search, marks them in the view, and replaces them."""

    def __init__(
        self, state: TextState, view: EditorView, done: Callable[[], None], jumps: Jumps
    ) -> None:
        """Find in a text.

        Args:
            state: the text.
            view: what shows it.
            done: shows what was done to the text.
            jumps: goes from match to match.
        """
        self.search = Search()
        self.say: Callable[[str], None] = lambda _: None
        """Shows how far a search is, and what came of it."""
        self.is_searching = False
        self._searched = b""
        self._then: Callable[[], None] | None = None
        self._thread = SearchThread(view.call_later)
        self._state = state
        self._view = view
        self._done = done
        self._jumps = jumps

    @property
    def _here(self) -> tuple[int, int]:
        return self._state.selection.start, self._state.selection.end

    @property
    def count(self) -> str:
        """Which of the matches is selected, or why there are none; empty without a search."""
        search = self.search
        if self.is_searching:
            return "searching …"
        if search.problem or search.pattern is None:
            return search.problem
        if not search.spans:
            return "none"
        at = search.spans.index(self._here) + 1 if self._here in search.spans else "–"
        return f"{at} of {len(search.spans)}"

    def find(self, what: str, *, is_regex: bool, is_case_sensitive: bool) -> None:
        """Look for something else, and go to the first match from the cursor on."""
        self.search = Search.make(what, is_regex=is_regex, is_case_sensitive=is_case_sensitive)
        self._view.painter.matches = self.search.within
        start = self._here[0]
        self._run(lambda: self._select(self.search.step(start, 1)))

    def step(self, by: int) -> None:
        """Go to the next match, or with -1 to the one before."""
        self._when_found(lambda: self._step(by))

    def _step(self, by: int) -> None:
        start, end = self._here
        is_at_match = start < end or self._here in self.search.spans
        self._select(self.search.step(start + 1 if by > 0 and is_at_match else start, by))

    def replace(self, template: str) -> None:
        """Replace the selected match, and go to the next one; say where that cannot be."""
        self._when_found(lambda: self._replace_here(template))

    def _replace_here(self, template: str) -> None:
        if self._here not in self.search.spans:
            self._step(1)
        elif self._replace([self._here], template):
            self._run(lambda: self._step(1))

    def replace_all(self, template: str) -> None:
        """Replace all matches, as one step to undo, and say how many there were."""
        self._when_found(lambda: self._replace_all(template))

    def _replace_all(self, template: str) -> None:
        spans = self.search.spans
        if self._replace(spans, template):
            self._run(lambda: self.say(f"{len(spans)} replaced"))

    def stop(self) -> None:
        """Mark the matches no longer."""
        self._then = None
        self._view.painter.matches = None
        self._view.refresh()

    def forget(self) -> None:
        """Forget what was found, and what was to be done then: another text is shown."""
        self._then = None
        self._searched = b""
        self.search.take(Found())
        if self.is_searching:
            self.is_searching = False
            self.say("")

    def _when_found(self, then: Callable[[], None]) -> None:
        """Do something once it is known what the text as it is has of the search."""
        if self._searched is not self._state.buffer.text:
            self._run(then)
        elif self.is_searching:
            self._then = then
        else:
            then()

    def _run(self, then: Callable[[], None]) -> None:
        """Search the text as it is, then do something; a plain text is found at once."""
        search, text = self.search, self._state.buffer.text
        self._searched = text
        self._then = then
        self.is_searching = True
        if search.is_regex:
            self._thread.run(search, text, lambda found: self._found(search, text, found))
            if self.is_searching:
                self.say(self.count)
        else:
            self._found(search, text, search.find(text))

    def _found(self, search: Search, text: bytes, found: Found) -> None:
        if search is not self.search or text is not self._searched:
            return
        self.is_searching = False
        search.take(found)
        self._view.refresh()
        then, self._then = self._then, None
        if text is not self._state.buffer.text and then is not None:
            # It was edited meanwhile: what was found is not there any more.
            self._run(then)
            return
        self.say(self.count)
        if then is not None:
            then()

    def _select(self, span: tuple[int, int] | None) -> None:
        if span is not None:
            self._jumps.jump(*span, walk="find")
            self._done()
        self.say(self.count)

    def _replace(self, spans: list[tuple[int, int]], template: str) -> bool:
        """Replace matches; tell whether that can be, and say it where it cannot."""
        normalized = self._state.buffer.normalized
        try:
            splices: list[Splice] = [
                (*span, normalized(self.search.replaced(span, template))) for span in spans
            ]
        except ValueError as error:
            self.say(str(error))
            return False
        self._state.apply(splices)
        self._done()
        return True
