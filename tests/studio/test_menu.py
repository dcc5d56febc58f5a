"""The menu of all actions."""

from __future__ import annotations

from pathlib import Path

import pytest
from rich.cells import cell_len
from studio_driver import SIZES, studio
from textual.widgets import OptionList

from plastron_tui.studio.actions import ACTIONS, BY_ID, grouped
from plastron_tui.studio.config import load_remembered
from plastron_tui.studio.panels.key_list import KeyList
from plastron_tui.studio.screens.menu_search import RECENT, WORDS, answers, listed


def test_all_actions_stand_under_their_headings_with_those_of_late_before_them() -> None:
    entries = listed(grouped(), ["editor.find", "gone", "run", "editor.find"])
    assert [entry.heading for entry in entries if entry.action is None] == [
        RECENT, *(group for group, _ in grouped())
    ]  # fmt: skip
    assert [entry.action.id for entry in entries[1:3] if entry.action] == ["editor.find", "run"]
    assert {entry.action.id for entry in entries[3:] if entry.action} == set(BY_ID)
    assert listed(grouped(), [])[0].heading != RECENT
    assert set(WORDS) <= set(BY_ID)


@pytest.mark.parametrize(
    ("query", "first"),
    [
        ("run", "run"), ("exit", "quit"), ("settings", "config"), ("colour", "theme"),
        ("colors", "theme"), ("shortcuts", "keys"), ("search", "editor.find"),
        ("RENAME", "editor.rename"),
        ("gtl", "editor.go_to_line"), ("line go", "editor.go_to_line"), ("save as", "save_as"),
        ("save", "save"), ("start", "run"), ("tutorial", "tour"), ("vim", "editor.external_editor"),
        ("next prob", "editor.next_problem"), ("errors", "problems"),
    ],
)  # fmt: skip
def test_what_one_types_finds_titles_synonyms_and_help(query: str, first: str) -> None:
    entries = answers(query, ACTIONS, [], ())
    assert entries[0].action is BY_ID[first]


def test_what_fits_as_well_and_was_done_of_late_comes_first() -> None:
    names = [entry.action.id for entry in answers("find", ACTIONS, [], ()) if entry.action]
    assert names[:3] == ["editor.find", "editor.find_next", "editor.find_previous"]
    late = [entry.action.id for entry in answers("find", ACTIONS, names[2:3], ()) if entry.action]
    assert late[0] == "editor.find_previous"
    assert answers("xyzzy", ACTIONS, [], ()) == ()


@pytest.mark.parametrize("size", SIZES)
async def test_the_menu_finds_does_and_remembers(program: Path, size: tuple[int, int]) -> None:
    async with studio(program, size) as driver:
        await driver.pilot.press("ctrl+p")
        menu = await driver.dialog("ActionMenu")
        options = menu.query_one(OptionList)
        await driver.until(lambda: menu.entries)
        assert {entry.action.id for entry in menu.entries if entry.action} == set(BY_ID) - {"menu"}

        def row() -> str:
            return str(options.get_option_at_index(1).prompt)

        await driver.until(lambda: len(row()) == options.scrollable_content_region.width)
        assert row().rstrip().endswith(driver.main.key_of("help"))
        # The status and the keys below stay in sight, and the help is read whole.
        assert menu.query_one("#menu").region.bottom <= size[1] - 2
        assert menu.query_one("#menu-help").size.height == 2
        await driver.pilot.press("down", "down", "up")
        await driver.until(lambda: menu.entries[options.highlighted].action is BY_ID["run"])
        await driver.pilot.press("escape")
        await driver.back()
        assert driver.app.profile.remembered.actions == []
        wraps = driver.main.editor.view.soft_wrap
        await driver.pilot.press("f10", *"exit")
        menu = await driver.dialog("ActionMenu")
        await driver.until(lambda: menu.entries and menu.entries[0].action is BY_ID["quit"])
        await driver.pilot.press(*("backspace",) * 4, *"soft", "enter")
        await driver.back()
        assert driver.main.editor.view.soft_wrap != wraps
        await driver.pilot.press("f10")
        menu = await driver.dialog("ActionMenu")
        await driver.until(lambda: menu.entries)
        assert menu.entries[0].heading == RECENT
        await driver.pilot.press("enter")
        await driver.back()
        assert driver.main.editor.view.soft_wrap == wraps
        await driver.pilot.press("f10", *"xyzzy", "enter")
        assert type(driver.app.screen).__name__ == "ActionMenu"
        await driver.pilot.press("escape")
        await driver.back()
        folder = driver.app.profile.folder
    assert load_remembered(folder).actions == ["editor.toggle_wrap"]


async def test_what_is_said_of_a_row_that_has_gone_is_no_error(program: Path) -> None:
    async with studio(program) as driver:
        await driver.pilot.press("f10")
        menu = await driver.dialog("ActionMenu")
        options = menu.query_one(OptionList)
        last = options.get_option_at_index(len(menu.entries) - 1)
        options.post_message(OptionList.OptionHighlighted(options, last, len(menu.entries)))
        await driver.pilot.press(*"xyzzy")
        assert driver.app.screen is menu


async def test_the_keys_are_at_the_side_of_a_text_that_is_read_whole(program: Path) -> None:
    async with studio(program, (120, 40)) as driver:
        main = driver.main
        await driver.press("alt+k")
        listed = main.query_one(KeyList)
        assert listed.has_focus
        assert listed.text.startswith("Studio\n")
        assert not {"Super", "Ctrl-Shift-Z"} & set(listed.text.replace("-C", "").split())
        widest = max(sum(cell_len(piece.text) for piece in row) for row in listed.rows)
        assert widest <= listed.size.width
        view = main.editor.view
        assert view.region.right <= listed.region.x
        assert view.size.width >= 70
        await driver.press("end")
        assert listed.is_vertical_scroll_end
        # They follow the focus.
        await driver.show("nodes")
        assert listed.text.startswith("Here\n")
        assert "F2" in listed.text.split("Studio")[0]
        await driver.press("alt+k")
        assert not main.query(KeyList)
        await driver.press("alt+k", "escape")
        assert not main.query(KeyList)
        assert main.panels["nodes"].has_focus
