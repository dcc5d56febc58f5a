"""What goes to a terminal without what it shows already: it comes to the same picture."""

from __future__ import annotations

from typing import NamedTuple

import pyte
from hypothesis import given, settings
from hypothesis import strategies as st
from pyte.screens import Char

from plastron_tui.studio.terminal_output import BEGIN, END, ShownScreen

COLUMNS, ROWS = 14, 4
STYLES = (
    *("", "1", "4", "7", "3;9", "31", "1;92;44", "38;5;9", "48;5;200"),
    *("38;2;1;2;3;48;2;4;5;6", "1;38;2;1;2;3;48;2;4;5;6", "38;2;9;9;9;48;2;4;5;6"),
)
TEXTS = ("a", "b", " ", "  ", "   ", "ab c", "─│", "é", "漢", "x漢y", "e\u0301", "👍", "node ")


class Piece(NamedTuple):
    """A text in a style."""

    style: str
    text: str

    def written(self) -> str:
        return f"\x1b[{self.style}m{self.text}\x1b[0m" if self.style else self.text


PIECES = st.lists(st.builds(Piece, st.sampled_from(STYLES), st.sampled_from(TEXTS)), max_size=6)
LINES = st.tuples(st.integers(1, ROWS + 1), st.integers(1, COLUMNS), PIECES)
CURSORS = st.tuples(st.integers(1, ROWS), st.integers(1, COLUMNS))


def update(lines: list[tuple[int, int, list[Piece]]], cursor: tuple[int, int]) -> str:
    """Return an update as Textual writes one."""
    # An end of a line in the last row would scroll, and is in none.
    parts = []
    for row, column, pieces in lines:
        text = "".join(each.written() for each in pieces)
        parts.append(f"\x1b[{row};{column}H{text}" + "\n" * (row == 1))
    return "".join(parts) + "\x1b[{};{}H".format(*cursor)


UPDATES = st.builds(update, st.lists(LINES, max_size=5), CURSORS)
OTHERS = st.sampled_from(
    [BEGIN, END, "\x07", "\x1b[2J", "\x1b[3;2Hoops", "\x1b[1;1H\x1b[1mleft bold\x1b[1;1H\x1b[0m"]
)


class Terminals:
    """Two terminals, of which one gets all and the other one what is let through."""

    def __init__(self, columns: int = COLUMNS, rows: int = ROWS) -> None:
        self.shown = ShownScreen()
        self.screens = [pyte.Screen(columns, rows), pyte.Screen(columns, rows)]
        self.streams = [pyte.Stream(screen) for screen in self.screens]
        self.size = (columns, rows)
        for stream in self.streams:
            stream.feed("\x1b[?7l")

    def write(self, data: str) -> str:
        changes = self.shown.changes(data, self.size)
        for stream, text in zip(self.streams, (data, changes), strict=True):
            # pyte knows nothing of this one and shows it.
            stream.feed(text.replace(BEGIN, "").replace(END, ""))
        return changes

    def resize(self, columns: int, rows: int) -> None:
        self.size = (columns, rows)
        self.shown.forget()
        for screen in self.screens:
            screen.resize(rows, columns)

    def pictures(self) -> list[tuple[list[object], tuple[int, int]]]:
        return [
            (
                [
                    visible(screen.buffer[row][column])
                    for row in range(self.size[1])
                    for column in range(self.size[0])
                ],
                (screen.cursor.x, screen.cursor.y),
            )
            for screen in self.screens
        ]


def visible(cell: Char) -> object:
    """Return what can be seen of a cell: a blank has no colour of its own."""
    if cell.data == " " and not (cell.reverse or cell.underscore or cell.strikethrough):
        return (" ", cell.bg)
    return cell


@settings(max_examples=60, deadline=None)
@given(st.lists(st.one_of(UPDATES, UPDATES, UPDATES, OTHERS, CURSORS), max_size=12))
def test_any_updates_come_to_the_same_picture(steps: list[str | tuple[int, int]]) -> None:
    terminals = Terminals()
    for step in steps:
        if isinstance(step, str):
            terminals.write(step)
        else:
            terminals.resize(step[1] + 4, step[0] + 1)
        plain, cut = terminals.pictures()
        assert cut == plain
