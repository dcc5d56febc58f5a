"""What is on the wizard's screen."""

from __future__ import annotations

import threading
from pathlib import Path

import pytest
from studio_driver import studio
from textual.widgets import Checkbox
from wizard_courses import NODE_FILE, TWO_NODES
from wizard_driver import WizardDriver, wizard

from plastron_tui.runtime.environment import Environment, Origin
from plastron_tui.studio.panels.text_view import TextView
from plastron_tui.studio.screens.main import MainScreen
from plastron_tui.studio.wizard import screen
from plastron_tui.studio.wizard.course import PageKind
from plastron_tui.studio.wizard.rows import Row

MAKE = "make a node"
SEND = "send something, again and again"
REACT = "react to what others send"
MORE = "give a node something more to do"
SIZES = [(60, 20), (80, 24), (120, 40), (200, 60)]


async def to_message(it: WizardDriver) -> None:
    """Go to the values of the message of a new node."""
    await it.pick(MAKE)
    await it.press("enter")
    await it.pick(SEND)
    await it.press("enter")
    assert it.title == "Make a message · message"


@pytest.mark.parametrize("size", SIZES)
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


async def test_what_was_there_before_is_not_marked(here: Path) -> None:
    path = here / "two.plastron"
    path.write_text(TWO_NODES)
    async with wizard(path) as it:
        await it.pick(MORE)
        await it.pick(REACT)
        await it.write("node", "talker")
        await it.write("topic", "chatter")
        graph = it.screen.query_one("#wizard-graph", TextView)
        marked = [piece.text for line in graph.lines for piece in line if piece.tone == "added"]
        assert marked == ["talker"]
        assert it.view("graph").split("\n")[0] == "talker → /chatter → talker, listener"


async def test_the_view_goes_to_the_code_that_changed(here: Path) -> None:
    async with wizard() as it:
        await it.pick(MAKE)
        await it.press("enter")
        await it.pick(SEND)
        code = it.screen.query_one("#wizard-code", TextView)
        rows = code.text.split("\n")
        wanted = next(number for number, row in enumerate(rows) if "def publish_" in row)
        assert code.scroll_offset.y <= wanted < code.scroll_offset.y + code.size.height


async def test_of_a_file_that_exists_the_change_is_shown(here: Path) -> None:
    (here / "sonar.py").write_text(NODE_FILE)
    async with wizard() as it:
        await it.pick("change a node file that exists")
        assert it.rows["source"] == "sonar.py" and it.choices == ["sonar.py"]
        await it.press("enter")
        await it.pick(REACT)
        lines = it.view("code").split("\n")
        assert "+rospy.Subscriber('chatter', String, on_chatter)" in lines
        assert not [line for line in lines if line.startswith("-")]


async def test_a_type_is_found_by_what_it_is_for(here: Path) -> None:
    async with wizard() as it:
        await it.pick(MAKE)
        await it.press("enter")
        await it.pick(SEND)
        await it.write("type", "distance")
        assert it.choices[0] == "Range"
        assert "sensor_msgs" in it.form.choices[0].note
        assert "float32" in it.form.choices[0].about
        await it.press("down")
        assert it.rows["type"] == "Range"
        assert it.choices[0] == "Range"
        await it.press("down", "up")
        assert it.rows["type"] == "Range"
        await it.press("enter")
        assert "radiation type" in [label.replace("_", " ") for label in it.rows]


async def test_a_type_is_taken_by_mouse(here: Path) -> None:
    async with wizard() as it:
        await it.pick(MAKE)
        await it.press("enter")
        await it.pick(SEND)
        await it.write("type", "laser")
        await it.click_choice("LaserScan")
        assert it.rows["type"] == "LaserScan"
        await it.click("#wizard-next")
        assert "angle_min" in it.rows


async def test_the_topic_that_is_there_comes_first_and_brings_its_type(here: Path) -> None:
    path = here / "one.plastron"
    path.write_text(
        "create_node 'eye' as eye\ncreate_message image of message_type Image and input none\n"
        "eye publish image to 'camera/image_raw' of message_type Image\ngenerate_node eye\n"
    )
    async with wizard(path) as it:
        await it.pick(MAKE)
        await it.press("enter")
        assert it.here == REACT
        await it.press("enter")
        assert it.rows["topic"] == "camera/image_raw"
        assert it.row("type").is_fixed and it.rows["type"] == "Image"
        assert it.form.choices[0].note == "sensor_msgs/Image"
        assert it.form.choices[0].about == "from eye"


