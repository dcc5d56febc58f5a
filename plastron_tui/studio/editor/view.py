"""The rows of a text on the screen: what is drawn again, what scrolls, keys and the mouse."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from textual import events
from textual.geometry import Offset, Region, Size
from textual.reactive import reactive
from textual.scroll_view import ScrollView
from textual.strip import Strip

from . import motions
from .card_box import CardBox
from .geometry import Geometry, scrolled_to
from .history import Selection
from .marks import Marks
from .owner import Owner
from .painter import Frame, Painter
from .palette import Palette, palette_of
from .popup import Popup
from .state import Edited, TextState

if TYPE_CHECKING:
    from .candidate import Candidate

_OVERSCAN = 8
_WIDTH_STEP = 32
_MOST_MEASURED = 2 * 1024 * 1024
"""A text of more bytes takes longer to measure than a key may."""


class EditorView(ScrollView, can_focus=True, inherit_bindings=False):
    """Shows a `TextState`, and tells its owner of keys and of the mouse."""

    DEFAULT_CSS = """
    EditorView { width: 1fr; height: 1fr; scrollbar-gutter: stable; overflow-x: auto; }
    """

    takes_bursts = True
    """A text that comes as keys, many at once, is put in as one: a terminal has pasted it."""
    takes_text = True

    soft_wrap: reactive[bool] = reactive(False)
    line_numbers: reactive[bool] = reactive(True)

    def __init__(self, state: TextState, owner: Owner) -> None:
        super().__init__(id="editor-view")
        self.state = state
        self.geometry = Geometry(state)
        self.painter = Painter(state, self.geometry, self.window)
        self.popup = Popup()
        self.card = CardBox()
        self._owner = owner
        self._palette: Palette | None = None
        self._edits: list[Edited] = []
        self._shown = state.selection
        self._drag_from: int | None = None
        self._height = 0
        state.listeners.append(self._heard)

    @property
    def marks(self) -> Marks:
        """The mistakes, where they are by now."""
        return self.geometry.marks

    def show_marks(self, marks: Marks) -> None:
        """Show other mistakes."""
        self.geometry.place_marks(marks)
        if self.geometry.width != self.text_width:
            self._place_lines()
        self._fit()
        self.refresh()

    def show_anew(self, scroll: tuple[int, int]) -> None:
        """Show a text that is another one as a whole, scrolled to a column and a row."""
        self.close_popup()
        self.painter.paint.clear()
        self.painter.brackets = None
        self._edits.clear()
        self._shown = self.state.selection
        self.geometry.marks = Marks()
        self._place_lines()
        self.refresh()
        self.scroll_to(*scroll, animate=False, force=True, immediate=True)
        self.scroll_to_cursor()  # the window may be smaller by now

    def recolor(self) -> None:
        """Draw in the colours of another theme."""
        self._palette = None
        self.refresh()

    def notify_style_update(self) -> None:
        """Follow colours that a style sheet changes."""
        super().notify_style_update()
        self._palette = None

    @property
    def palette(self) -> Palette:
        """The colours, made when they are first needed."""
        if self._palette is None:
            self._palette = palette_of(self)
        return self._palette

    @property
    def gutter_width(self) -> int:
        """The cells that signs and line numbers take."""
        if not self.line_numbers:
            return 0
        return max(3, len(str(self.state.buffer.row_count))) + 2

    @property
    def text_width(self) -> int:
        """The cells that are there for text; before there is a size, as many as most have."""
        width = self.scrollable_content_region.width
        return max(1, width - self.gutter_width) if width else self.geometry.width

    @property
    def _left(self) -> int:
        """The first cell of the text that is shown."""
        return 0 if self.soft_wrap else self.scroll_offset.x

    def window(self) -> tuple[int, int]:
        """Return the first and the last row on the screen, and some around them."""
        top = self.scroll_offset.y
        last_row = self.state.buffer.row_count - 1
        first, _ = self.geometry.lines.row_at(max(0, top - _OVERSCAN))
        last, _ = self.geometry.lines.row_at(top + self.size.height + _OVERSCAN)
        first = min(first, last_row)
        return first, max(first, min(last, last_row))

    def render_line(self, y: int) -> Strip:
        """Draw a line of the screen."""
        width = self.scrollable_content_region.width
        offers = self.popup.is_open
        frame = Frame(self.palette, width, self.gutter_width, self._left, self.has_focus, offers)
        strip = self.painter.draw(self.scroll_offset.y + y, frame)
        for box in (self.popup, self.card):
            if box.is_open and y in box.region.line_range:
                strip = box.over(strip, y, self.palette)
        return strip

    def on_mount(self) -> None:
        """Follow the theme."""
        self.app.theme_changed_signal.subscribe(self, lambda _: self.recolor())
        self.watch(self.app, "ansi_color", self.recolor, init=False)
        self._fit()

    def watch_soft_wrap(self) -> None:
        """Lay all rows out again."""
        self._place_lines()
        self._fit()
        self.refresh()

    def watch_line_numbers(self) -> None:
        """Draw with or without numbers."""
        self._fit()
        self.refresh()

    def on_resize(self) -> None:
        """Lay out for another width; keep the cursor in sight, if it was."""
        line = self.geometry.place_of(self.state.cursor).y - self.scroll_offset.y
        self._place_lines()
        if 0 <= line < self._height:
            self.scroll_to_cursor()
        self._height = self.scrollable_content_region.height

    def on_focus(self) -> None:
        """Show the cursor."""
        self._place_terminal_cursor()
        self.refresh()

    def on_blur(self) -> None:
        """Show that the cursor is elsewhere."""
        self.refresh()

    def _heard(self, edited: Edited) -> None:
        self.geometry.edited(edited)
        self._edits.append(edited)

    def sync(self, *, scroll: bool = True) -> None:
        """Draw again what an edit or a move of the cursor changed, and keep the cursor in sight."""
        state = self.state
        before, self._shown = self._shown, state.selection
        brackets = self.painter.brackets
        if self._edits:
            self._refresh_edited()
        self.painter.match_brackets()
        if not (before.is_empty and state.selection.is_empty):
            self._refresh_rows(range(*self._span(before, state.selection)))
        else:
            self._refresh_offsets(before.head, state.cursor)
        if brackets != self.painter.brackets:
            self._refresh_offsets(*(pair[0] for pair in (brackets, self.painter.brackets) if pair))
        if scroll:
            self.scroll_to_cursor()
        self._place_terminal_cursor()

    def _span(self, *selections: Selection) -> tuple[int, int]:
        buffer = self.state.buffer
        start = min(selection.start for selection in selections)
        end = max(selection.end for selection in selections)
        return buffer.row(min(start, buffer.size)), buffer.row(min(end, buffer.size)) + 1

    def _refresh_edited(self) -> None:
        edits, self._edits = self._edits, []
        if any(edited.old_rows != edited.new_rows for edited in edits):
            self.painter.paint.clear()
            self.geometry.place_edited(edits)
            self.refresh()
        else:
            touched = {row for edit in edits for row in range(edit.row, edit.row + edit.new_rows)}
            for row in touched.union(self.painter.highlight()):
                self._refresh_rows(range(row, row + 1))
            if self.geometry.place_edited(edits):
                self.refresh()
        self._fit()

    def _refresh_offsets(self, *offsets: int) -> None:
        """Draw the rows again in which these offsets are."""
        buffer = self.state.buffer
        for row in {buffer.row(min(offset, buffer.size)) for offset in offsets}:
            self._refresh_rows(range(row, row + 1))

    def _refresh_rows(self, rows: range) -> None:
        top, height, width = self.scroll_offset.y, self.size.height, self.size.width
        first = max(0, self.geometry.lines.line_of(rows.start) - top)
        last = min(height, self.geometry.lines.line_of(rows.stop) - top)
        if first < last:
            self.refresh(Region(0, first, width, last - first))

    def repaint(self) -> None:
        """Ask for all highlights again, because the tree is now that of the text."""
        for row in self.painter.highlight():
            self._refresh_rows(range(row, row + 1))

    def measure(self) -> None:
        """Take the scroll bar away that a line needed which is shorter by now."""
        if self.state.buffer.size <= _MOST_MEASURED:
            self.state.buffer.measure()
            self._fit()

    def _place_lines(self) -> None:
        """Find the rows that take more than one line of the screen, now that widths changed."""
        self.geometry.width = self.text_width
        self.geometry.is_wrapped = self.soft_wrap
        self.geometry.place_lines()
        self._fit()

    def _fit(self) -> None:
        """Let the scroll bars know how much text there is."""
        buffer = self.state.buffer
        height = self.geometry.height
        width = 0
        if not self.soft_wrap:
            wide = self.gutter_width + buffer.widest + 1
            width = -(-wide // _WIDTH_STEP) * _WIDTH_STEP
            there = self.scrollable_content_region.width
            if wide <= there:
                width = min(width, there)
        self.virtual_size = Size(width, height)

    def offer(
        self, candidates: Sequence[Candidate], detail: Callable[[Candidate], str], offset: int
    ) -> None:
        """Show the popup below an offset."""
        covered = [self.popup.region] if self.popup.is_open else []
        self._refresh_offsets(self.state.cursor)
        size = self.scrollable_content_region.size
        self.popup.offer(candidates, detail, self.cell_of(offset), size)
        self.refresh(self.popup.region, *covered)

    def choose(self, by: int) -> None:
        """Mark another entry of the popup."""
        self.popup.choose(by)
        self.refresh(self.popup.region)

    def close_popup(self) -> None:
        """Show no popup."""
        if self.popup.is_open:
            self.popup.close()
            self.refresh(self.popup.region)
            self._refresh_offsets(self.state.cursor)

    def watch_scroll_y(self, old_value: float, new_value: float) -> None:
        """Let the popup and the card go when their word does."""
        super().watch_scroll_y(old_value, new_value)
        self.close_popup()
        self.card.close()

    @property
    def page(self) -> int:
        """How many lines a page has."""
        return max(1, self.scrollable_content_region.height - 1)

    def scroll_to_cursor(self, *, center: bool = False) -> None:
        """Scroll as far as is needed to see the cursor, with some lines around it."""
        place = self.geometry.place_of(self.state.cursor)
        height = max(1, self.scrollable_content_region.height)
        scroll = Offset(self._left, self.scroll_offset.y)
        if self.soft_wrap:
            place = Offset(0, place.y)
        to = scrolled_to(place, scroll, Size(self.text_width, height), center=center)
        if to != self.scroll_offset:
            self.scroll_to(*to, animate=False, force=True, immediate=True)

    @property
    def cursor_on_screen(self) -> Offset:
        """The cell of the screen that the cursor is in."""
        return self.content_region.offset + self.cell_of(self.state.cursor)

    def cell_of(self, offset: int) -> Offset:
        """Return the cell of the view that a character is in; it may be out of sight."""
        place = self.geometry.place_of(offset)
        return Offset(self.gutter_width + place.x - self._left, place.y - self.scroll_offset.y)

    def _place_terminal_cursor(self) -> None:
        """Tell the terminal where its own cursor is, for input methods."""
        if self.has_focus and self.is_mounted:
            self.app.cursor_position = self.cursor_on_screen

    async def on_key(self, event: events.Key) -> None:
        """Take the characters, and the keys that are bound to the editor's own actions.

        Both at once and here: a key that is bound goes up to the app before its action runs, and
        what is typed after it would come first. What came while a key gave the focus to a bar is
        meant for the bar.
        """
        focused = self.screen.focused
        if focused is not self and focused is not None:
            event.stop()
            event.prevent_default()
            focused.post_message(events.Key(event.key, event.character))
            return
        if event.is_printable and event.character is not None:
            event.stop()
            event.prevent_default()
            self._owner.type_text(event.character)
            return
        bound = self.screen.active_bindings.get(event.key)
        if bound is not None and bound.enabled and bound.node is self.parent:
            event.stop()
            event.prevent_default()
            await self.app.run_action(bound.binding.action, bound.node)

    def on_paste(self, event: events.Paste) -> None:
        """Take what the terminal pastes."""
        event.stop()
        event.prevent_default()
        self._owner.insert_text(event.text)

    def _offset_of(self, event: events.MouseEvent) -> int:
        return self.offset_at(event.get_content_offset_capture(self))

    def offset_at(self, cell: Offset) -> int:
        """Return the offset of the character that is nearest to a cell of the view."""
        x = cell.x - self.gutter_width + self._left
        return self.geometry.offset_at(x, cell.y + self.scroll_offset.y)

    def on_mouse_down(self, event: events.MouseDown) -> None:
        """Put the cursor there; with shift, select up to there."""
        if event.button != 1:
            return
        event.stop()
        if self.popup.is_open and self.popup.region.contains(event.x, event.y):
            if self.popup.choose_at(event.y):
                self._owner.accept()
            return
        offset = self._offset_of(event)
        anchor = self.state.selection.anchor if event.shift else offset
        self._drag_from = anchor
        self.capture_mouse()
        self._owner.select_range(anchor, offset)

    def on_mouse_move(self, event: events.MouseMove) -> None:
        """Select from where the button went down."""
        if self._drag_from is not None:
            event.stop()
            self._owner.select_range(self._drag_from, self._offset_of(event))

    def on_mouse_up(self, event: events.MouseUp) -> None:
        """End the selection."""
        if self._drag_from is not None:
            event.stop()
            self._drag_from = None
            self.release_mouse()

    def on_click(self, event: events.Click) -> None:
        """Select the word with two clicks, the line with three."""
        if event.button != 1 or event.chain < 2:
            return
        buffer, offset = self.state.buffer, self._offset_of(event)
        if event.chain == 2:
            start, end = motions.word_at(buffer, offset)
        else:
            row = buffer.row(offset)
            start, end = buffer.start(row), buffer.next_start(row)
        self._owner.select_range(start, end)
