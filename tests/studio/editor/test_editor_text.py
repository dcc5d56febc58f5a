"""The parts of the editor that know no screen."""

from __future__ import annotations

from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as some
from states import state_of, text_of

from plastron_tui.session import Session
from plastron_tui.studio.editor import motions
from plastron_tui.studio.editor.buffer import Buffer
from plastron_tui.studio.editor.columns import Line
from plastron_tui.studio.editor.history import Kind, Selection
from plastron_tui.studio.editor.offsets import Offsets
from plastron_tui.studio.editor.state import TextState
from plastron_tui.studio.editor.wrapping import sections

TEXTS = some.text(alphabet="ab \n\té日\r'/", max_size=40)


@given(
    some.lists(some.integers(0, 50), max_size=8).map(sorted),
    some.lists(
        some.tuples(some.integers(0, 60), some.integers(0, 9), some.integers(0, 9)), max_size=6
    ),
)
def test_offsets_move_as_each_would_alone(
    values: list[int], edits: list[tuple[int, int, int]]
) -> None:
    offsets = Offsets(values)
    for start, old, new in edits:
        end = start + old
        first, last = offsets.after(start), offsets.after(end)
        offsets.edit(first, last, [start] * (last - first), new - old)
        values = [
            value if value <= start else start if value <= end else value + new - old
            for value in values
        ]
        assert [offsets[index] for index in range(len(offsets))] == values
        for place in range(0, 70, 3):
            assert offsets.after(place) == sum(value <= place for value in values)
            assert offsets.at_or_after(place) == sum(value < place for value in values)


@given(TEXTS, some.lists(some.tuples(some.floats(0, 1), some.floats(0, 1), TEXTS), max_size=5))
def test_rows_are_those_of_the_text_after_every_edit(
    text: str, edits: list[tuple[float, float, str]]
) -> None:
    buffer = Buffer(Session(text.encode(), environ={}))
    for at, until, new in edits:
        now = buffer.text.decode()
        start = int(at * len(now))
        end = start + int(until * (len(now) - start))
        buffer.edit(len(now[:start].encode()), len(now[:end].encode()), new.encode())
        fresh = Buffer(Session(buffer.text, environ={}))
        assert buffer.row_count == fresh.row_count
        for row in range(fresh.row_count):
            assert buffer.line_bytes(row) == fresh.line_bytes(row)
            assert buffer.next_start(row) == fresh.next_start(row)
        assert buffer.widest >= max(
            fresh.end(row) - fresh.start(row) for row in range(fresh.row_count)
        )


@given(some.text(max_size=20))
def test_cells_and_bytes_of_a_line_go_both_ways(text: str) -> None:
    line = Line(text.encode("utf-8", "replace"))
    column, cells = 0, [0]
    while column < line.size:
        following = line.next_stop(column)
        assert following > column
        assert line.previous_stop(following) == column
        column = following
        cells.append(line.cell(column))
    assert cells == sorted(cells)
    assert cells[-1] == line.width
    for cell in range(line.width):
        assert line.cell(line.column(cell)) <= cell
    assert line.piece(0, line.size) == line.shown


@pytest.mark.parametrize(
    ("text", "shown", "width"),
    [
        ("a\tb", "a→  b", 5),
        ("\t", "→   ", 4),
        ("日本", "日本", 4),
        ("e\u0301x", "e\u0301x", 2),
        ("a\x01b", "a␁b", 3),
        ("a\u202eb", "ab", 2),
        ("\u202e", "�", 1),
    ],
)
def test_what_a_line_shows(text: str, shown: str, width: int) -> None:
    line = Line(text.encode())
    assert (line.shown, line.width) == (shown, width)


@given(some.text(alphabet="ab 日\t", max_size=60), some.integers(4, 20))
def test_wrapped_pieces_fit_and_make_up_the_line(text: str, width: int) -> None:
    line = Line(text.encode())
    pieces = sections(line, width)
    assert pieces[0][0] == 0
    assert pieces[-1][1] == line.size
    for (_, end), (start, _) in pairwise(pieces):
        assert end == start
    if "\t" not in text:
        assert all(line.cell(end) - line.cell(start) <= width for start, end in pieces)


