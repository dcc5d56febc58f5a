"""Text that comes as keys, many at once, and keys that stay keys."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from plastron_tui.studio.key_bursts import Bursts, Kind, Part

LINE = "node1 publish message1 to 'chatter' of message_type String\r"
LINES = LINE * 2
PAGE = LINE * 5
MOUSE = "\x1b[<35;10;10M"


def told(*reads: tuple[float, str]) -> list[Part]:
    bursts = Bursts()
    return [part for time, data in reads for part in bursts.parts(data, time)]


def key(text: str) -> Part:
    return Part(text)


def burst(text: str) -> Part:
    return Part(text, Kind.BURST)


def paste(text: str) -> Part:
    return Part(text, Kind.PASTE)


@pytest.mark.parametrize(
    ("reads", "parts"),
    [
        ([(0, "a")], [key("a")]),
        ([(0, " and input 5,6,7\rnod")], [key(" and input 5,6,7\rnod")]),
        ([(0, LINES)], [burst(LINES)]),
        # A terminal that pastes lines with CR and LF means one end of a line.
        ([(0, LINES.replace("\r", "\r\n"))], [burst(LINES)]),
        ([(0, "a\r"), (0.01, "\nb")], [key("a\r"), key("b")]),
        ([(0, "a\r"), (5, "\nb")], [key("a\r"), key("\nb")]),
        ([(0, LINES.replace("\r", "\n"))], [burst(LINES.replace("\r", "\n"))]),
        # What is left over is part of it, and what is typed later is not.
        (
            [(0, LINES), (0.02, "the\rend\r"), (9, "a")],
            [burst(LINES), burst("the\rend\r"), key("a")],
        ),
        # So much is nobody's answers, nor is its rest.
        ([(0, PAGE)], [paste(PAGE)]),
        ([(0, PAGE), (0.02, "end\r")], [paste(PAGE), paste("end\r")]),
        ([(0, PAGE.replace("\r", "\r\n") + "\r"), (0.01, "\nx")], [paste(PAGE + "\r"), paste("x")]),
        # An answer is long, and then Enter.
        ([(0, "x" * 80 + "\r")], [burst("x" * 80), key("\r")]),
        ([(0, LINES + "\x13" + "b")], [burst(LINES), key("\x13"), burst("b")]),
        # A mouse that moves, or a window that gets the focus, is no end of it.
        (
            [(0, LINES + MOUSE + LINE + "\x1b[I"), (0.02, MOUSE + "end")],
            [burst(LINES), key(MOUSE), burst(LINE), key("\x1b[I"), key(MOUSE), burst("end")],
        ),
        ([(0, MOUSE), (0.01, PAGE)], [key(MOUSE), paste(PAGE)]),
        ([(0, "a" + MOUSE + "b\x1bOP\x1bx\x1b")], [key("a" + MOUSE + "b\x1bOP\x1bx\x1b")]),
        ([(0, MOUSE[:5]), (0.01, MOUSE[5:] + LINES)], [key(MOUSE[:5]), key(MOUSE[5:] + LINES)]),
        # What a terminal answers is a string, however long.
        ([(0, "\x1bP>|" + "x" * 80)], [key("\x1bP>|" + "x" * 80)]),
        ([(0, "\x1b]11;"), (0.01, "y" * 80)], [key("\x1b]11;"), key("y" * 80)]),
        ([(0, "\x1b["), (0.01, LINES)], [key("\x1b["), key(LINES)]),
    ],
)
def test_keys_and_bursts_are_told_apart(reads: list[tuple[float, str]], parts: list[Part]) -> None:
    assert told(*reads) == parts


@settings(max_examples=40, deadline=None)
@given(
    st.lists(
        st.sampled_from(["a", "\x13", "\n", "\r", "\x1b[A", LINE, LINES, MOUSE + LINES, "\x1b"])
    )
)
def test_no_character_is_lost(reads: list[str]) -> None:
    # Each is read a second after the one before it.
    parts = told(*enumerate(reads))
    assert "".join(part.text for part in parts) == "".join(reads)
