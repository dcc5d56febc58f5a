"""What is in view beside a page of the wizard, in every size and colour."""

from __future__ import annotations

from pathlib import Path

import pytest
from machine import mostly_long
from rich.cells import cell_len
from studio_driver import studio
from textual.widgets import OptionList
from wizard_courses import CHANGE, MAKE, MORE, NODE_FILE, REACT, SEND
from wizard_driver import WizardDriver, wizard

from plastron_tui.studio.panels.text_view import TextView
from plastron_tui.studio.wizard.ask import Choice
from plastron_tui.studio.wizard.pages import PageKind
from plastron_tui.studio.wizard.rows import Turn

SIZES = [(60, 20), (80, 24), (120, 40), (200, 60)]


@pytest.mark.parametrize("size", mostly_long(SIZES, [(60, 20)]))
async def test_statement_code_and_graph_are_in_view_as_they_grow(
    here: Path, size: tuple[int, int]
) -> None:
    async with wizard(size=size) as it:
        assert it.statements == ()
        await it.pick(MAKE)
        assert it.statements == ("create_node 'talker' as talker",)
        await it.write("name", "horn")
        assert it.statements == ("create_node 'horn' as horn",)
        await it.press("enter")
        await it.pick(SEND)
        await it.write("topic", "toot")
        assert it.statements == (
            "create_node 'horn' as horn",
            'create_message toot_message of message_type String and input "hello"',
            "horn publish toot_message to 'toot' of message_type String at 10 hz",
            "generate_node horn",
        )
        if size[0] < 76:
            assert not it.screen.query_one("#wizard-code").region
            await it.press("f3")
        assert it.screen.query_one("#wizard-code").region
        assert it.screen.query_one("#wizard-graph").region
        assert it.screen.query_one("#wizard-statements").region
        assert '"toot"' in it.view("code")
        assert "/toot" in it.view("graph") and "horn" in it.view("graph")
        graph = it.screen.query_one("#wizard-graph", TextView)
        marked = {piece.text for line in graph.lines for piece in line if piece.tone == "added"}
        assert {"horn", "/toot"} <= {text.strip() for text in marked}


@pytest.mark.long
async def test_what_was_there_before_is_not_marked(two: Path) -> None:
    async with wizard(two) as it:
        await it.go(MORE, REACT)
        await it.write("node", "talker")
        await it.write("topic", "chatter")
        graph = it.screen.query_one("#wizard-graph", TextView)
        marked = [piece.text for line in graph.lines for piece in line if piece.tone == "added"]
        assert marked == ["talker"]
        assert it.view("graph").split("\n")[0] == "talker → /chatter → talker, listener"


async def test_the_view_goes_to_the_code_that_changed(here: Path) -> None:
    async with wizard() as it:
        await it.go(MAKE, SEND)
        code = it.screen.query_one("#wizard-code", TextView)
        rows = code.text.split("\n")
        wanted = next(number for number, row in enumerate(rows) if "def publish_" in row)
        assert code.scroll_offset.y <= wanted < code.scroll_offset.y + code.size.height
        # The last page stands there as well, with more room, and marks what is new.
        was_wide = code.size.width
        await it.press("enter", "enter")
        assert it.kind is PageKind.REVIEW
        assert code.size.width > was_wide
        rows = code.text.split("\n")
        wanted = next(number for number, row in enumerate(rows) if "def publish_" in row)
        assert rows[wanted][0] == "+" and rows[0] == " #!/usr/bin/env python3"
        assert code.scroll_offset.y <= wanted < code.scroll_offset.y + code.size.height
        # What would be written is said whole, and a box is ticked by Space.
        await it.press("shift+tab", "space")
        assert it.statements[-1] != "generate_node talker"
        await it.pilot.resize_terminal(30, 24)
        await it.settle()
        box = it.screen.query_one("#wizard-generates", Turn)
        assert box.size.height == 2 and box.render_line(0).text.startswith("[ ] write")
        await it.pilot.resize_terminal(80, 24)
        await it.press("f2", "f2")
        # The field is lit, and what it has of the list only marked.
        it.form.show_choices([Choice("a"), Choice("b", closed="it is taken")])
        choices = it.screen.query_one("#wizard-choices", OptionList)
        mark = choices.get_component_styles("option-list--option-highlighted").background
        assert it.form.row_here is not None
        assert mark.rgb != it.form.row_here.box.styles.background.rgb


