"""Pastes in brackets are text, wherever they are torn apart, and leave the keyboard alive."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from plastron_tui.studio import bracketed_paste
from plastron_tui.studio.bracketed_paste import PasteBrackets
from plastron_tui.studio.key_bursts import Kind, Part

START, STOP = "\x1b[200~", "\x1b[201~"
COLOURED = "one \x1b[31mred\x1b[0m two"
TITLE = "one \x1b]0;title\x07 two\x11"
MOUSE = "\x1b[<35;10;10M"
TICK = 0.1


def told(*reads: tuple[float, str]) -> list[Part]:
    """Return what comes of readings, with a tick every tenth of a second as the driver has it."""
    brackets, found, now = PasteBrackets(0.1), list[Part](), 0.0
    for time, data in reads:
        while now + TICK < time:
            now += TICK
            found += brackets.waited(now)
        now = time
        found += brackets.parts(data, time)
    for after in range(1, 40):
        found += brackets.waited(now + after * TICK)
    return found


def key(text: str) -> Part:
    return Part(text)


def paste(text: str) -> Part:
    return Part(text, Kind.PASTE)


@pytest.mark.parametrize(
    ("reads", "parts"),
    [
        ([(0, f"a{START}{COLOURED}{STOP}b")], [key("a"), paste(COLOURED), key("b")]),
        ([(0, f"{START}{TITLE}{STOP}")], [paste(TITLE)]),
        ([(0, f"{START}a\0b{STOP}{START}c{STOP}")], [paste("ab"), paste("c")]),
        ([(0, f"{START}{STOP}a{STOP}b")], [key(f"a{STOP}b")]),
        ([(0, f"{START}a{START}b{STOP}")], [paste(f"a{START}b")]),
        ([(0, f"{START}a"), (0.2, f"{START}b{STOP}")], [paste(f"a{START}b")]),
        # The end is torn apart, for longer than an Escape waits, and than a paste waits.
        ([(0, f"{START}a\x1b"), (0.2, "[201~b")], [paste("a"), key("b")]),
        ([(0, f"{START}a\x1b"), (9, "[201~b")], [paste("a"), key("b")]),
        ([(0, f"{START}a\x1b["), (0.2, "20"), (0.4, "1~b")], [paste("a"), key("b")]),
        ([(0, f"{START}a"), (5, "b\x11\x1b[Ac"), (9, STOP)], [paste("a"), paste("b\x11\x1b[Ac")]),
        # So is the beginning; an Escape that has waited is one.
        ([(0, "\x1b["), (0.5, f"200~a\x11{STOP}")], [paste("a\x11")]),
        ([(0, "\x1b"), (0.05, f"[200~a{STOP}")], [paste("a")]),
        ([(0, "\x1b"), (0.5, f"[200~a\x11{STOP}")], [key("\x1b"), paste("a\x11")]),
        ([(0, "\x1b[2"), (3, f"00~a\x11{STOP}")], [key("\x1b[2"), paste("a\x11")]),
        # What is no mark is a key.
        ([(0, "\x1b")], [key("\x1b")]),
        ([(0, "\x1b"), (0.11, "a")], [key("\x1b"), key("a")]),
        ([(0, "\x1b"), (0.05, "a")], [key("\x1ba")]),
        ([(0, "\x1b\x1b")], [key("\x1b"), key("\x1b")]),
        ([(0, "\x1b[2"), (0.5, "4~")], [key("\x1b[24~")]),
        ([(0, "\x1b["), (2, "A")], [key("\x1b["), key("A")]),
        # The end never comes: text is shown, and a key that comes alone is one.
        ([(0, f"{START}a"), (5, "b"), (8, "\x11"), (8.1, "c")],
         [paste("a"), paste("b"), key("\x11"), key("c")]),
        ([(0, f"{START}a\x1b"), (5, MOUSE), (5.1, "c")],
         [paste("a"), paste("\x1b"), key(MOUSE), key("c")]),
        ([(0, f"{START}a"), (5, f"{START}b{STOP}c")], [paste("a"), paste("b"), key("c")]),
        ([(0, f"{START}a"), (5, "\r"), (9, "\t"), (13, "\x1b"), (14, "[201~b")],
         [paste("a"), paste("\r"), paste("\t"), key("b")]),
    ],
)  # fmt: skip
def test_pastes_are_taken_out(reads: list[tuple[float, str]], parts: list[Part]) -> None:
    assert told(*reads) == parts


PIECES = st.lists(
    st.sampled_from(["a", "word ", "\r", "\x11", "\x1b", "\x1b[A", "[20", START, COLOURED, TITLE]),
    max_size=6,
).map("".join)


@settings(max_examples=150, deadline=None)
@given(PIECES, st.data())
def test_no_paste_is_a_key_however_it_is_torn(text: str, data: st.DataObject) -> None:
    stream = f"{START}{text}{STOP}"
    cuts = sorted(data.draw(st.sets(st.integers(1, len(stream) - 1), max_size=8)))
    pauses = data.draw(st.lists(st.sampled_from([0.01, 0.3, 1.5]), min_size=8, max_size=8))
    # A mark that is torn apart more than once, slowly, may be keys: nobody can know.
    reads, now, begin = [], 0.0, 0
    for cut, pause in zip([*cuts, len(stream)], [*pauses, 0.0], strict=False):
        reads.append((now, stream[begin:cut]))
        begin, now = cut, now + (0.01 if cut < len(START) else pause)
    parts = told(*reads)
    assert "".join(part.text for part in parts) == text
    assert {part.kind for part in parts} <= {Kind.PASTE}


def test_a_paste_without_end_is_handed_on_in_pieces(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(bracketed_paste, "_MOST", 10)
    brackets = PasteBrackets(0.1)
    reads = [START, *(["abcd\x11"] * 5), STOP]
    parts = [part for data in reads for part in brackets.parts(data, 0)]
    assert [part.kind for part in parts] == [Kind.PASTE] * 3
    assert "".join(part.text for part in parts) == "abcd\x11" * 5
