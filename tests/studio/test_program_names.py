"""The names of a program: what there is of them, where, and how one is found."""

from __future__ import annotations

from pathlib import Path

import pytest
from rich.cells import cell_len
from studio_driver import studio
from textual.widgets import Label, OptionList

from plastron_tui.session import Session
from plastron_tui.studio.actions import ACTIONS, BY_ID
from plastron_tui.studio.program_names import ProgramName, names_of
from plastron_tui.studio.screens.menu_search import NAMES, answers

PROGRAM = """\
create_node 'pilot' as p
p has_parameter 'speed' of parameter_type float with default 0.3
create_message go of message_type Twist and input linear.x=0.3
p publish go to 'cmd_vel' of message_type Twist at 10 hz
create_node 'base' as base
subscribe base to '/cmd_vel' of message_type Twist calling drive
base provides_service 'reset' of service_type Trigger
create_message_type Mark with float64 x
create_robot 'rover' as rover
rover has_link 'body' shaped box 0.4, 0.3, 0.1
rover has_link 'wheel' shaped cylinder 0.1, 0.05
"""


def names() -> tuple[ProgramName, ...]:
    session = Session(PROGRAM.encode())
    return names_of(PROGRAM.encode(), session.program, session.workspace)


def test_each_name_stands_once_with_what_it_names_and_its_line() -> None:
    found = [(each.entry.text, each.kind, each.where) for each in names()]
    assert found == [
        ("pilot", "node", "line 1"),
        ("speed", "parameter of p", "line 2"),
        ("go", "message", "line 3"),
        ("/cmd_vel", "topic", "line 4"),
        ("base", "node", "line 5"),
        ("drive", "function of base", "line 6"),
        ("/reset", "service", "line 7"),
        ("Mark", "type", "line 8"),
        ("rover", "robot", "line 9"),
        ("body", "link of rover", "line 10"),
        ("wheel", "link of rover", "line 11"),
    ]
    assert names()[3].line.startswith("p publish go to 'cmd_vel'")


def test_a_function_that_is_called_no_more_is_none_of_the_names() -> None:
    text = b"load 'a.py' as a\na stop_repeating tick\na repeats tock at 2 hz\n"
    session = Session(text, environ={})
    found = names_of(text, session.program, session.workspace)
    assert [each.entry.text for each in found if each.kind == "function of a"] == ["tock"]


@pytest.mark.parametrize(
    ("query", "first"),
    [
        ("cmd_vel", "/cmd_vel"), ("'/cmd_vel'", "/cmd_vel"), ("@cm", "/cmd_vel"), ("@", "pilot"),
        ("vel", "/cmd_vel"), ("topic", "/cmd_vel"), ("@link whe", "wheel"), ("@p", "pilot"),
        ("rover", "rover"), ("rst", "/reset"), ("SPEED", "speed"),
    ],
)  # fmt: skip
def test_a_name_is_found_by_its_beginning_its_parts_and_its_letters(query: str, first: str) -> None:
    named = [each.name.entry.text for each in answers(query, ACTIONS, [], names()) if each.name]
    assert named[0] == first


def test_names_stand_below_their_heading_and_first_where_no_title_begins_so() -> None:
    entries = answers("save", ACTIONS, [], names())
    assert [each.action for each in entries[:1]] == [BY_ID["save"]]
    entries = answers("base", ACTIONS, [], names())
    assert entries[0].heading == NAMES
    assert entries[1].name is not None
    # "List where it is used" has a word that begins so.
    entries = answers("whe", ACTIONS, [], names())
    assert entries[1].name is not None and entries[-1].action is not None
    entries = answers("go", ACTIONS, [], names())
    assert entries[0].action is not None
    at = [each.heading for each in entries].index(NAMES)
    assert all(each.action for each in entries[:at])
    assert next(each.name.entry.text for each in entries[at + 1 :] if each.name) == "go"
    assert answers("@xyzzy", ACTIONS, [], names()) == ()
    assert not any(each.action for each in answers("@save", ACTIONS, [], names()))


async def test_the_menu_leads_to_a_name_and_back(program: Path) -> None:
    program.write_text(PROGRAM)
    async with studio(program, (80, 24)) as driver:
        await driver.pilot.press("f10", *"base")
        menu = await driver.dialog("ActionMenu")
        options = menu.query_one(OptionList)
        await driver.until(lambda: menu.entries and menu.entries[0].heading == NAMES)
        row = str(options.get_option_at_index(1).prompt)
        assert row.split() == ["●", "base", "node", "line", "5"]
        assert cell_len(row) <= options.scrollable_content_region.width
        said = menu.query_one("#menu-help", Label)
        await driver.until(lambda: str(said.content) == "create_node 'base' as base")
        await driver.pilot.press("enter")
        await driver.back()
        assert driver.main.editor.state.row == 4
        assert driver.main.editor.view.has_focus
        await driver.pilot.press("alt+a")
        menu = await driver.dialog("ActionMenu")
        await driver.pilot.press(*"whe", "enter")
        await driver.back()
        assert driver.main.editor.state.row == 10
        await driver.press("alt+comma", "alt+comma")
        assert driver.main.editor.state.row == 0
        assert driver.app.profile.remembered.actions == []
