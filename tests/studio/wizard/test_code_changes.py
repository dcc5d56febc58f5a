"""Which lines of a node's code are new, and which of them are to be in sight."""

from __future__ import annotations

import pytest

from plastron_tui.studio.panels.styles import Line, Lines, Piece
from plastron_tui.studio.wizard.code_changes import marked, place_of


def lines(*texts: str) -> Lines:
    return tuple((Piece(text, "keyword"),) for text in texts)


def text_of(line: Line) -> str:
    return "".join(piece.text for piece in line)


def test_what_changes_is_marked_as_in_a_diff() -> None:
    before = lines("import a", "x = 1", "def main():", "    pass")
    after = lines("import a", "import b", "x = 2", "def main():", "    pass")
    rows, change = marked(before, after)
    assert [text_of(row) for row in rows] == [
        " import a",
        "-x = 1",
        "+import b",
        "+x = 2",
        " def main():",
        "     pass",
    ]
    assert change == range(1, 4)
    # The ground of a changed line goes on to the edge; the others keep their colours.
    assert rows[2] == (Piece("+import b", "added"), Piece("", "added"))
    assert rows[0] == (Piece(" "), Piece("import a", "keyword"))


def test_the_most_that_hangs_together_is_looked_at() -> None:
    before = lines("import a", "def main():", "    pass", "main()")
    after = lines("import b", "def main():", "    one()", "    two()", "main()", "more()")
    assert marked(before, after)[1] == range(3, 6)


def test_where_nothing_changes_nothing_is_to_be_looked_at() -> None:
    assert marked(lines("a", "b"), lines("a", "b"))[1] == range(0)


@pytest.mark.parametrize(
    ("rows", "top"),
    [(range(0), 0), (range(2, 4), 0), (range(20, 22), 16), (range(20, 60), 20)],
    ids=["none", "at the start", "in the middle", "from their start"],
)
def test_what_changes_is_in_sight(rows: range, top: int) -> None:
    assert place_of(rows, 10) == top
