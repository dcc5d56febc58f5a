"""The keys that change the text."""

from __future__ import annotations

from typing import ClassVar

from textual.binding import Binding, BindingType

from . import line_commands, motions
from .completing import CompletingActions
from .history import Kind


class EditingActions(CompletingActions):
    """Deletes, lines, clipboard, undo."""

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("enter", "newline", "New line", show=False, id="editor.newline"),
        Binding("backspace", "delete_left", "Delete left", show=False, id="editor.delete_left"),
        Binding("delete", "delete_right", "Delete right", show=False, id="editor.delete_right"),
        Binding(
            "ctrl+w,alt+backspace,ctrl+backspace",
            "delete_word_left",
            "Delete the word",
            show=False,
            id="editor.delete_word_left",
        ),
        Binding(
            "ctrl+delete,alt+d",
            "delete_word_right",
            "Delete the next word",
            show=False,
            id="editor.delete_word_right",
        ),
        Binding("ctrl+k", "delete_line", "Delete the line", show=False, id="editor.delete_line"),
        Binding("ctrl+z", "undo", "Undo", show=False, id="editor.undo"),
        Binding("ctrl+y,ctrl+shift+z", "redo", "Redo", show=False, id="editor.redo"),
        Binding("ctrl+x", "cut", "Cut", show=False, id="editor.cut"),
        Binding("ctrl+c,super+c", "copy", "Copy", show=False, id="editor.copy"),
        Binding("ctrl+v", "paste", "Paste", show=False, id="editor.paste"),
        Binding("ctrl+d", "duplicate", "Duplicate lines", show=False, id="editor.duplicate"),
        Binding("alt+up", "move_lines(-1)", "Move lines up", show=False, id="editor.move_up"),
        Binding("alt+down", "move_lines(1)", "Move lines down", show=False, id="editor.move_down"),
        Binding(
            "ctrl+underscore,ctrl+slash",
            "toggle_comment",
            "Comment lines out or in",
            show=False,
            id="editor.toggle_comment",
        ),
    ]

    def type_text(self, text: str) -> None:
        """Type characters over what is selected."""
        self.state.replace_selection(self.state.buffer.normalized(text), Kind.TYPE)
        self.view.sync()
        self.tell()
        self.complete_typed()

    def insert_text(self, text: str) -> None:
        """Put a text over what is selected, as a step of its own to undo."""
        self.state.history.close()
        self.state.replace_selection(self.state.buffer.normalized(text))
        self.done()

    def action_newline(self) -> None:
        """Break the line; with an entry of the popup chosen, take that."""
        if self.popup.is_open and self.popup.is_chosen:
            self.accept()
            return
        self.state.replace_selection(self.state.buffer.ending)
        self.done()

    def action_delete_left(self) -> None:
        """Delete what is selected, or the character before the cursor."""
        self._delete(motions.left(self.state.buffer, self.state.cursor))

    def action_delete_right(self) -> None:
        """Delete what is selected, or the character after the cursor."""
        self._delete(motions.right(self.state.buffer, self.state.cursor))

    def action_delete_word_left(self) -> None:
        """Delete to the start of the word."""
        self._delete(motions.word_left(self.state.buffer, self.state.cursor))

    def action_delete_word_right(self) -> None:
        """Delete to the start of the next word."""
        self._delete(motions.word_right(self.state.buffer, self.state.cursor))

    def _delete(self, to: int) -> None:
        selection = self.selection
        if selection.is_empty:
            cursor = self.state.cursor
            self.state.delete(min(cursor, to), max(cursor, to))
        else:
            self.state.history.close()
            self.state.delete(selection.start, selection.end)
        self.view.sync()
        self.tell()
        if self.popup.is_open:
            self.complete_typed()

    def action_delete_line(self) -> None:
        """Delete the lines that are selected, or the cursor's."""
        self.state.apply(*line_commands.delete(self.state.buffer, self.selection))
        self.done()

    def action_duplicate(self) -> None:
        """Repeat the lines that are selected, or the cursor's."""
        self.state.apply(*line_commands.duplicate(self.state.buffer, self.selection))
        self.done()

    def action_move_lines(self, by: int) -> None:
        """Move the lines that are selected, or the cursor's, up or down."""
        plan = line_commands.move(self.state.buffer, self.selection, by)
        if plan is not None:
            self.state.apply(*plan)
            self.done()

    def action_toggle_comment(self) -> None:
        """Comment the lines out, or in again."""
        self.state.apply(*line_commands.toggle_comment(self.state.buffer, self.selection))
        self.done()

    def action_undo(self) -> None:
        """Undo."""
        self.undo()

    def action_redo(self) -> None:
        """Redo."""
        self.redo()

    def action_copy(self) -> None:
        """Copy what is selected, or the line, to the terminal's clipboard and the app's."""
        self.app.copy_to_clipboard(self._copied().decode("utf-8", "replace"))

    def action_cut(self) -> None:
        """Copy, and delete."""
        self.action_copy()
        if self.selection.is_empty:
            self.action_delete_line()
        else:
            self.state.history.close()
            self.state.delete(self.selection.start, self.selection.end)
            self.done()

    def _copied(self) -> bytes:
        if not self.selection.is_empty:
            return self.state.selected
        buffer, row = self.state.buffer, self.state.row
        return buffer.line_bytes(row) + buffer.ending

    def action_paste(self) -> None:
        """Put in what was copied last in this app; the terminal's own paste works as well."""
        if self.app.clipboard:
            self.insert_text(self.app.clipboard)