async def test_a_node_that_is_not_there_yet_has_a_page_of_its_own(here: Path) -> None:
    path = here / "two.plastron"
    path.write_text(TWO_NODES)
    async with wizard(path) as it:
        await it.pick(MORE)
        await it.pick(REACT)
        await it.go_to("node")
        await it.click_choice("a new node")
        assert it.rows["node"] == "a new node"
        await it.press("enter")
        assert it.title == "Make a node · node"
        await it.write("name", "ears")
        await it.press("enter")
        assert it.kind is PageKind.REVIEW
        assert it.statements == (
            "create_node 'ears' as ears",
            "subscribe ears to 'chatter' of message_type String",
            "generate_node ears",
        )


async def test_a_message_that_is_there_needs_no_page(here: Path) -> None:
    path = here / "two.plastron"
    path.write_text(TWO_NODES)
    async with wizard(path) as it:
        await it.pick(MORE)
        await it.pick(SEND)
        await it.go_to("message")
        assert it.rows["message"] == "a new message"
        await it.press("down")
        assert it.rows["message"] == "greeting"
        assert it.row("type").is_fixed and it.rows["type"] == "String"
        await it.press("enter")
        assert it.kind is PageKind.REVIEW
        await it.press("f2")
        await it.go_to("message")
        await it.press("up")
        assert it.rows["message"] == "a new message"
        assert not it.row("type").is_fixed


async def test_a_part_of_a_name_narrows_the_choices_down(here: Path) -> None:
    path = here / "two.plastron"
    path.write_text(TWO_NODES)
    async with wizard(path) as it:
        await it.pick(MORE)
        await it.pick(REACT)
        await it.write("node", "tal")
        assert it.choices == ["talker"]
        await it.press("down")
        assert it.rows["node"] == "talker"


@pytest.mark.parametrize("steps", range(6))
async def test_help_explains_every_page(here: Path, steps: int) -> None:
    async with wizard() as it:
        for _ in range(steps):
            await it.press("enter")
        title = it.title
        await it.pilot.press("f1")
        question = await it.driver.dialog("Question")
        assert str(question.query_one("#dialog-title").content) == title
        text = str(question.query_one("#dialog-text").content)
        assert "leaves no trace" in text
        if steps == 1:
            assert "create_node 'NODE_NAME' as VARIABLE [using CLIENT_LIBRARY]" in text
        await it.pilot.press("enter")
        await it.settle()
        assert it.title == title


def shown(row: Row) -> str:
    return str(row.query_one(Checkbox).render()).strip()


async def test_the_values_are_a_form_with_a_row_a_field(here: Path) -> None:
    async with wizard() as it:
        await it.pick("make a message")
        await it.write("type", "Twist")
        assert list(it.rows) == ["variable", "type", "x", "y", "z"]
        assert it.statements == ("create_message message of message_type Twist and input none",)
        await it.write("x", "0.5")
        assert it.statements[0].endswith("and input linear.x=0.5")
        assert it.help == "linear.x (float64)"
        await it.write("type", "Bool")
        assert it.row("data").is_switch and it.rows["data"] == "True"
        await it.go_to("data")
        await it.press("space")
        assert it.statements[0].endswith("and input False")
        await it.click("Turn")
        assert it.statements[0].endswith("and input none")
        assert shown(it.row("data")) == "▐ ▌ False (default)"
        await it.click("Turn")
        assert it.statements[0].endswith("and input True")
        assert shown(it.row("data")) == "▐X▌ True"
        # What was entered for the other type is not forgotten.
        await it.write("type", "Twist")
        assert it.statements[0].endswith("and input linear.x=0.5")


