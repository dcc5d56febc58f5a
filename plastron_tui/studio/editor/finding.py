"""Finding, replacing, and going to a line."""

from __future__ import annotations

from typing import TYPE_CHECKING, ClassVar

from textual.binding import Binding, BindingType

from .base import EditorBase
from .search import Search

if TYPE_CHECKING:
    from .bars import FindBar, PromptBar


class FindingActions(EditorBase):
    """Drives the bars."""

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("ctrl+f", "find", "Find", show=False, id="editor.find"),
        Binding("ctrl+r", "replace", "Replace", show=False, id="editor.replace"),
        Binding("f3", "find_next", "Find next", show=False, id="editor.find_next"),
        Binding(
            "shift+f3,f15,alt+p",
            "find_previous",
            "Find previous",
            show=False,
            id="editor.find_previous",
        ),
        Binding("ctrl+g", "go_to_line", "Go to line", show=False, id="editor.go_to_line"),
    ]

    search: Search = Search()
    _searched: bytes = b""

    def action_find(self) -> None:
        """Ask what to find."""
        self._open_bar(replace=False)

    def action_replace(self) -> None:
        """Ask what to find, and what to put in its place."""
        self._open_bar(replace=True)

    def _open_bar(self, *, replace: bool) -> None:
        self.view.close_popup()
        selected = self.state.selected
        what = selected.decode("utf-8", "replace") if b"\n" not in selected else ""
        self.with_bars(lambda: self.find_bar.open(what, replace=replace))

    def on_find_bar_wanted(self, message: FindBar.Wanted) -> None:
        """Find it, and go to the first match from the cursor on."""
        message.stop()
        bar = self.find_bar
        self.search = Search.make(
            bar.what, is_regex=bar.is_regex, is_case_sensitive=bar.is_case_sensitive
        )
        self._run_search()
        self.view.matches = self.search.within
        span = self.search.step(self.selection.start, 1)
        if span is not None and bar.what:
            self._select_match(span)
        else:
            self.view.refresh()

    def _run_search(self) -> None:
        self.search.run(self.text)
        self._searched = self.text
        self._say_count()

    def _say_count(self) -> None:
        search, selection = self.search, self.selection
        if search.problem:
            self.find_bar.say(search.problem)
        elif not search.spans:
            self.find_bar.say("none" if self.find_bar.what else "")
        else:
            here = (selection.start, selection.end)
            at = search.spans.index(here) + 1 if here in search.spans else "–"
            self.find_bar.say(f"{at} of {len(search.spans)}")

    def _select_match(self, span: tuple[int, int]) -> None:
        self.state.select(*span)
        self.done()
        self.view.refresh()
        self._say_count()

    def _step(self, by: int) -> None:
        if self._searched is not self.text:
            self._run_search()
        selection = self.selection
        here = (selection.start, selection.end)
        is_at_match = not selection.is_empty or here in self.search.spans
        offset = selection.start + 1 if by > 0 and is_at_match else selection.start
        span = self.search.step(offset, by)
        if span is not None:
            self._select_match(span)

    def action_find_next(self) -> None:
        """Go to the next match."""
        self._step(1)

    def action_find_previous(self) -> None:
        """Go to the match before."""
        self._step(-1)

    def on_find_bar_step(self, message: FindBar.Step) -> None:
        """Go to another match, the bar staying open."""
        message.stop()
        self._step(message.by)

    def on_find_bar_replace(self, message: FindBar.Replace) -> None:
        """Replace the selected match, or all."""
        message.stop()
        if self._searched is not self.text:
            self._run_search()
        here = (self.selection.start, self.selection.end)
        if message.every:
            spans = self.search.spans
        elif here in self.search.spans:
            spans = [here]
        else:
            self._step(1)
            return
        template, normalized = self.find_bar.replacement, self.state.buffer.normalized
        try:
            splices = [
                (start, end, normalized(self.search.replaced((start, end), template)))
                for start, end in spans
            ]
        except ValueError as error:
            self.find_bar.say(str(error))
            return
        self.state.apply(splices)
        self.done()
        self._run_search()
        if message.every:
            self.find_bar.say(f"{len(splices)} replaced")
            self.view.refresh()
        else:
            self._step(1)

    def on_find_bar_closed(self, message: FindBar.Closed) -> None:
        """Take the marks away and go back to the text."""
        message.stop()
        self.view.matches = None
        self.view.refresh()
        self.view.focus()

    def action_go_to_line(self) -> None:
        """Ask for a line, and for a column after a colon."""
        self.with_bars(lambda: self.prompt_bar.ask("go to line", "", self._go_to_line))

    def _go_to_line(self, answer: str) -> None:
        line, _, column = answer.strip().partition(":")
        if not line.isdecimal() or not (column or "1").isdecimal():
            self.app.notify(f"no line number: {answer}", severity="warning", markup=False)
            return
        buffer = self.state.buffer
        row = min(max(int(line) - 1, 0), buffer.row_count - 1)
        self.go_to(buffer.at_cell(row, max(int(column or "1") - 1, 0)))

    def on_prompt_bar_closed(self, message: PromptBar.Closed) -> None:
        """Go back to the text."""
        message.stop()
        self.view.focus()
