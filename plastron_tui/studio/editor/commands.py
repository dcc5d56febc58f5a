"""Every command of the editor, once: keys, menu, help and configuration are made from it."""

from __future__ import annotations

import re
from collections.abc import Awaitable, Callable
from functools import partial
from importlib import import_module
from operator import attrgetter
from typing import TYPE_CHECKING, NamedTuple, TypeAlias

from textual.binding import Binding

from . import line_commands, motions, text_commands
from .text_commands import Edge, Motion, PlanOf, TextCommand

if TYPE_CHECKING:
    from .marks import Mark
    from .widget import ProgramEditor

Run: TypeAlias = "Callable[[ProgramEditor], Awaitable[None] | None]"


def _always(editor: ProgramEditor) -> bool:
    return True


class Command(NamedTuple):
    """Something that the editor does.

    Attributes:
        name: its name; with `editor.` before it the id that the configuration file binds.
        title: what it is called.
        keys: its keys, by commas, as every terminal sends them.
        run: does it.
        help: a sentence about it; without one it is in no menu.
        more_keys: keys that only some terminals send, or that somebody expects.
        in_bars: whether its keys do the same while a bar has the focus.
        asks: whether it opens a bar, which the keys that follow are for.
        applies: whether its keys are for the editor now, and not for what is around it.
    """

    name: str
    title: str
    keys: str
    run: Run
    help: str = ""
    more_keys: str = ""
    in_bars: bool = False
    asks: bool = False
    applies: Callable[[ProgramEditor], bool] = _always

    @property
    def id(self) -> str:
        """The name under which the configuration file can bind other keys."""
        return f"editor.{self.name}"

    @property
    def binding(self) -> Binding:
        """The binding of its keys to the editor's action."""
        keys = ",".join(filter(None, (self.keys, self.more_keys)))
        return Binding(keys, f"edit('{self.name}')", self.title, show=False, id=self.id)


def _text(command: TextCommand, *, scroll: bool = True) -> Run:
    """Return what runs a command on the text and shows what it did."""

    def run(editor: ProgramEditor) -> None:
        command(editor.state)
        editor.done(scroll=scroll)

    return run


def _program(name: str) -> Run:
    """Return what runs a function of `program_commands.py`, imported when somebody asks for it."""

    def run(editor: ProgramEditor) -> Awaitable[None] | None:
        function: Run = getattr(import_module(".program_commands", __package__), name)
        return function(editor)

    return run


def _lines(plan_of: PlanOf) -> Run:
    return _text(text_commands.on_lines(plan_of))


def _delete(motion: Motion) -> Run:
    """Return what deletes up to where a motion leads; an open list follows the word."""
    command = text_commands.delete(motion)

    def run(editor: ProgramEditor) -> None:
        command(editor.state)
        editor.done(keeps_popup=True)
        if editor.popup.is_open:
            editor.offer()

    return run


def _move(motion: Motion, edge: Edge | None = None) -> Callable[[bool], Run]:
    return lambda extend: _text(text_commands.move(motion, extend=extend, edge=edge))


def _vertical(by: int) -> Callable[[bool], Run]:
    """Return what goes lines up or down, or entries of an open list."""

    def extendable(extend: bool) -> Run:
        def run(editor: ProgramEditor) -> None:
            if editor.popup.is_open and not extend:
                editor.view.choose(by)
            elif extend or not editor.hover.scroll(by):
                _go_lines(editor, by, extend)

        return run

    return extendable


def _page(by: int) -> Callable[[bool], Run]:
    def extendable(extend: bool) -> Run:
        def run(editor: ProgramEditor) -> None:
            if extend or not editor.hover.scroll(by * editor.view.card.region.height):
                _go_lines(editor, by * editor.view.page, extend)

        return run

    return extendable


def _go_lines(editor: ProgramEditor, by: int, extend: bool) -> None:
    state = editor.state
    offset, goal = editor.view.geometry.vertical(state.cursor, by, state.goal)
    state.move(offset, extend=extend, goal=goal)
    editor.done()


def _scroll(by: int) -> Run:
    return lambda editor: editor.view.scroll_relative(
        y=by, animate=False, force=True, immediate=True
    )


def _copy(editor: ProgramEditor) -> None:
    editor.app.copy_to_clipboard(text_commands.copied(editor.state))


