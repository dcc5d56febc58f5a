from __future__ import annotations

import io

import pytest
from hypothesis import given
from hypothesis import strategies as st

from plastron_tui.diagnostics.terminal import (
    is_only_colour,
    visible,
    visible_line,
    wants_colour,
    width,
)


class Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


@pytest.mark.parametrize(
    ("environ", "in_terminal", "in_pipe"),
    [
        ({}, True, False),
        ({"NO_COLOR": "1"}, False, False),
        ({"NO_COLOR": ""}, True, False),
        ({"FORCE_COLOR": "1"}, True, True),
        ({"FORCE_COLOR": ""}, True, False),
        ({"FORCE_COLOR": "1", "NO_COLOR": "1"}, False, False),
        ({"TERM": "dumb"}, False, False),
        ({"TERM": "dumb", "FORCE_COLOR": "1"}, True, True),
    ],
)
def test_who_has_colours(environ: dict[str, str], in_terminal: bool, in_pipe: bool) -> None:
    assert wants_colour(Terminal(), environ) is in_terminal
    assert wants_colour(io.StringIO(), environ) is in_pipe


def test_a_closed_stream_has_no_colours() -> None:
    stream = io.StringIO()
    stream.close()
    assert not wants_colour(stream, {})


@pytest.mark.parametrize(("text", "cells"), [("abc", 3), ("日本", 4), ("e\u0301", 1), ("", 0)])
def test_width(text: str, cells: int) -> None:
    assert width(text) == cells


@pytest.mark.parametrize(
    ("text", "coloured", "plain"),
    [
        ("a\tb\xa0c", "a\tb\xa0c", "a\tb\xa0c"),
        ("\x1b[1;31mred", "\x1b[1;31mred\x1b[0m", "red"),
        ("\x1b[31ma\x1b[0mb", "\x1b[31ma\x1b[0mb", "ab"),
        ("\x1b[2Ja\r\x07", r"\x1b[2Ja\r\x07", r"\x1b[2Ja\r\x07"),
        ("\x9b31ma\u202eb", r"\x9b31ma\u202eb", r"\x9b31ma\u202eb"),
        ("\x1b]8;;http://x\x1b\\x", r"\x1b]8;;http://x\x1b" + "\\x", None),
    ],
)
def test_a_line_of_output(text: str, coloured: str, plain: str | None) -> None:
    assert visible_line(text, in_colour=True) == coloured
    assert visible_line(text, in_colour=False) == (coloured if plain is None else plain)


@given(st.text())
def test_nothing_that_a_terminal_obeys_is_left(text: str) -> None:
    assert visible(text).isprintable()
    line = visible_line(text, in_colour=False)
    assert not set(line) & {chr(code) for code in (*range(9), *range(10, 32), *range(127, 160))}


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("\x1b[0m", True),
        ("\x1b[0m\x1b[1;31m", True),
        ("", False),
        ("\x1b[0m ", False),
        ("a", False),
    ],
)
def test_a_line_of_colours_alone(text: str, told: bool) -> None:
    assert is_only_colour(text) is told
