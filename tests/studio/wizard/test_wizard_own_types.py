"""From an empty folder to two nodes that exchange a type of one's own, by the wizard."""

from __future__ import annotations

from pathlib import Path

import pytest
from machine import mostly_long
from wizard_courses import ANSWER, MAKE, OWN, PACKAGE, REACT, SEND, TOGETHER
from wizard_driver import WizardDriver, wizard, wizard_from_welcome

from plastron_tui.session import Options, Session
from plastron_tui.studio.wizard.pages import PageKind

MOST_KEYS = 40
"""The most keys of the whole way; letters of names are not counted."""

NODES = """\
create_message_type WheelSpeed with float64 left, float64 right

create_node 'talker' as talker
create_message wheel_speed_message of message_type WheelSpeed and input none
talker publish wheel_speed_message to 'wheel_speed' of message_type WheelSpeed at 10 hz
generate_node talker

create_node 'listener' as listener
subscribe listener to 'wheel_speed' of message_type WheelSpeed
generate_node listener
"""
PACKAGED = """
create_package 'my_robot' as my_robot
my_robot contains talker
my_robot contains listener
create_launch 'bringup' as bringup
bringup starts talker
bringup starts listener
my_robot contains bringup
generate_package my_robot
"""


async def make_type(it: WizardDriver) -> None:
    """Make a message with two fields: names are written, all else is chosen."""
    await it.pick(OWN)
    await it.pick("make a type of message")
    await it.type("WheelSpeed")
    await it.press("tab", "down")
    assert it.row("field 1").text == "float64 "
    assert "needs a name" in it.help
    await it.type("left")
    await it.press("tab", "down")
    await it.type("right")
    await it.finish()


async def make_node(it: WizardDriver, purpose: str) -> None:
    await it.pick("something more")
    await it.pick(MAKE)
    await it.press("enter")
    await it.pick(purpose)
    assert (it.rows["topic"], it.rows["type"]) == ("wheel_speed", "WheelSpeed")
    await it.finish()


@pytest.mark.long
async def test_two_nodes_exchange_a_type_of_ones_own_in_few_keys() -> None:
    async with wizard_from_welcome() as it:
        await make_type(it)
        await make_node(it, SEND)
        await make_node(it, REACT)
        assert it.driver.text == NODES
        await it.pick("something more")
        await it.pick(PACKAGE)
        await it.pick("make a package")
        await it.finish()
        assert it.driver.text == NODES + PACKAGED
        # One more of them runs the nodes.
        assert it.here == "something more" or "run" in it.here or "write" in it.here
        assert it.keys < MOST_KEYS
        text = it.driver.text
    session = Session(text.encode(), options=Options(target="rclpy"), environ={})
    assert session.diagnostics == ()
    plan, _ = session.plan()
    names = {file.name for file in plan.files}
    assert {
        "my_robot/package.xml",
        "my_robot/my_robot/talker.py",
        "my_robot/launch/bringup.launch.xml",
        "my_robot_interfaces/msg/WheelSpeed.msg",
    } <= names


@pytest.mark.long
async def test_rows_grow_with_the_fields_and_wrong_ones_are_said(two: Path) -> None:
    async with wizard(two) as it:
        await it.go(OWN, "make a type of message")
        assert list(it.rows) == ["type", "field 1", "field 2"]
        await it.write("field 2", "string[] names")
        assert list(it.rows) == ["type", "field 1", "field 2", "field 3"]
        await it.write("field 3", "float64 value")
        await it.press("enter")
        assert it.form.row_here is it.row("field 3")
        assert "value" in it.help
        await it.write("field 3", "uint8 OK = 1")
        await it.write("field 1", "")
        assert it.statements == ("create_message_type MyMessage with string[] names, uint8 OK = 1",)
        await it.write("field 2", "")
        await it.write("field 3", "")
        assert it.statements == ("create_message_type MyMessage with none",)


async def test_the_name_of_a_type_leads_to_its_fields(two: Path) -> None:
    async with wizard(two) as it:
        await it.go(OWN, "make a type of message")
        await it.type("WheelSpeed")
        await it.press("enter")
        assert it.kind is PageKind.FORM and it.form.row_here is it.row("field 1")
        await it.type("float64 left")
        await it.press("enter")
        assert it.kind is PageKind.REVIEW
        assert it.statements == ("create_message_type WheelSpeed with float64 left",)


async def test_who_is_in_a_row_that_goes_stays_among_the_fields(two: Path) -> None:
    async with wizard(two) as it:
        await it.go(OWN, "make a type of message")
        await it.type("WheelSpeed")
        await it.write("field 1", "left")
        assert "a type before its name: `float64 left`" in it.help
        it.row("field 1").take("")
        it.row("field 2").box.focus()
        await it.settle()
        assert list(it.rows) == ["type", "field 1"]
        assert it.form.row_here is it.row("field 1")


async def test_what_can_be_had_comes_first(two: Path) -> None:
    async with wizard(two) as it:
        await it.go(OWN)
        closed = [bool(each.closed) for each in it.screen._items]
        assert it.menu[:3] == [
            f"make a type of {each}" for each in ("message", "service", "action")
        ]
        assert any(closed) and closed == sorted(closed)


@pytest.mark.long
async def test_a_service_of_ones_own_is_what_is_answered_next(two: Path) -> None:
    async with wizard(two) as it:
        await it.go(OWN, "make a type of service")
        await it.finish()
        await it.pick("something more")
        await it.pick(MAKE)
        await it.press("enter")
        await it.pick(ANSWER)
        await it.go_to("service")
        await it.write("service", "mine")
        assert it.rows["type"] == "MyService"


@pytest.mark.parametrize("off", mostly_long(["contents", "launch", "write"], ["contents"]))
async def test_what_follows_a_package_can_be_left_out(off: str, two: Path) -> None:
    async with wizard(two) as it:
        await it.go(PACKAGE, "make a package")
        await it.press("enter")
        assert len(it.statements) == 8
        await it.click(f"#wizard-{off}")
        lines = {"contents": "two contains talker", "launch": "bringup starts talker",
                 "write": "generate_package two"}  # fmt: skip
        # What starts nodes that are in no package cannot be written.
        left_out = {off, *(["write"] if off == "contents" else [])}
        assert {key for key, line in lines.items() if line not in it.statements} == left_out
        await it.finish()
        assert Session(it.driver.text.encode(), environ={}).diagnostics == ()


async def test_a_launch_file_starts_what_there_is(two: Path) -> None:
    async with wizard(two) as it:
        await it.go(TOGETHER)
        await it.pick("start several nodes together")
        await it.finish()
        assert it.driver.text.endswith(
            "\ncreate_launch 'bringup' as bringup\nbringup starts talker\nbringup starts listener\n"
        )
        assert Session(it.driver.text.encode(), environ={}).diagnostics == ()
