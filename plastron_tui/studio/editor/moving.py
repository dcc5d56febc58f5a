"""The keys that move the cursor and select."""

from __future__ import annotations

from collections.abc import Callable
from typing import ClassVar

from textual.binding import Binding, BindingType

from . import motions
from .base import EditorBase
from .buffer import Buffer


def _both(key: str, shifted: str, action: str, description: str) -> list[BindingType]:
    return [
        Binding(key, action, description, show=False, id=f"editor.{action}"),
        Binding(
            shifted,
            f"{action}(True)",
            f"{description}, selecting",
            show=False,
            id=f"editor.{action}-selecting",
        ),
    ]


class MovingActions(EditorBase):
    """Moves; each selects as well, with `extend`."""

    BINDINGS: ClassVar[list[BindingType]] = [
        *_both("up", "shift+up", "cursor_up", "Line up"),
        *_both("down", "shift+down", "cursor_down", "Line down"),
        *_both("left", "shift+left", "cursor_left", "Character left"),
        *_both("right", "shift+right", "cursor_right", "Character right"),
        *_both("ctrl+left,alt+left", "ctrl+shift+left", "word_left", "Word left"),
        *_both("ctrl+right,alt+right", "ctrl+shift+right", "word_right", "Word right"),
        *_both("home", "shift+home", "line_start", "Start of the line"),
        *_both("end", "shift+end", "line_end", "End of the line"),
        *_both("pageup", "shift+pageup", "page_up", "Page up"),
        *_both("pagedown", "shift+pagedown", "page_down", "Page down"),
        *_both("ctrl+home", "ctrl+shift+home", "text_start", "Start of the program"),
        *_both("ctrl+end", "ctrl+shift+end", "text_end", "End of the program"),
        Binding("ctrl+a", "select_all", "Select all", show=False, id="editor.select_all"),
        Binding("ctrl+up", "scroll_line(-1)", "Scroll up", show=False, id="editor.scroll_up"),
        Binding("ctrl+down", "scroll_line(1)", "Scroll down", show=False, id="editor.scroll_down"),
        Binding("f8", "next_problem", "Next problem", show=False, id="editor.next_problem"),
        Binding(
            "shift+f8,f20",
            "previous_problem",
            "Previous problem",
            show=False,
            id="editor.previous_problem",
        ),
    ]

    def _move(self, motion: Callable[[Buffer, int], int], extend: bool) -> None:
        self.state.move(motion(self.state.buffer, self.state.cursor), extend=extend)
        self.done()

    def _go_lines(self, by: int, extend: bool) -> None:
        state = self.state
        offset, goal = self.view.geometry.vertical(state.cursor, by, state.goal)
        state.move(offset, extend=extend)
        state.goal = goal
        self.done()

    def action_cursor_up(self, extend: bool = False) -> None:
        """Go a line up, or an entry in the popup."""
        if self.popup.is_open and not extend:
            self.view.choose(-1)
        else:
            self._go_lines(-1, extend)

    def action_cursor_down(self, extend: bool = False) -> None:
        """Go a line down, or an entry in the popup."""
        if self.popup.is_open and not extend:
            self.view.choose(1)
        else:
            self._go_lines(1, extend)

    def action_page_up(self, extend: bool = False) -> None:
        """Go a page up."""
        self._go_lines(-self.view.page, extend)

    def action_page_down(self, extend: bool = False) -> None:
        """Go a page down."""
        self._go_lines(self.view.page, extend)

    def action_cursor_left(self, extend: bool = False) -> None:
        """Go a character to the left, or to the start of what is selected."""
        if not extend and not self.selection.is_empty:
            self._move(lambda _, __: self.selection.start, False)
        else:
            self._move(motions.left, extend)

    def action_cursor_right(self, extend: bool = False) -> None:
        """Go a character to the right, or to the end of what is selected."""
        if not extend and not self.selection.is_empty:
            self._move(lambda _, __: self.selection.end, False)
        else:
            self._move(motions.right, extend)

    def action_word_left(self, extend: bool = False) -> None:
        """Go to the start of the word."""
        self._move(motions.word_left, extend)

    def action_word_right(self, extend: bool = False) -> None:
        """Go to the start of the next word."""
        self._move(motions.word_right, extend)

    def action_line_start(self, extend: bool = False) -> None:
        """Go to the start of the line's text, and then to that of the line."""
        self._move(motions.line_start, extend)

    def action_line_end(self, extend: bool = False) -> None:
        """Go to the end of the line."""
        self._move(motions.line_end, extend)

    def action_text_start(self, extend: bool = False) -> None:
        """Go to the start of the program."""
        self._move(lambda _, __: 0, extend)

    def action_text_end(self, extend: bool = False) -> None:
        """Go to the end of the program."""
        self._move(lambda buffer, _: buffer.size, extend)

    def action_select_all(self) -> None:
        """Select the whole program."""
        self.state.select(0, self.state.buffer.size)
        self.done(scroll=False)

    def action_scroll_line(self, by: int) -> None:
        """Scroll by a line, the cursor staying where it is."""
        self.view.scroll_relative(y=by, animate=False, force=True, immediate=True)

    def action_next_problem(self) -> None:
        """Go to the next mistake."""
        mark = self.marks.next_after(self.state.cursor)
        if mark is not None:
            self.go_to(mark.start)

    def action_previous_problem(self) -> None:
        """Go to the mistake before."""
        mark = self.marks.previous_before(self.state.cursor)
        if mark is not None:
            self.go_to(mark.start)
