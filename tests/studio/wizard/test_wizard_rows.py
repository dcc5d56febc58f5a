"""The rows of the wizard's forms, and what can be chosen in them."""

from __future__ import annotations

from pathlib import Path

import pytest
from textual.widgets import Checkbox
from wizard_courses import ASK, MAKE, MESSAGE, MORE, REACT, SEND, TWO_NODES
from wizard_driver import wizard

from plastron_tui.ros import installations
from plastron_tui.ros.installations import Installation, Origin
from plastron_tui.studio.wizard import libraries
from plastron_tui.studio.wizard.pages import PageKind
from plastron_tui.studio.wizard.rows import Row


@pytest.mark.long
async def test_a_type_is_found_by_what_it_is_for(here: Path) -> None:
    async with wizard() as it:
        await it.go(MAKE, SEND)
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


@pytest.mark.long
async def test_a_type_is_taken_by_mouse(here: Path) -> None:
    async with wizard() as it:
        await it.go(MAKE, SEND)
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
        # What is typed after a choice takes its place, as in a field that Tab has led to.
        await it.press("down", "x")
        assert it.rows["topic"] == "x"
        assert it.form.choices[0].about == "from eye"


@pytest.mark.long
async def test_a_node_that_is_not_there_yet_has_a_page_of_its_own(two: Path) -> None:
    async with wizard(two) as it:
        await it.go(MORE, REACT)
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


@pytest.mark.long
async def test_a_message_that_is_there_needs_no_page(two: Path) -> None:
    async with wizard(two) as it:
        await it.go(MORE, SEND)
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


async def test_a_part_of_a_name_narrows_the_choices_down(two: Path) -> None:
    async with wizard(two) as it:
        await it.go(MORE, REACT)
        await it.write("node", "tal")
        assert it.choices == ["talker"]
        await it.press("down")
        assert it.rows["node"] == "talker"


def shown(row: Row) -> str:
    return str(row.query_one(Checkbox).render()).strip()


@pytest.mark.long
async def test_the_values_are_a_form_with_a_row_a_field(here: Path) -> None:
    async with wizard() as it:
        await it.pick(MESSAGE)
        await it.write("type", "Twist")
        assert list(it.rows) == ["variable", "type", "x", "y", "z"]
        assert it.statements == (
            "create_message message of message_type Twist and input linear.x=0.2, angular.z=0.0",
        )
        await it.write("x", "0.5")
        assert it.statements[0].endswith("and input linear.x=0.5, angular.z=0.0")
        assert it.help == "linear.x (float64): m/s, forward, below 0 backward"
        await it.write("type", "Bool")
        assert it.row("data").is_switch and it.rows["data"] == "True"
        await it.go_to("data")
        await it.press("space")
        assert it.statements[0].endswith("and input False")
        await it.click("Turn")
        assert it.statements[0].endswith("and input none")
        assert shown(it.row("data")) == "[ ] False (default)"
        await it.click("Turn")
        assert it.statements[0].endswith("and input True")
        assert shown(it.row("data")) == "[X] True"
        # What was entered for the other type is not forgotten.
        await it.write("type", "Twist")
        assert it.statements[0].endswith("and input linear.x=0.5, angular.z=0.0")


@pytest.mark.long
async def test_constants_are_offered(here: Path) -> None:
    async with wizard() as it:
        await it.pick(MESSAGE)
        await it.write("type", "BatteryState")
        await it.go_to("power_supply_health")
        assert "1" in it.choices
        assert "POWER_SUPPLY_HEALTH_GOOD" in [choice.note for choice in it.form.choices]
        await it.press("down", "down")
        assert it.statements[0].endswith("power_supply_health=1, present=True")


MISSING = {"rclcpp": ("rclcpp",)}


async def test_the_library_is_what_is_installed_and_explained(
    here: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    there = Installation(Origin.EXTRA, 2, "kilted")
    monkeypatch.setattr(installations, "installed", lambda: (there,))
    monkeypatch.setattr(libraries, "_missing", lambda library, _: MISSING.get(library, ()))
    async with wizard() as it:
        await it.pick(MAKE)
        # The shell takes the same one: it need not be written.
        assert it.statements == ("create_node 'talker' as talker",)
        await it.go_to("library")
        assert it.help == "rclpy (ROS 2 kilted): it is installed"
        about = {choice.text: choice.closed or choice.about for choice in it.form.choices}
        standing = {name: each.rpartition("; ")[2] for name, each in about.items()}
        assert standing["rclpy"] == "ROS 2 kilted (from the Python packages)"
        assert "has no `rclcpp`" in standing["rclcpp"]
        assert "not installed here" in standing["rospy"]
        assert "not installed here" in standing["roscpp"]
        # Each says what it is for, and which of two to take.
        assert "a script" in about["rclpy"]
        assert "a manager loads" in about["nodelet"]
        assert "a container loads" in about["component"]


async def test_a_library_of_which_nothing_is_installed_is_explained(
    here: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(installations, "installed", lambda: ())
    async with wizard() as it:
        await it.pick(MAKE)
        await it.go_to("library")
        assert it.help.startswith("rclpy (ROS 2 kilted): no ROS is found here; it can be written")


@pytest.mark.long
async def test_what_was_searched_for_stays_when_the_rows_change(here: Path) -> None:
    """A name that is a type by itself brings its fields; the rest of the name goes on after it."""
    async with wizard() as it:
        await it.pick(MESSAGE)
        await it.go_to("type")
        for character in "Pose":
            await it.type(character)
        assert "w" in it.rows and it.form.row_here is it.row("type")
        assert it.choices[0] == "Pose" and "Bool" not in it.choices
        for character in "Stamped":
            await it.type(character)
        assert it.rows["type"] == "PoseStamped" and "frame_id" in it.rows
        assert "PoseStamped" in it.choices and "Bool" not in it.choices


async def test_tab_leads_from_the_last_field_on(here: Path) -> None:
    async with wizard() as it:
        await it.pick(MAKE)
        await it.go_to("library")
        await it.press("tab", "enter")
        assert it.kind is PageKind.PURPOSE


@pytest.mark.long
async def test_a_service_that_nobody_answers_is_told(here: Path) -> None:
    async with wizard() as it:
        await it.go(MAKE, ASK)
        await it.go_to("service")
        assert "no node of the program answers it yet" in it.help
        path = here / "two.plastron"
        path.write_text(TWO_NODES)
    async with wizard(path) as it:
        await it.go(MORE, ASK)
        await it.write("service", "switch")
        assert "answers it yet" not in it.help
