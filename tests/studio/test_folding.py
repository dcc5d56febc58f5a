"""Lines that are longer than there is room for."""

from __future__ import annotations

from hypothesis import given, settings
from hypothesis import strategies as some
from rich.cells import cell_len

from plastron_tui.studio.panels.folding import folded
from plastron_tui.studio.panels.styles import Piece

LINES = some.lists(
    some.lists(
        some.builds(Piece, some.text("ab (é猫", max_size=30), some.sampled_from(["", "dim"])),
        max_size=4,
    ).map(tuple),
    max_size=4,
).map(tuple)


def text_of(line: tuple[Piece, ...]) -> str:
    return "".join(piece.text for piece in line)


@settings(max_examples=50)
@given(LINES, some.integers(2, 40))
def test_nothing_is_lost_and_nothing_is_too_long(
    lines: tuple[tuple[Piece, ...], ...], width: int
) -> None:
    rows = folded(lines, width)
    assert all(cell_len(text_of(row)) <= width for row in rows)
    before, after = ("".join(map(text_of, each)).replace(" ", "") for each in (lines, rows))
    assert before == after
    assert len(rows) >= len(lines)
    assert folded(rows, width) == rows


def test_a_line_is_split_at_a_space_and_goes_on_further_in() -> None:
    code = (Piece("  if "), Piece("ready", "name"), Piece(" and not done:"))
    assert [text_of(row) for row in folded((code, (Piece("short"),)), 16)] == [
        "  if ready and ",
        "      not done:",
        "short",
    ]
    assert folded((code,), 16)[0][1] == Piece("ready", "name")
    far = (Piece("            self.create_publisher(String, 'chatter', 10)"),)
    assert [text_of(row) for row in folded((far,), 31)] == [
        "            self.",
        "               create_publisher",
        "               (String, ",
        "               'chatter', 10)",
    ]
    assert [text_of(row) for row in folded(((Piece("self.create_service(SetBool)"),),), 24)] == [
        "self.create_service(",
        "    SetBool)",
    ]


def test_the_rest_of_a_line_of_a_diff_stands_as_far_in_as_the_line() -> None:
    line = (Piece("+    self.create_timer(0.1, tick)", "added"), Piece("", "added"))
    assert [text_of(row) for row in folded((line,), 24)] == [
        "+    self.create_timer(",
        "         0.1, tick)",
    ]
    line = (Piece(" 12 +", "dim"), Piece("    self.create_timer(0.1, tick)"))
    assert [text_of(row) for row in folded((line,), 28)] == [
        " 12 +    self.create_timer(",
        "             0.1, tick)",
    ]


def test_the_ground_of_a_row_goes_on_below() -> None:
    line = (Piece("+ready and not done", "added"), Piece("", "added"))
    rows = folded((line,), 13)
    assert len(rows) == 2
    assert all({piece.tone for piece in row} == {"added"} for row in rows)
    assert all(row[-1] == line[-1] for row in rows)