async def test_constants_are_offered(here: Path) -> None:
    async with wizard() as it:
        await it.pick("make a message")
        await it.write("type", "BatteryState")
        await it.go_to("power_supply_health")
        assert "1" in it.choices
        assert "POWER_SUPPLY_HEALTH_GOOD" in [choice.note for choice in it.form.choices]
        await it.press("down", "down")
        assert it.statements[0].endswith("and input power_supply_health=1")


async def test_the_library_is_what_is_installed_and_explained(
    here: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    there = Environment(Origin.EXTRA, 2, "kilted", Path("/usr/bin/python3"))
    may_answer = threading.Event()

    def slow(environ: object) -> tuple[Environment, ...]:
        may_answer.wait(5)
        return (there,)

    monkeypatch.setattr(screen, "installed", slow)
    async with studio(None) as driver:
        it = WizardDriver(driver)
        await driver.pilot.press("ctrl+u")
        await driver.until(lambda: it.is_open and it.screen._shown is not None)
        # The look for a ROS takes its time; the form waits for it, not the menu.
        await driver.pilot.press("enter")
        await driver.until(lambda: it.kind is PageKind.FORM)
        may_answer.set()
        await it.settle()
        assert it.statements == ("create_node 'talker' as talker using rclpy",)
        await it.go_to("library")
        assert (
            it.help == "rclpy, because ROS 2 kilted (from the Python packages) is on this machine"
        )
        about = {choice.text: choice.closed or choice.about for choice in it.form.choices}
        assert about["rclpy"] == "ROS 2 kilted (from the Python packages)"
        assert "not installed here" in about["rospy"]
        assert "does not write it yet" in about["roscpp"]


async def test_the_file_may_be_left_out(here: Path) -> None:
    async with wizard() as it:
        await it.pick(MAKE)
        await it.press("enter")
        await it.pick(REACT)
        await it.press("enter")
        assert it.kind is PageKind.REVIEW
        assert it.statements[-1] == "generate_node talker"
        await it.click("#wizard-generates")
        assert it.statements[-1].startswith("subscribe")
        await it.press("enter")
        assert "generate_node" not in it.driver.text
        closed = {item.title: item.closed for item in it.screen._items}
        assert (
            closed["write the files"]
            == closed["run the nodes"]
            == ("the program writes no node to a file yet")
        )


@pytest.mark.parametrize("entry", ["write the files", "run the nodes", "back to the text"])
async def test_what_comes_after(here: Path, entry: str, monkeypatch: pytest.MonkeyPatch) -> None:
    done: list[str] = []
    monkeypatch.setattr(MainScreen, "action_generate", lambda _: done.append("write the files"))
    monkeypatch.setattr(MainScreen, "action_run", lambda _: done.append("run the nodes"))
    path = here / "two.plastron"
    path.write_text(TWO_NODES)
    async with wizard(path) as it:
        await it.pick("make a message")
        await it.press("enter", "enter")
        assert it.screen.is_done
        await it.click_item(entry)
        assert not it.is_open
        assert done == ([] if entry == "back to the text" else [entry])
        assert it.driver.main.editor.view.has_focus


async def test_write_the_files_writes_at_once_where_all_is_generated(here: Path) -> None:
    path = here / "two.plastron"
    path.write_text(TWO_NODES)
    async with wizard(path) as it:
        await it.pick("write a node to its file")
        await it.driver.dialog("GenerateDialog")


async def test_a_mistake_elsewhere_is_no_hindrance_but_is_said(here: Path) -> None:
    path = here / "two.plastron"
    path.write_text(f"nothing\n{TWO_NODES}")
    async with wizard(path) as it:
        await it.pick("make a message")
        await it.press("enter", "enter")
        closed = {item.title: item.closed for item in it.screen._items}
        assert closed["write the files"] == "a mistake in the program has to be mended first"


async def test_another_size_keeps_what_was_entered(here: Path) -> None:
    async with wizard() as it:
        await to_message(it)
        await it.write("data", "hi")
        for size in [*SIZES, (40, 12), (80, 24)]:
            await it.pilot.resize_terminal(*size)
            await it.settle()
            assert it.rows["data"] == "hi"
        await it.press("enter")
        assert it.kind is PageKind.REVIEW
        assert '"hi"' in it.statements[1]


@pytest.mark.parametrize("way", ["key", "palette", "welcome"])
async def test_it_is_opened_from(here: Path, way: str) -> None:
    async with studio(None, (80, 24), welcome=True) as driver:
        it = WizardDriver(driver)
        await driver.dialog("Welcome")
        if way == "welcome":
            await driver.pilot.click("#welcome-list", offset=(3, 0))
        else:
            await driver.pilot.press("escape")
            await driver.back()
            if way == "key":
                await driver.pilot.press("alt+w")
            else:
                await driver.pilot.press("f10")
                await driver.dialog("CommandPalette")
                for key in "wizard":
                    await driver.pilot.press(key)
                await driver.pilot.pause(0.5)
                await driver.pilot.press("enter")
                if not it.is_open:
                    await driver.pilot.pause(0.2)
                    await driver.pilot.press("enter")
        await driver.until(lambda: it.is_open)


def test_nothing_of_it_is_loaded_before_it_is_opened() -> None:
    import subprocess
    import sys

    code = (
        "import sys, plastron_tui.studio.app; "
        "print([name for name in sys.modules if 'studio.wizard' in name])"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"


@pytest.mark.parametrize("theme", ["ansi-dark", "ansi-light", "textual-light", "nord"])
async def test_it_works_in_other_colours(here: Path, theme: str) -> None:
    async with studio(None) as driver:
        driver.app.theme = theme
        it = WizardDriver(driver)
        await driver.pilot.press("ctrl+u")
        await driver.until(lambda: it.is_open)
        await it.settle()
        await to_message(it)
        focused = it.screen.focused
        other = it.row("data").box
        assert focused is not None and focused is not other
        assert focused.rich_style != other.rich_style
        await it.press("enter")
        assert it.kind is PageKind.REVIEW


async def test_what_was_searched_for_stays_when_the_rows_change(here: Path) -> None:
    """A name that is a type by itself brings its fields; the rest of the name goes on after it."""
    async with wizard() as it:
        await it.pick("make a message")
        await it.go_to("type")
        for character in "Pose":
            await it.type(character)
        assert "w" in it.rows and it.form.row_here is it.row("type")
        assert it.choices[0] == "Pose" and "Bool" not in it.choices
        for character in "Stamped":
            await it.type(character)
        assert it.rows["type"] == "PoseStamped" and "frame_id" in it.rows
        assert "PoseStamped" in it.choices and "Bool" not in it.choices


async def test_the_node_is_named_though_something_else_is_wrong(here: Path) -> None:
    async with wizard() as it:
        await it.pick(MAKE)
        await it.press("enter")
        await it.pick(SEND)
        await it.write("rate", "often")
        await it.press("f2")
        about = it.screen.query_one("#wizard-about")
        assert str(about.content) == "Choose what `talker` shall do."  # type: ignore[attr-defined]


async def test_a_recipe_starts_from_the_first_menu(here: Path) -> None:
    from plastron_tui.studio.recipes import recipes

    recipe = recipes()[1]
    assert not recipe.files
    async with wizard() as it:
        await it.pick("start from a program that works")
        assert it.menu == [each.title for each in recipes()]
        await it.press("f2")
        assert it.kind is PageKind.START and it.here == "start from a program that works"
        await it.press("enter")
        await it.click_item(recipe.title)
        await it.driver.until(lambda: it.driver.text == recipe.text.decode())
        assert not it.is_open


async def test_tab_leads_from_the_last_field_on(here: Path) -> None:
    async with wizard() as it:
        await it.pick(MAKE)
        await it.go_to("library")
        await it.press("tab", "enter")
        assert it.kind is PageKind.PURPOSE


async def test_a_service_that_nobody_answers_is_told(here: Path) -> None:
    async with wizard() as it:
        await it.pick(MAKE)
        await it.press("enter")
        await it.pick("ask a question and wait for the answer")
        await it.go_to("service")
        assert "no node of the program answers it yet" in it.help
        path = here / "two.plastron"
        path.write_text(TWO_NODES)
    async with wizard(path) as it:
        await it.pick(MORE)
        await it.pick("ask a question and wait for the answer")
        await it.write("service", "switch")
        assert "answers it yet" not in it.help
