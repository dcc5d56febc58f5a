"""The rows of a text on the screen: what is drawn, what is drawn again, what scrolls."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Protocol

from textual import events
from textual.geometry import Offset, Region, Size

from . import motions
from .completion import Candidate
from .drawing import DrawnText
from .geometry import Geometry, scrolled_to
from .highlights import highlight
from .history import Selection
from .marks import Marks
from .state import Edited, TextState

_WIDTH_STEP = 32
_MOST_MEASURED = 2 * 1024 * 1024
"""A text of more bytes takes longer to measure than a key may."""


class Owner(Protocol):
    """Who edits what a view shows, and is told of keys and of the mouse as they come."""

    def typed(self, text: str) -> None:
        """Take a character that was typed."""

    def pasted(self, text: str) -> None:
        """Take a text that was pasted."""

    def selected(self, anchor: int, head: int) -> None:
        """Select what the mouse selected."""

    def picked(self) -> None:
        """Take the entry of the popup that is marked, which the mouse picked."""


class EditorView(DrawnText, can_focus=True, inherit_bindings=False):
    """Draws a `TextState`, and tells of keys and of the mouse."""

    owner: Owner
    """Set by the owner itself, before the view is mounted."""

    DEFAULT_CSS = """
    EditorView { width: 1fr; height: 1fr; scrollbar-gutter: stable; overflow-x: auto; }
    """

    def __init__(self, state: TextState) -> None:
        super().__init__(state)
        self._edits: list[Edited] = []
        self._shown = state.selection
        self._drag_from: int | None = None
        state.listeners.append(self._heard)

    def set_state(self, state: TextState) -> None:
        """Show another text, from its top."""
        self.state = state
        self.marks = Marks()
        self.geometry = Geometry(state, self.marks)
        self.paint.clear()
        self._edits.clear()
        self._shown = state.selection
        state.listeners.append(self._heard)
        self._fit()
        self.scroll_to(0, 0, animate=False, force=True)
        self.refresh()

    def set_marks(self, marks: Marks) -> None:
        """Show other mistakes."""
        self.marks = self.geometry.marks = marks
        self._place_lines()
        self.refresh()

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
        """Lay out for another width."""
        self._place_lines()

    def on_focus(self) -> None:
        """Show the cursor."""
        self._place_terminal_cursor()
        self.refresh()

    def on_blur(self) -> None:
        """Show that the cursor is elsewhere."""
        self.refresh()

    def _heard(self, edited: Edited) -> None:
        self.marks.edited(edited)
        self.geometry.lines.edited(edited)
        self._edits.append(edited)

    def sync(self, *, scroll: bool = True) -> None:
        """Draw again what an edit or a move of the cursor changed, and keep the cursor in sight."""
        state = self.state
        before, self._shown = self._shown, state.selection
        brackets = self.brackets
        if self._edits:
            self._refresh_edited()
        self.brackets = self._matching_brackets()
        if not (before.is_empty and state.selection.is_empty):
            self._refresh_rows(range(*self._span(before, state.selection)))
        else:
            for offset in {before.head, state.cursor}:
                row = state.buffer.row(min(offset, state.buffer.size))
                self._refresh_rows(range(row, row + 1))
        for pair in (brackets, self.brackets):
            if pair is not None and brackets != self.brackets:
                row = state.buffer.row(min(pair[0], state.buffer.size))
                self._refresh_rows(range(row, row + 1))
        if scroll:
            self.scroll_to_cursor()
        self._place_terminal_cursor()

    def _matching_brackets(self) -> tuple[int, int] | None:
        buffer, cursor = self.state.buffer, self.state.cursor
        around = buffer.text[max(0, cursor - 1) : cursor + 1]
        if not any(bracket in around for bracket in b"()[]{}"):
            return None
        literal = [
            (painted.start, painted.end)
            for painted in self.paint.get(self.state.row, ())
            if painted.capture.startswith(("string", "comment"))
        ]
        return motions.matching_brackets(buffer, cursor, literal)

    def _span(self, *selections: Selection) -> tuple[int, int]:
        buffer = self.state.buffer
        start = min(selection.start for selection in selections)
        end = max(selection.end for selection in selections)
        return buffer.row(min(start, buffer.size)), buffer.row(min(end, buffer.size)) + 1

    def _refresh_edited(self) -> None:
        edits, self._edits = self._edits, []
        if any(edited.old_rows != edited.new_rows for edited in edits):
            self.paint.clear()
            self.geometry.place_edited(edits)
            self._fit()
            self.refresh()
            return
        old = self.paint
        first, last = self.window()
        self.paint = highlight(self.state.buffer, first, last)
        touched = {row for edit in edits for row in range(edit.row, edit.row + edit.new_rows)}
        for row, paint in self.paint.items():
            if row in touched or old.get(row) != paint:
                self._refresh_rows(range(row, row + 1))
        if self.geometry.place_edited(edits):
            self.refresh()
        self._fit()

    def _refresh_rows(self, rows: range) -> None:
        top, height, width = self.scroll_offset.y, self.size.height, self.size.width
        first = max(0, self.geometry.lines.line_of(rows.start) - top)
        last = min(height, self.geometry.lines.line_of(rows.stop) - top)
        if first < last:
            self.refresh(Region(0, first, width, last - first))

    def repaint(self) -> None:
        """Ask for all highlights again, because the tree is now that of the text."""
        first, last = self.window()
        paint = highlight(self.state.buffer, first, last)
        for row in paint:
            if paint[row] != self.paint.get(row):
                self._refresh_rows(range(row, row + 1))
        self.paint = paint

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
        size = Size(width, height)
        if size != self.virtual_size:
            self.virtual_size = size

    def offer(
        self, candidates: Sequence[Candidate], detail: Callable[[Candidate], str], offset: int
    ) -> None:
        """Show the popup below an offset."""
        covered = self.popup.region if self.popup.is_open else None
        region, scroll = self.scrollable_content_region, self.scroll_offset
        place = self.geometry.place_of(offset)
        x = self.gutter_width + place.x - (0 if self.soft_wrap else scroll.x)
        self.popup.offer(candidates, detail, Offset(x, place.y - scroll.y), region.size)
        for changed in (covered, self.popup.region):
            if changed is not None:
                self.refresh(changed)

    def choose(self, by: int) -> None:
        """Mark another entry of the popup."""
        self.popup.choose(by)
        self.refresh(self.popup.region)

    def close_popup(self) -> None:
        """Show no popup."""
        if self.popup.is_open:
            self.popup.close()
            self.refresh(self.popup.region)

    def watch_scroll_y(self, old_value: float, new_value: float) -> None:
        """Let the popup go when its word does."""
        super().watch_scroll_y(old_value, new_value)
        self.close_popup()

    @property
    def page(self) -> int:
        """How many lines a page has."""
        return max(1, self.scrollable_content_region.height - 1)

    def scroll_to_cursor(self, *, center: bool = False) -> None:
        """Scroll as far as is needed to see the cursor, with some lines around it."""
        place = self.geometry.place_of(self.state.cursor)
        height = max(1, self.scrollable_content_region.height)
        scroll = Offset(0 if self.soft_wrap else self.scroll_offset.x, self.scroll_offset.y)
        if self.soft_wrap:
            place = Offset(0, place.y)
        to = scrolled_to(place, scroll, Size(self.text_width, height), center=center)
        if to != self.scroll_offset:
            self.scroll_to(*to, animate=False, force=True, immediate=True)

    @property
    def cursor_on_screen(self) -> Offset:
        """The cell of the screen that the cursor is in."""
        place = self.geometry.place_of(self.state.cursor)
        region, scroll = self.content_region, self.scroll_offset
        x = region.x + self.gutter_width + place.x - (0 if self.soft_wrap else scroll.x)
        return Offset(x, region.y + place.y - scroll.y)

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
            self.owner.typed(event.character)
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
        self.owner.pasted(event.text)

    def _offset_of(self, event: events.MouseEvent) -> int:
        place = event.get_content_offset_capture(self)
        x = place.x - self.gutter_width + (0 if self.soft_wrap else self.scroll_offset.x)
        return self.geometry.offset_at(x, place.y + self.scroll_offset.y)

    def on_mouse_down(self, event: events.MouseDown) -> None:
        """Put the cursor there; with shift, select up to there."""
        if event.button != 1:
            return
        event.stop()
        if self.popup.is_open and self.popup.region.contains(event.x, event.y):
            if self.popup.choose_at(event.y):
                self.owner.picked()
            return
        offset = self._offset_of(event)
        anchor = self.state.selection.anchor if event.shift else offset
        self._drag_from = anchor
        self.capture_mouse()
        self.owner.selected(anchor, offset)

    def on_mouse_move(self, event: events.MouseMove) -> None:
        """Select from where the button went down."""
        if self._drag_from is not None:
            event.stop()
            self.owner.selected(self._drag_from, self._offset_of(event))

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
        self.owner.selected(start, end)
