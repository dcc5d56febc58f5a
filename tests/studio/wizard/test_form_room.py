"""What a form's page shows where it has too few lines: the words that say what to write."""

from __future__ import annotations

from pathlib import Path

import pytest
from textual.widgets import Label, OptionList
from wizard_courses import MAKE
from wizard_driver import wizard

from plastron_tui.studio.wizard.form_room import Room, Wanted, first_choices, room_for


@pytest.mark.parametrize(
    ("wanted", "height", "is_read", "room"),
    [
        (Wanted(2, 5, 2, 4), 20, False, Room(True, 12)),
        (Wanted(4, 9, 3, 4), 17, False, Room(False, 10)),
        (Wanted(4, 9, 3, 4), 17, True, Room(True, 6)),
        (Wanted(4, 9, 3, 0), 17, False, Room(True, 10)),
        (Wanted(4, 9, 6, 6), 15, True, Room(False, 3)),
        (Wanted(4, 1, 3, 4), 12, True, Room(True, 3)),
    ],
    ids=["all", "words that help", "read first", "no choices", "rows at least", "one row"],
)
def test_the_sentence_above_gives_way(
    wanted: Wanted, height: int, is_read: bool, room: Room
) -> None:
    assert room_for(wanted, height, is_read=is_read) == room


def test_two_choices_have_to_be_in_sight() -> None:
    assert [first_choices(each) for each in ([], [1], [2, 2, 3])] == [0, 1, 4]


async def test_a_mistake_is_whole_in_a_small_window(here: Path) -> None:
    async with wizard() as it:
        await it.go(MAKE, "drive until something is near")
        assert it.form.query_one("#wizard-about").display
        await it.write("condition", "fo")
        page, said = it.form.region, it.form.query_one("#wizard-help", Label)
        shown = it.form.query_one("#wizard-choices", OptionList)
        assert it.help.startswith("✗ it says when it drives") and it.help.endswith("> 0.5`")
        assert not it.form.query_one("#wizard-about").display
        # The label has the height of its text, and two choices of two lines are below it.
        assert said.region.height == said.virtual_size.height == 2
        assert page.contains_region(shown.region) and shown.region.height >= 4
        assert it.row("condition").region.height == 1