async def test_of_a_file_that_exists_the_change_is_shown(here: Path) -> None:
    (here / "sonar.py").write_text(NODE_FILE)
    async with wizard() as it:
        await it.pick(CHANGE)
        assert it.rows["source"] == "sonar.py" and it.choices == ["sonar.py"]
        await it.press("enter")
        await it.pick(REACT)
        lines = it.view("code").split("\n")
        changed = [line.lstrip(" 0123456789") for line in lines]
        assert "+rospy.Subscriber('chatter', String, on_chatter)" in changed
        assert not [line for line in changed if line.startswith("-")]


@pytest.mark.long
async def test_another_size_keeps_what_was_entered(here: Path) -> None:
    async with wizard() as it:
        await it.go(MAKE, SEND)
        await it.press("enter")
        assert it.title == "Make a message · message"
        await it.write("data", "hi")
        for size in [*SIZES, (40, 12), (80, 24)]:
            await it.pilot.resize_terminal(*size)
            await it.settle()
            assert it.rows["data"] == "hi"
        await it.press("enter")
        assert it.kind is PageKind.REVIEW
        assert '"hi"' in it.statements[1]


@pytest.mark.parametrize(
    "theme", mostly_long(["ansi-dark", "ansi-light", "textual-light", "nord"], [])
)
async def test_it_works_in_other_colours(here: Path, theme: str) -> None:
    async with studio(None) as driver:
        driver.app.theme = theme
        it = WizardDriver(driver)
        await driver.pilot.press("ctrl+u")
        await driver.until(lambda: it.is_open)
        await it.settle()
        await it.go(MAKE, SEND)
        await it.press("enter")
        assert it.title == "Make a message · message"
        focused = it.screen.focused
        other = it.row("variable").box
        assert focused is not None and focused is not other
        assert focused.rich_style != other.rich_style
        await it.press("enter")
        assert it.kind is PageKind.REVIEW


async def test_a_low_window_has_its_rows_for_the_form(here: Path) -> None:
    async with wizard(size=(80, 10)) as it:
        await it.pick(MAKE)
        for rows, has_sentence in ((10, False), (18, True), (10, False)):
            await it.pilot.resize_terminal(80, rows)
            await it.settle()
            sentence = it.form.query_one("#wizard-about")
            assert bool(sentence.region) is has_sentence
            assert it.row("name").box.region


async def test_what_was_right_stays_in_view_as_long_as_something_is_wrong(here: Path) -> None:
    async with wizard() as it:
        await it.go(MAKE, SEND)
        before = it.view("code"), it.view("graph")
        assert "def publish_" in before[0]
        await it.write("rate", "often")
        assert "a number of times a second" in it.help
        assert (it.view("code"), it.view("graph")) == before


@pytest.mark.parametrize("size", mostly_long([(80, 24), (120, 40)], [(120, 40)]))
async def test_the_code_is_not_cut_and_the_form_begins_at_what_matters(
    here: Path, size: tuple[int, int]
) -> None:
    async with wizard(size=size) as it:
        await it.go(MAKE, SEND)
        assert it.form.row_here is it.row("topic")
        await it.write("topic", "cmd_vel")
        code = it.screen.query_one("#wizard-code", TextView)
        assert "Twist" in it.view("code")
        room = code.scrollable_content_region.width
        assert all(sum(cell_len(piece.text) for piece in row) <= room for row in code.rows)
        page = it.screen.query_one("#wizard-page")
        is_framed = size[0] >= 110
        assert bool(it.screen.query_one("#wizard-head").region) is not is_framed
        assert (page.styles.border_top[0] == "round") is is_framed
        assert page.border_title == it.title == "Send something · publisher"
        assert size[0] < 110 or room >= page.size.width - 4
        await it.press("enter")
        here_now = it.form.row_here
        assert here_now is it.row("x") and here_now.text == "0.2"
        assert it.help == "linear.x (float64): m/s, forward, below 0 backward"
