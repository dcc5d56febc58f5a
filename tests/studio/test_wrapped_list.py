"""Problems are read whole, whatever the width: what they say goes on below."""

from __future__ import annotations

from pathlib import Path

import pytest
from rich.cells import cell_len
from studio_driver import studio

from plastron_tui.diagnostics import Edit, Span
from plastron_tui.studio.panels.entry import Entry
from plastron_tui.studio.panels.entry_list import empty_rows
from plastron_tui.studio.panels.wrapped_list import WrappedList, _height, rows_of

FIX = (Edit(Span(0, 0), b""),)
HELP = (
    "the sentence is: VARIABLE has_parameter 'PARAMETER_NAME' of parameter_type PARAMETER_TYPE "
    "and default VALUE [between LEAST and MOST]"
)
ENTRIES = [
    Entry("a", "short", "line 1", "✖", "error"),
    Entry("b", HELP, "", "=", depth=1),
    Entry("c", HELP, "line 12 · syntax-error", "✖", edits=FIX, warning="write `between 0 and 1`"),
    Entry("d", "short", "line 3", "▲", edits=FIX, warning="take the statement away"),
    Entry("e", "漢字" * 40, "line 5", "✖", warning="ü"),
    Entry("f", "漢字" * 10, "line 6", "✖"),
]


@pytest.mark.parametrize("width", [1, 2, 7, 20, 40, 82, 300])
@pytest.mark.parametrize("entry", ENTRIES, ids=lambda entry: entry.key)
def test_an_entry_is_whole_at_any_width(entry: Entry, width: int) -> None:
    rows = ["".join(piece.text for piece in row) for row in rows_of(entry, width)]
    assert len(rows) == _height(entry, width)
    if width > 2:
        assert all(cell_len(row) <= width for row in rows)
    whole = "".join("".join(rows).split())
    said = (entry.text, entry.detail, "⚑" if entry.edits else "", entry.warning)
    assert whole == "".join("".join((entry.sign, *said[:2])).split()) + (
        "".join(("⚑" if entry.edits else "⚠", *entry.warning.split())) if entry.warning else ""
    )


@pytest.mark.parametrize(
    ("width", "rows"),
    [
        (60, [" ▲ short line 3 ⚑ take the statement away"]),
        # What can be done is not begun in the row that it does not fit in.
        (32, [" ▲ short line 3", "   ⚑ take the statement away"]),
    ],
)
def test_what_can_be_done_stands_in_one_piece(width: int, rows: list[str]) -> None:
    found = ["".join(piece.text for piece in row) for row in rows_of(ENTRIES[3], width)]
    assert found == rows


@pytest.mark.parametrize("width", [1, 12, 33, 90])
def test_what_an_empty_list_says_is_whole_at_any_width(width: int) -> None:
    text = "no messages yet\ncreate_message hello of message_type String and input data=1"
    rows = ["".join(piece.text for piece in row) for row in empty_rows(text, width)]
    assert "".join("".join(rows).split()) == "".join(text.split())
    if width > 1:
        assert all(cell_len(row) <= width for row in rows)
    if width == 33:
        assert rows == [
            " no messages yet", " create_message hello of ", " message_type String and input ",
            " data=1",
        ]  # fmt: skip


async def test_a_problem_is_walked_to_and_clicked_on_whatever_rows_it_takes(program: Path) -> None:
    program.write_text("create_node 'a' as a\n" + "a has_parameter 'speed' of\nfoo bar\n" * 4)
    async with studio(program, (80, 24)) as driver:
        await driver.show("problems")
        panel = driver.main.panels["problems"]
        assert isinstance(panel, WrappedList)
        whole = "\n".join(panel.render_line(y).text for y in range(panel.size.height))
        help_ = next(entry.text for entry in panel.entries.all if entry.key.startswith("help"))
        assert "".join(help_.split()) in "".join(whole.split())
        assert panel.virtual_size.height > len(panel._shown)
        await driver.press("end")
        assert panel.scroll_offset.y == panel.virtual_size.height - panel.size.height
        # The help is a part of the problem: it is lit with it, and passed with it.
        part = len(panel._shown) - 1
        assert panel._shown[part].part_of and panel.index == part - 1
        assert panel._style_of(part) == panel._style_of(part - 1) != panel._style_of(part - 2)
        await driver.press("home")
        await driver.press("down")
        assert not panel.current.part_of and panel.index > 1
        await driver.press("home")
        ends = panel._ends
        number = next(at for at in range(len(ends)) if ends[at] - panel._start_of(at) > 1)
        await driver.pilot.click("#problems", offset=(12, ends[number] - 1))
        assert panel.index == panel._whole_at(number)
        panel.follow(panel.current.span.start)
        await driver.press("escape")
        here = panel._style_of(panel.index)
        assert not panel.has_focus and here == panel._style_of(panel.index + 1)
