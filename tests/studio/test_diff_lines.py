"""A diff has the colours of the language and the numbers of the lines, in dialogs and panels."""

from __future__ import annotations

from pathlib import Path

import pytest

from plastron_tui.studio.panels.diff_lines import difference
from plastron_tui.studio.panels.source_lines import coloured
from plastron_tui.studio.panels.styles import Lines


def texts(lines: Lines) -> list[str]:
    return ["".join(piece.text for piece in line) for line in lines]


def test_rows_have_the_number_that_their_line_had_or_will_have() -> None:
    before = b"".join(b"line %d\n" % number for number in range(1, 13))
    after = before.replace(b"line 9\n", b"nine\nand more\n").replace(b"line 12\n", b"")
    assert texts(difference(before, after, Path("a.txt"))) == [
        "  ⋯",
        *("  6  line 6", "  7  line 7", "  8  line 8"),
        *("  9 -line 9", "  9 +nine", " 10 +and more"),
        *(" 11  line 10", " 12  line 11", " 12 -line 12"),
    ]


@pytest.mark.parametrize(
    ("name", "line", "piece", "tone"),
    [
        ("a.py", "def f(): pass", "def", "keyword"),
        ("a.cpp", 'auto x = "y";', '"y"', "string"),
        ("a.plastron", "create_node 'a' as b", "create_node", "primary"),
        ("a.plastron", "create_node 'a' as b  // why", "// why", "quiet"),
    ],
)
def test_lines_have_the_colours_of_their_language(
    name: str, line: str, piece: str, tone: str
) -> None:
    changed = difference(b"\n", f"\n{line}\n".encode(), Path(name))[-1]
    tones = {each.text.strip('"'): each.tone for each in changed}
    assert tones[piece.strip('"')] == f"{tone} on added"
    assert changed[1] == ("+", "added") and changed[-1] == ("", "added")


def test_what_looks_like_the_head_of_a_patch_is_a_line_as_others() -> None:
    lines = difference(b"-- a\nb\n", b"b\n++ c\n", Path("a.txt"))
    assert texts(lines) == ["  1 --- a", "  1  b", "  2 +++ c"]


def test_what_a_terminal_would_obey_is_shown_escaped() -> None:
    (row,) = texts(difference(b"", b"a \x1b[2J \xe2\x80\xae b\r\n", Path("a.py")))
    assert row == r"  1 +a ^[[2J \u202e b^M"


def test_pieces_of_a_program_are_its_whole_text() -> None:
    text = "create_node 'ü' as b\n\tx\n/* ä\n'unclosed */ load\n\nlist 'p' of\n"
    lines = coloured(text, Path("a.plastron"))
    assert texts(lines) == [row.expandtabs(4) for row in text.split("\n")[:-1]]
