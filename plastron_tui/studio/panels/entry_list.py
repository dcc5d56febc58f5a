"""A list of entries that can be folded: it draws what is in sight, however many there are."""

from __future__ import annotations

from collections.abc import Mapping
from typing import ClassVar

from rich.segment import Segment
from rich.style import Style
from textual import events
from textual.binding import Binding, BindingType
from textual.geometry import Region, Size
from textual.reactive import reactive
from textual.scroll_view import ScrollView
from textual.strip import Strip

from .entry import Entries, Entry
from .entry_keys import Pointing
from .entry_lines import empty_rows, entry_line
from .styles import COMPONENTS, Line, Toned


class EntryList(Pointing, Toned, ScrollView, can_focus=True):
    """Entries, one a line, with a cursor."""

    DEFAULT_CSS = "EntryList { background: $background; height: 1fr; overflow: auto auto; }"
    COMPONENT_CLASSES: ClassVar[set[str]] = {*COMPONENTS, "entry-list--cursor", "entry-list--here"}
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("up,k", "move(-1)", "Up", show=False, id="panel.up"),
        Binding("down,j", "move(1)", "Down", show=False, id="panel.down"),
        Binding("pageup", "page(-1)", "Page up", show=False, id="panel.page_up"),
        Binding("pagedown", "page(1)", "Page down", show=False, id="panel.page_down"),
        Binding("home", "move(-1000000)", "First", show=False, id="panel.first"),
        Binding("end", "move(1000000)", "Last", show=False, id="panel.last"),
        Binding("space,left,right", "fold", "Fold", show=False, id="panel.fold"),
        Binding("enter", "choose", "Go there", id="panel.choose", tooltip="Go to the statement"),
    ]

    index: reactive[int] = reactive(0, repaint=False)

    def __init__(self, *, id: str | None = None, empty: str = "") -> None:  # noqa: A002
        super().__init__(id=id)
        self.entries = Entries(empty=empty)
        self._folded: set[str] = set()
        self._shown: list[Entry] = []
        self._rows: dict[str, int] = {}
        self._here: str | None = None
        self.remarks: Mapping[str, str] = {}
        """What is wrong with entries at the left, by their text, besides their warnings."""

    @property
    def current(self) -> Entry | None:
        """The entry that the cursor is on."""
        return self._shown[self.index] if 0 <= self.index < len(self._shown) else None

    def show(self, entries: Entries | None) -> None:
        """Show other entries, None for no; the cursor stays on the entry of the same key."""
        if entries is self.entries:
            return
        entries = entries or Entries()
        current = self.current
        self.entries = entries
        self._lay_out()
        row = None if current is None else self._rows.get(current.key)
        self.index = max(0, min(self.index if row is None else row, len(self._shown) - 1))

    def follow(self, offset: int) -> Entry | None:
        """Light the entry of the statement at an offset, and return it."""
        entry = self.entries.at(offset)
        key = None if entry is None else entry.whole
        if key == self._here:
            return entry
        self._here = key
        row = None if key is None else self._rows.get(key)
        if row is not None and not self.has_focus:
            self.index = row
            self._reveal(row)
        self.refresh()
        return entry

    def remark(self, remarks: Mapping[str, str]) -> None:
        """Show other remarks."""
        if remarks != self.remarks:
            self.remarks = remarks
            self.refresh()

    def _lay_out(self) -> None:
        shown: list[Entry] = []
        depth: int | None = None
        for entry in self.entries.all:
            if depth is not None and entry.depth > depth:
                continue
            depth = entry.depth if entry.key in self._folded else None
            shown.append(entry)
        self._shown = shown
        self._rows = {entry.key: row for row, entry in enumerate(shown)}
        self.virtual_size = Size(1, self._count_rows())
        self.refresh()

    def _count_rows(self) -> int:
        """Return how many rows the entries take, now that others are shown."""
        return len(self._shown)

    def _number_at(self, row: int) -> int:
        """Return the number of the entry that is drawn in a row."""
        return row

    def watch_index(self, old: int, new: int) -> None:
        """Draw the two lines again."""
        top = self.scroll_offset.y
        for row in (old, new):
            self.refresh(Region(0, row - top, self.size.width, 1))

    def _reveal(self, row: int) -> None:
        region = Region(0, row, 1, 1)
        self.scroll_to_region(region, animate=False, force=True, x_axis=False)

    def action_move(self, by: int) -> None:
        """Move the cursor."""
        if self._shown:
            last = len(self._shown) - 1
            at = max(0, min(last, self.index + by))
            if by > 0 and at < last and self._whole_at(at) == self._whole_at(self.index):
                at += 1
            self._reveal(at)
            # What belongs together is passed in one step.
            self.index = self._whole_at(at)
            self._reveal(self.index)
            self.tell_current()

    def _whole_at(self, row: int) -> int:
        """Return the number of the entry that the one at a row is a part of, or its own."""
        while 0 < row < len(self._shown) and self._shown[row].part_of:
            row -= 1
        return row

    def action_page(self, by: int) -> None:
        """Move the cursor by a page."""
        self.action_move(by * max(1, self.size.height - 1))

    def action_fold(self) -> None:
        """Fold or unfold the entry, or the one that it belongs to."""
        row = self.index
        while 0 < row < len(self._shown) and not self._shown[row].is_branch:
            row -= 1
        if 0 <= row < len(self._shown) and self._shown[row].is_branch:
            self._folded ^= {self._shown[row].key}
            self._lay_out()
            self.index = row
            self._reveal(row)

    def on_click(self, event: events.Click) -> None:
        """Choose the entry under the mouse; its sign folds it."""
        row = self._number_at(event.y + self.scroll_offset.y)
        if not 0 <= row < len(self._shown):
            return
        self.index = self._whole_at(row)
        entry = self._shown[row]
        if entry.is_branch and event.x <= 2 * entry.depth + 1:
            self.action_fold()
        else:
            self.action_choose()

    def render_line(self, y: int) -> Strip:
        """Draw a line."""
        width = self.scrollable_content_region.width
        base = self.rich_style
        row = y + self.scroll_offset.y
        if not self._shown:
            return self._render_empty(y, width, base)
        if row >= len(self._shown):
            return Strip.blank(width, base)
        base, is_lit = self._style_of(row)
        segments = [
            Segment(text, base if is_lit else base + self.tone(tone))
            for text, tone in self._line(self._shown[row], width)
        ]
        return Strip(segments).adjust_cell_length(width, base)

    def _style_of(self, number: int) -> tuple[Style, bool]:
        """Return what an entry is drawn on, and whether it is the one that the keys are for."""
        if self.has_focus and self._whole_at(number) == self._whole_at(self.index):
            return self.rich_style + self.tone("cursor", "entry-list"), True
        if self._shown[number].whole == self._here:
            return self.rich_style + self.tone("here", "entry-list"), False
        return self.rich_style, False

    def _render_empty(self, y: int, width: int, base: Style) -> Strip:
        rows = empty_rows(self.entries.empty, width)
        if y == 0 or y > len(rows):
            return Strip.blank(width, base)
        segments = [Segment(text, base + self.tone(tone)) for text, tone in rows[y - 1]]
        return Strip(segments).adjust_cell_length(width, base)

    def _line(self, entry: Entry, width: int) -> Line:
        remark = self.remarks.get(entry.text) if entry.depth == 0 else None
        return entry_line(entry, width, is_folded=entry.key in self._folded, remark=remark)