def _cut(editor: ProgramEditor) -> None:
    _copy(editor)
    text_commands.cut(editor.state)
    editor.done()


def _paste(editor: ProgramEditor) -> None:
    """Put in what was copied last in this app; the terminal's own paste works as well."""
    if editor.app.clipboard:
        editor.insert_text(editor.app.clipboard)


def _new_line(editor: ProgramEditor) -> None:
    """Break the line; with an entry of the list chosen, take that."""
    if editor.popup.is_chosen:
        editor.accept()
    else:
        editor.completer.take_blank_back()
        text_commands.break_line(editor.state)
        editor.done()


def _complete(editor: ProgramEditor) -> None:
    """Offer what may stand at the cursor, however little is typed."""
    editor.offer(is_asked=True)


def _accept(editor: ProgramEditor) -> None:
    """Take what is marked in the list; without a list complete the word before the cursor.

    Whoever goes from panel to panel by Tab and arrives in the text must not change it by the next
    Tab. So behind a blank it only opens the list, and at a line's start or before a word it does
    nothing.
    """
    if editor.popup.is_open:
        editor.accept()
        return
    buffer, cursor = editor.state.buffer, editor.cursor_offset
    row = buffer.row(cursor)
    before, behind = buffer.text[buffer.start(row) : cursor], buffer.text[cursor : buffer.end(row)]
    if not before.strip() or re.match(rb"[\w\x80-\xff]", behind):
        return
    _complete(editor)
    if len(editor.popup.candidates) == 1 and not before[-1:].isspace():
        editor.accept()


def _dismiss(editor: ProgramEditor) -> None:
    """Close the list, or the card, or let go of what is selected."""
    if editor.popup.is_open:
        editor.view.close_popup()
    elif editor.view.card.is_open:
        editor.hover.close()
    else:
        editor.state.move(editor.cursor_offset)
        editor.done()


def _can_dismiss(editor: ProgramEditor) -> bool:
    is_over = editor.popup.is_open or editor.view.card.is_open
    return is_over or not editor.selection.is_empty


def _toggle_wrap(editor: ProgramEditor) -> None:
    editor.view.soft_wrap = not editor.view.soft_wrap


def _go_to_mark(editor: ProgramEditor, mark: Mark | None) -> None:
    if mark is not None:
        editor.go_to(mark.start, walk="problems")


def _both(
    name: str, title: str, keys: str, shifted: str, extendable: Callable[[bool], Run]
) -> tuple[Command, Command]:
    """Return the command that moves the cursor, and the one that selects as far."""
    return (
        Command(name, title, keys, extendable(False)),
        Command(f"{name}-selecting", f"{title}, selecting", shifted, extendable(True)),
    )


