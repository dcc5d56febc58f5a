"""What commands do to a text, and nothing of a screen: each is a function of its state."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeAlias

from . import line_commands
from .buffer import Buffer
from .history import Kind, Selection
from .line_commands import Plan
from .state import TextState

TextCommand: TypeAlias = Callable[[TextState], None]
Motion: TypeAlias = Callable[[Buffer, int], int]
Edge: TypeAlias = Callable[[Selection], int]
PlanOf: TypeAlias = "Callable[[Buffer, Selection], Plan | None]"


def move(motion: Motion, *, extend: bool = False, edge: Edge | None = None) -> TextCommand:
    """Return the command that moves the cursor, or with `extend` the end of the selection.

    With an `edge` the cursor leaves a selection to there.
    """

    def run(state: TextState) -> None:
        if edge is not None and not extend and not state.selection.is_empty:
            state.move(edge(state.selection))
        else:
            state.move(motion(state.buffer, state.cursor), extend=extend)

    return run


def delete(motion: Motion) -> TextCommand:
    """Return the command that deletes what is selected, or from the cursor to where it moves."""

    def run(state: TextState) -> None:
        if state.selection.is_empty:
            state.delete(*sorted((state.cursor, motion(state.buffer, state.cursor))))
        else:
            delete_selection(state)

    return run


def on_lines(plan_of: PlanOf) -> TextCommand:
    """Return the command that edits the lines that are selected, or the cursor's."""

    def run(state: TextState) -> None:
        plan = plan_of(state.buffer, state.selection)
        if plan is not None:
            state.apply(*plan)

    return run


def type_text(state: TextState, text: str) -> None:
    """Type characters over what is selected."""
    state.replace_selection(state.buffer.normalized(text), Kind.TYPE)


def insert_text(state: TextState, text: str) -> None:
    """Put a text over what is selected, as a step of its own to undo."""
    state.history.close()
    state.replace_selection(state.buffer.normalized(text))


def break_line(state: TextState) -> None:
    """Put the end of a line over what is selected."""
    state.replace_selection(state.buffer.ending)


def select_all(state: TextState) -> None:
    """Select the whole program."""
    state.select(0, state.buffer.size)


def delete_selection(state: TextState) -> None:
    """Delete what is selected, as a step of its own to undo."""
    state.history.close()
    state.delete(state.selection.start, state.selection.end)


delete_lines = on_lines(line_commands.delete)


def copied(state: TextState) -> str:
    """Return what is selected, or the cursor's line."""
    copy = state.selected or state.buffer.line_bytes(state.row) + state.buffer.ending
    return copy.decode("utf-8", "replace")


def cut(state: TextState) -> None:
    """Delete what is copied."""
    if state.selection.is_empty:
        delete_lines(state)
    else:
        delete_selection(state)
