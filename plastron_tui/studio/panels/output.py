"""What the nodes print that run."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import compress
from typing import TYPE_CHECKING, ClassVar

from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Vertical

from .filter_bar import FilterBar
from .log_view import LogView
from .output_log import Change, OutputLog, Record, printed_record
from .styles import Lines

if TYPE_CHECKING:
    from typing_extensions import Self


class OutputPanel(Vertical):
    """Lines as they are printed, of which the last ones are kept."""

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("enter", "unfold", "Unfold", id="output.unfold",
                tooltip="Show all of long lines, or the first rows of each again"),
        Binding("slash", "filter", "Filter", id="output.filter",
                tooltip="Show only the lines with certain words in them"),
        Binding("t", "times", "Times", id="output.times",
                tooltip="Show when each line came, or do not"),
    ]  # fmt: skip

    def __init__(self, *, id: str | None = None) -> None:  # noqa: A002 - Textual's word
        super().__init__(id=id)
        self.view = LogView(id="output-lines")
        self._bar: FilterBar | None = None
        self.printed = OutputLog()
        self._words: tuple[str, ...] = ()
        self._is_shown: list[bool] = []
        self._has_times = False

    def compose(self) -> ComposeResult:
        """Make the lines; the filter is made when somebody asks for it."""
        yield self.view

    @property
    def text(self) -> str:
        """What is shown, without its colours."""
        return self.view.text

    @property
    def lines(self) -> Lines:
        """The lines that are shown."""
        return self.view.lines

    def focus(self, scroll_visible: bool = True) -> Self:
        """Give the lines the focus."""
        self.view.focus(scroll_visible)
        return self

    def show_log(self, log: OutputLog) -> None:
        """Show what other nodes have printed, and add to that from now on."""
        if log is not self.printed:
            self.printed = log
            self._show_all()

    def begin(self, title: str) -> None:
        """Show what is started, and nothing of what was printed before."""
        self.printed.clear()
        self.printed.add([Record("", title, "quiet")])
        self._show_all()

    def add(self, printed: Iterable[str], end: Record | None = None) -> None:
        """Show lines that were printed; `end` says how the nodes ended."""
        records = [*map(printed_record, printed)]
        if end is not None:
            records.append(end)
        self._show_changed(self.printed.add(records))

    def _show_changed(self, change: Change) -> None:
        """Show the records that are other ones; keep the lines of those that are not."""
        dropped, start = change
        new = self.printed.records[start - dropped :]
        before, found = self._is_shown, [record.matches(self._words) for record in new]
        lines = self._lines(compress(new, found))
        had_long = self.view.has_long
        self.view.splice(sum(before[:dropped]), sum(before[:start]), lines)
        if self.view.has_long and not had_long:
            self.refresh_bindings()
        self._is_shown = [*before[dropped:start], *found]
        self._say_count()

    def _show_all(self) -> None:
        records = self.printed.records
        self._is_shown = [record.matches(self._words) for record in records]
        self.view.show(self._lines(compress(records, self._is_shown)), follow=True)
        self._say_count()

    def _say_count(self) -> None:
        if self._bar is not None:
            self._bar.say(sum(self._is_shown), len(self._is_shown))

    def _lines(self, records: Iterable[Record]) -> Lines:
        return tuple(self.printed.line(each, with_time=self._has_times) for each in records)

    def action_unfold(self) -> None:
        """Show all of long lines, or their first rows again."""
        self.view.toggle_whole()

    def action_times(self) -> None:
        """Show when each line came, or do not."""
        self._has_times = not self._has_times
        self._show_all()

    def check_action(self, action: str, parameters: tuple[object, ...]) -> bool | None:
        """Offer what letters do where no words are being typed."""
        if action == "unfold" and not self.view.has_long:
            return False
        is_typing = self._bar is not None and self._bar.field.has_focus
        return not is_typing or action not in ("filter", "times", "unfold")

    async def action_filter(self) -> None:
        """Ask for the words that lines have to have."""
        if self._bar is None:
            self._bar = FilterBar("output", "a node, or words", self.show_found, self.focus)
            await self.mount(self._bar)
        self._bar.ask()
        self._show_all()

    def show_found(self, words: tuple[str, ...]) -> None:
        """Show the lines with these words."""
        self._words = words
        self._show_all()
