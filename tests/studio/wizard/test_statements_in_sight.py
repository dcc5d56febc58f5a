"""What is in sight where there is no room for all, and letters in menus."""

from __future__ import annotations

import pytest

from plastron_tui.studio.wizard.menu_page import next_with
from plastron_tui.studio.wizard.rows import shortened
from plastron_tui.studio.wizard.statement_view import fitting


@pytest.mark.parametrize(
    ("heights", "here", "rows", "shown"),
    [
        ([], -1, 3, range(0)),
        ([1, 1, 2], -1, 4, range(3)),
        ([1, 1, 2, 1], -1, 4, range(3)),
        ([1, 1, 1, 2], 3, 3, range(2, 4)),
        ([1, 1, 1, 2, 1], 1, 3, range(3)),
        ([5, 1], 0, 3, range(1)),
    ],
    ids=["none", "all", "the first", "down to the one at hand", "with it", "one that is too high"],
)
def test_the_statement_at_hand_is_in_sight(
    heights: list[int], here: int, rows: int, shown: range
) -> None:
    assert fitting(heights, here, rows) == shown


@pytest.mark.parametrize(
    ("letter", "here", "found"),
    [("d", None, 0), ("d", 0, 3), ("D", 3, 0), ("u", 0, 4), ("s", 0, None), ("x", 0, None)],
)
def test_a_letter_leads_to_the_next_entry_that_can_be_chosen(
    letter: str, here: int | None, found: int | None
) -> None:
    titles = ["drive", "send", "ask", "do", "use"]
    assert next_with(letter, titles, [0, 2, 3, 4], here) == found


@pytest.mark.parametrize(
    ("text", "room", "shown"),
    [
        ("m/s, forward, below 0 backward", 30, "m/s, forward, below 0 backward"),
        ("m/s, forward, below 0 backward", 29, "m/s, forward"),
        ("m/s, sideways to the left", 18, "m/s, sideways to…"),
        ("m/s, sideways to the left", 9, "m/s"),
        ("m/s, forward", 2, "m/s, forward"),
    ],
)
def test_what_a_field_means_is_not_cut_within_a_word(text: str, room: int, shown: str) -> None:
    assert shortened(text, room) == shown