COMMANDS: tuple[Command, ...] = (
    Command("undo", "Undo", "ctrl+z", lambda e: e.undo(), "Take the last edit back.",
            in_bars=True),
    Command("redo", "Redo", "ctrl+y", lambda e: e.redo(), "Make the edit again.",
            "ctrl+shift+z", in_bars=True),
    Command("cut", "Cut", "ctrl+x", _cut, "Cut the selection, or the line."),
    Command("copy", "Copy", "ctrl+c", _copy, "Copy the selection, or the line; over SSH too.",
            "super+c"),
    Command("paste", "Paste", "ctrl+v", _paste, "Paste what was copied."),
    Command("select_all", "Select all", "ctrl+a", _text(text_commands.select_all, scroll=False),
            "Select the whole program."),
    Command("find", "Find", "ctrl+f", lambda e: e.find(), "Find a text or a regular expression.",
            in_bars=True, asks=True),
    Command("replace", "Replace", "ctrl+r", lambda e: e.find(replace=True), "Find and replace.",
            in_bars=True, asks=True),
    Command("find_next", "Find next", "f3", lambda e: e.find_bar.step(1),
            "Go to the next place.", in_bars=True),
    Command("find_previous", "Find previous", "shift+f3,alt+p", lambda e: e.find_bar.step(-1),
            "Go to the place before.", "f15", in_bars=True),
    Command("go_to_line", "Go to line", "ctrl+g", _program("ask_line"),
            "Go to a line by its number.", asks=True),
    Command("complete", "Complete", "ctrl+space,f4", _complete, "List what can stand here.",
            "ctrl+@"),
    Command("toggle_comment", "Comment lines out or in", "ctrl+underscore",
            _lines(line_commands.toggle_comment), "Turn lines into comments and back.",
            "ctrl+slash"),
    Command("duplicate", "Duplicate lines", "ctrl+d", _lines(line_commands.duplicate),
            "Repeat the lines below."),
    Command("move_up", "Move lines up", "alt+up", _lines(partial(line_commands.move, by=-1)),
            "Exchange lines with the one above."),
    Command("move_down", "Move lines down", "alt+down", _lines(partial(line_commands.move, by=1)),
            "Exchange lines with the one below."),
    Command("delete_line", "Delete lines", "ctrl+k", _lines(line_commands.delete),
            "Delete the lines of the selection."),
    Command("definition", "Go to definition", "f12", _program("go_to_definition"),
            "Go to where a variable or a part is made, to the next statement about a name, to the "
            "code of a function.", "alt+g"),
    Command("uses", "List where it is used", "alt+h", _program("list_uses"),
            "List the lines with the variable, name, function or type at the cursor; Enter goes "
            "to one.", "shift+f12,f24"),
    Command("rename", "Rename everywhere", "f2", _program("ask_name"),
            "Give the variable, name, function or part of a robot another name.", asks=True),
    Command("format", "Format", "ctrl+l", _program("format_program"),
            "Lay the program out."),
    Command("external_editor", "Open in $EDITOR", "ctrl+e", _program("edit_elsewhere"),
            "Edit the text with your own editor."),
    Command("toggle_wrap", "Wrap long lines", "alt+z", _toggle_wrap,
            "Show long lines whole, over several rows, or let them run on."),
    Command("next_problem", "Next problem", "f8",
            lambda e: _go_to_mark(e, e.marks.next_after(e.cursor_offset)),
            "Go to the next problem."),
    Command("previous_problem", "Previous problem", "shift+f8",
            lambda e: _go_to_mark(e, e.marks.previous_before(e.cursor_offset)),
            "Go to the problem before.", "f20"),
    Command("accept", "Complete", "tab", _accept),
    Command("dismiss", "Close the list", "escape", _dismiss, applies=_can_dismiss),
    Command("newline", "New line", "enter,ctrl+j", _new_line),
    Command("delete_left", "Delete left", "backspace", _delete(motions.left)),
    Command("delete_right", "Delete right", "delete", _delete(motions.right)),
    Command("delete_word_left", "Delete the word", "ctrl+w,alt+backspace,ctrl+backspace",
            _delete(motions.word_left)),
    Command("delete_word_right", "Delete the next word", "ctrl+delete,alt+d",
            _delete(motions.word_right)),
    Command("scroll_up", "Scroll up", "ctrl+up", _scroll(-1)),
    Command("scroll_down", "Scroll down", "ctrl+down", _scroll(1)),
    *_both("cursor_up", "Line up", "up", "shift+up", _vertical(-1)),
    *_both("cursor_down", "Line down", "down", "shift+down", _vertical(1)),
    *_both("cursor_left", "Character left", "left", "shift+left",
           _move(motions.left, attrgetter("start"))),
    *_both("cursor_right", "Character right", "right", "shift+right",
           _move(motions.right, attrgetter("end"))),
    *_both("word_left", "Word left", "ctrl+left,alt+left", "ctrl+shift+left",
           _move(motions.word_left)),
    *_both("word_right", "Word right", "ctrl+right,alt+right", "ctrl+shift+right",
           _move(motions.word_right)),
    *_both("line_start", "Start of the line", "home", "shift+home", _move(motions.line_start)),
    *_both("line_end", "End of the line", "end", "shift+end", _move(motions.line_end)),
    *_both("page_up", "Page up", "pageup", "shift+pageup", _page(-1)),
    *_both("page_down", "Page down", "pagedown", "shift+pagedown", _page(1)),
    *_both("text_start", "Start of the program", "ctrl+home", "ctrl+shift+home",
           _move(motions.text_start)),
    *_both("text_end", "End of the program", "ctrl+end", "ctrl+shift+end",
           _move(motions.text_end)),
)  # fmt: skip

BY_NAME = {command.name: command for command in COMMANDS}
