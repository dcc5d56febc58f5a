"""Where the cursor jumped from, and the way back: in one text, and from text to text."""

from __future__ import annotations

from hypothesis import given, settings
from hypothesis import strategies as some
from machine import examples

from plastron_tui.session import Session
from plastron_tui.studio.editor.jumps import MOST, Jumps
from plastron_tui.studio.editor.state import TextState

TEXT = "".join(f"line {number}\n" for number in range(200))
LETTERS = "ab é\n"
LENGTHS = TEXT.encode().split(b"\n")


def jumps_in(text: str = TEXT) -> tuple[TextState, Jumps]:
    state = TextState(Session(text.encode()))
    return state, Jumps(state)


def start_of(row: int) -> int:
    return sum(len(line) + 1 for line in LENGTHS[:row])


def go(state: TextState, jumps: Jumps, by: int) -> int | None:
    """Go back or forth; return the row."""
    place = jumps.turn(by)
    if place is None:
        return None
    state.move(place.offset)
    return state.row


def test_one_goes_back_and_forth_and_from_a_new_jump_on_there_is_no_way_forth() -> None:
    state, jumps = jumps_in()
    for row in (10, 20, 30):
        jumps.jump(start_of(row), start_of(row))
    assert [go(state, jumps, -1) for _ in range(4)] == [20, 10, 0, None]
    assert [go(state, jumps, 1) for _ in range(4)] == [10, 20, 30, None]
    go(state, jumps, -1)
    jumps.jump(start_of(50), start_of(50))
    assert go(state, jumps, 1) is None
    assert [go(state, jumps, -1) for _ in range(3)] == [20, 10, 0]


def test_of_steps_that_belong_together_only_the_beginning_is_a_place() -> None:
    state, jumps = jumps_in()
    state.move(start_of(5))
    for row in (10, 20, 30):
        jumps.jump(start_of(row), start_of(row) + 4, walk="find")
    for row in (40, 50):
        jumps.jump(start_of(row), start_of(row), walk="problems")
    assert [go(state, jumps, -1) for _ in range(3)] == [30, 5, None]
    # Who moved the cursor, or came back, begins another walk.
    jumps.jump(start_of(7), start_of(7), walk="find")
    state.move(start_of(60))
    jumps.jump(start_of(70), start_of(70), walk="find")
    assert [go(state, jumps, -1) for _ in range(3)] == [60, 5, None]


def test_a_walk_in_which_matches_are_replaced_is_one_walk() -> None:
    state, jumps = jumps_in()
    state.move(start_of(5))
    jumps.jump(start_of(10), start_of(10) + 4, walk="find")
    state.replace_selection(b"a longer word")
    jumps.jump(start_of(20), start_of(20) + 4, walk="find")
    assert [go(state, jumps, -1) for _ in range(2)] == [5, None]


def test_the_way_back_has_an_end_and_a_line_is_one_place() -> None:
    state, jumps = jumps_in()
    for row in range(MOST + 30):
        jumps.jump(start_of(row), start_of(row))
    steps = 0
    while go(state, jumps, -1) is not None:
        steps += 1
    assert steps == MOST
    state, jumps = jumps_in()
    for column in (1, 2, 3):
        jumps.jump(column, column)
    assert go(state, jumps, -1) is None


def test_places_are_in_the_text_that_they_were_in_and_go_with_it() -> None:
    state, jumps = jumps_in()
    first = state.buffer.session
    state.move(start_of(5))
    jumps.leave()
    second = Session(b"another\n")
    state.open(second)
    # What is edited here moves nothing there.
    state.replace_selection(b"a line\n")
    place = jumps.turn(-1)
    assert place is not None
    assert place == (first, start_of(5))
    third = Session(TEXT.encode())
    jumps.hand_on(second, third)
    state.open(first)
    place = jumps.turn(1)
    assert place is not None
    assert place.session is third
    jumps.forget(first)
    assert jumps.turn(-1) is None


@settings(max_examples=examples(50), deadline=None)
@given(
    row=some.integers(0, 199),
    edits=some.lists(
        some.tuples(some.integers(-30, 30), some.integers(0, 40), some.text(LETTERS, max_size=9)),
        max_size=5,
    ),
)
def test_a_place_stays_before_the_letter_that_it_was_before(
    row: int, edits: list[tuple[int, int, str]]
) -> None:
    mark = "§".encode()
    state, jumps = jumps_in()
    at = start_of(row)
    state.apply([(at, at, mark)])
    state.move(at)
    jumps.leave()
    for near, length, new in edits:
        begin = state.buffer.clamp(state.buffer.text.index(mark) + near)
        end = state.buffer.clamp(begin + length)
        if begin < end and mark in state.buffer.text[begin:end]:
            continue
        state.apply([(begin, end, new.encode())])
    # From a line of another text, so that no line is the cursor's.
    state.open(Session(b""))
    place = jumps.turn(-1)
    assert place is not None
    assert place.session.document.text[place.offset :].startswith(mark)