class TestHistory:
    def typed(self, text: str, into: str = "") -> TextState:
        state = state_of(into)
        for character in text:
            state.replace_selection(character.encode(), Kind.TYPE)
        return state

    def test_typing_is_undone_word_by_word(self) -> None:
        state = self.typed("one two three")
        seen = []
        while state.undo():
            seen.append(text_of(state))
        assert seen == ["one two ", "one ", ""]
        while state.redo():
            pass
        assert text_of(state) == "one two three"

    def test_moving_the_cursor_begins_a_step(self) -> None:
        state = self.typed("ab")
        state.move(1)
        state.replace_selection(b"x", Kind.TYPE)
        state.undo()
        assert text_of(state) == "ab"

    def test_deletes_in_a_row_are_one_step(self) -> None:
        state = state_of("abcdef", 6)
        for _ in range(3):
            state.delete(state.cursor - 1, state.cursor)
        assert text_of(state) == "abc"
        state.undo()
        assert (text_of(state), state.cursor) == ("abcdef", 6)

    def test_an_edit_forgets_what_was_undone(self) -> None:
        state = self.typed("a")
        state.undo()
        state.replace_selection(b"b", Kind.TYPE)
        assert not state.redo()

    def test_edits_at_several_places_are_one_step_in_terms_of_the_text_before(self) -> None:
        state = state_of("a b c")
        state.apply([(0, 1, b"xx"), (4, 5, b""), (2, 2, b"1"), (2, 2, b"2")])
        assert text_of(state) == "xx 12b "
        state.undo()
        assert text_of(state) == "a b c"

    @given(
        TEXTS.map(lambda text: text.replace("\r", "")),
        some.lists(
            some.tuples(some.floats(0, 1), some.floats(0, 0.3), TEXTS, some.sampled_from(Kind)),
            max_size=8,
        ),
    )
    def test_undoing_all_gives_the_text_back_and_redoing_all_too(
        self, text: str, edits: list[tuple[float, float, str, Kind]]
    ) -> None:
        state = state_of(text)
        for at, length, new, kind in edits:
            size = state.buffer.size
            start = state.buffer.clamp(int(at * size))
            end = state.buffer.clamp(start + int(length * size))
            state.select(start, max(start, end))
            state.replace_selection(new.encode(), kind)
        after = state.buffer.text
        while state.undo():
            pass
        assert text_of(state) == text
        while state.redo():
            pass
        assert state.buffer.text == after


@pytest.mark.parametrize(
    ("motion", "text", "stops"),
    [
        (motions.word_right, "create_node 'talker' as t", [0, 12, 13, 19, 21, 24, 25]),
        (motions.right, "aé\n日", [0, 1, 3, 4, 7]),
        (motions.right, "a\r\nb", [0, 1, 3, 4]),
        (motions.right, "e\u0301x", [0, 3, 4]),
    ],
)
def test_motions_forward(motion: object, text: str, stops: list[int]) -> None:
    buffer = Buffer(Session(text.encode(), environ={}))
    assert callable(motion)
    seen = [0]
    while seen[-1] < buffer.size:
        seen.append(motion(buffer, seen[-1]))
    assert seen == stops


@pytest.mark.parametrize(
    ("motion", "text", "stops"),
    [
        (motions.word_left, "create_node 'talker' as t", [25, 24, 21, 19, 13, 12, 0]),
        (motions.left, "aé\n日", [7, 4, 3, 1, 0]),
        (motions.left, "a\r\nb", [4, 3, 1, 0]),
    ],
)
def test_motions_backward(motion: object, text: str, stops: list[int]) -> None:
    buffer = Buffer(Session(text.encode(), environ={}))
    assert callable(motion)
    seen = [buffer.size]
    while seen[-1] > 0:
        seen.append(motion(buffer, seen[-1]))
    assert seen == stops


def test_home_goes_to_the_text_and_then_to_the_line() -> None:
    buffer = Buffer(Session(b"  abc", environ={}))
    assert [motions.line_start(buffer, at) for at in (5, 2, 0)] == [2, 0, 2]


@pytest.mark.parametrize(
    ("line", "at", "pair"),
    [
        ("((a)b)", 0, (0, 5)),
        ("((a)b)", 6, (5, 0)),
        ("((a)b)", 4, (3, 1)),
        ("(a", 0, None),
        ("[(])", 0, (0, 2)),
        ("abc", 1, None),
    ],
)
def test_brackets(line: str, at: int, pair: tuple[int, int] | None) -> None:
    assert motions.matching_brackets(Buffer(Session(line.encode(), environ={})), at) == pair


def test_a_bracket_in_a_string_is_none() -> None:
    buffer = Buffer(Session(b'(")") // )', environ={}))
    literal = [(1, 4), (6, 10)]
    assert [motions.matching_brackets(buffer, at, literal) for at in (0, 5, 3)] == [
        (0, 4),
        (4, 0),
        None,
    ]


def test_pasted_text_takes_the_line_endings_of_the_program() -> None:
    assert Buffer(Session(b"a\r\nb", environ={})).normalized("x\ny\r\nz") == b"x\r\ny\r\nz"
    assert Buffer(Session(b"a\nb", environ={})).normalized("x\r\ny\rz\0") == b"x\ny\nz"


def test_a_cursor_stands_in_no_character_and_in_no_line_ending() -> None:
    state = state_of("é\r\nx")
    for offset, place in ((1, 0), (3, 2), (4, 4), (99, 5)):
        state.move(offset)
        assert state.selection == Selection(place, place)
