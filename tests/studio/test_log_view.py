"""What nodes print, as the panel breaks it."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as some
from rich.cells import cell_len
from studio_driver import studio

from plastron_tui.studio.panels.log_view import MOST_ROWS, first_rows, wrapped
from plastron_tui.studio.panels.styles import Line, Piece

TWIST = "cmd_vel: geometry_msgs.msg.Twist(linear=geometry_msgs.msg.Vector3(x=0.5, y=0.0, z=0.0))"


def printed(text: str) -> Line:
    name, sign, rest = text.partition(" | ")
    return (Piece(name + sign, "primary"), Piece(rest)) if sign else (Piece(text),)


def shown(line: Line, width: int) -> list[str]:
    return ["".join(piece.text for piece in row) for row in wrapped(line, width)]


@pytest.mark.parametrize(
    ("text", "width", "rows"),
    [
        ("", 20, [""]),
        ("talker | hello", 14, ["talker | hello"]),
        ("a | one two three", 12, ["a | one two ", "    three"]),
        ("one two three four", 12, ["one two ", "  three four"]),
        ("a | 日本語日本", 9, ["a | 日本", "    語日", "    本"]),
        ("abcdefghijkl", 5, ["abcde", "  fgh", "  ijk", "  l"]),
        ("a_long_name_of_a_node | hi there", 24, ["a_long_name_of_a_node | ", "  hi there"]),
        (
            f"drive | {TWIST}",
            60,
            [
                "drive | cmd_vel: geometry_msgs.msg.Twist(",
                "        linear=geometry_msgs.msg.Vector3(x=0.5, y=0.0, ",
                "        z=0.0))",
            ],
        ),
    ],
)
def test_a_long_line_goes_on_behind_the_name(text: str, width: int, rows: list[str]) -> None:
    assert shown(printed(text), width) == rows


@given(some.text(alphabet="ab ,(日|\u0301", max_size=80), some.integers(4, 30))
def test_rows_fit_and_make_up_the_line(text: str, width: int) -> None:
    line = printed(text)
    rows = wrapped(line, width)
    assert all(cell_len("".join(piece.text for piece in row)) <= width for row in rows)
    kept = [rows[0], *(row[1:] for row in rows[1:])]
    assert "".join(piece.text for row in kept for piece in row) == text


@pytest.mark.parametrize(
    ("pieces", "width", "rows"),
    [
        ([("one two three four five six", "")], 12, ["one two ", "  three ", "  four  …"]),
        ([("日本語日本語", "")], 4, ["日本", "  語", "   …"]),
        ([("a | ", "primary"), ("one two three four five six", ""), ("  ×1,037", "quiet")], 30,
         ["a | one two three four five ", "    six  ×1,037"]),
        ([("a | ", "primary"), ("one two " * 12, ""), ("  ×37", "quiet")], 30,
         ["a | one two one two one two ", "    one two one two one two ",
          "    one  … 2 rows more  ×37"]),
        ([("a | ", "primary"), ("one two " * 8, "error")], 20, None),
    ],
)  # fmt: skip
def test_of_a_long_line_the_first_rows_are_shown(
    pieces: list[tuple[str, str]], width: int, rows: list[str] | None
) -> None:
    line = tuple(Piece(*each) for each in pieces)
    whole = wrapped(line, width)
    found = first_rows(line, whole, width) if len(whole) > MOST_ROWS else whole
    shown = ["".join(piece.text for piece in row) for row in found]
    # What went wrong is seen to its end.
    assert shown == rows if rows is not None else found == whole


async def test_a_message_is_seen_whole_in_a_small_window(program: Path) -> None:
    async with studio(program, (80, 24)) as driver:
        output = driver.main.panels["output"].view
        driver.main.dock_layout.bring("output", focus=True)
        await driver.settle()
        lines = tuple(printed(f"node{number} | {TWIST * 3}") for number in range(30))
        output.show(lines, follow=True)
        await driver.settle()
        assert not output.show_horizontal_scrollbar
        assert output.max_scroll_x == 0

        def seen() -> str:
            rows = (output.render_line(y).text for y in range(output.size.height))
            return "".join(row.strip() + " " * row.endswith(" ") for row in rows)

        # Of a long line the first rows are enough, until somebody asks for all of it.
        assert seen().endswith(" … 2 rows more ")
        rows = len(output.rows)
        await driver.press("up", "up")
        await driver.press("enter")
        top = output.render_line(0).text
        assert len(output.rows) > rows and top.startswith("node")
        await driver.press("enter")
        assert len(output.rows) == rows and output.render_line(0).text == top
        await driver.press("end", "enter")
        assert seen().rstrip().endswith("z=0.0))")
        assert output.is_vertical_scroll_end
        await driver.pilot.resize_terminal(60, 24)
        await driver.settle()
        assert not output.show_horizontal_scrollbar
        assert output.is_vertical_scroll_end
        assert output.text.count("Twist") == 90
