"""A type of one's own, by the wizard: from an empty folder to two nodes that exchange it."""

from __future__ import annotations

from pathlib import Path

import pytest
from wizard_courses import OWN
from wizard_driver import WizardDriver, wizard_from_welcome

from plastron_tui.model.kinds import Publisher, Subscription
from plastron_tui.session import Session

MOST_KEYS = 40


async def begin(it: WizardDriver) -> None:
    """Go from the welcome to the wizard."""
    while not it.is_open:
        name = type(it.driver.app.screen).__name__
        await it.press("enter")
        await it.driver.until(
            lambda: it.is_open or type(it.driver.app.screen).__name__ != name  # noqa: B023
        )


@pytest.mark.long
async def test_two_nodes_exchange_a_message_of_ones_own(here: Path) -> None:
    async with wizard_from_welcome() as it:
        await begin(it)
        await it.pick(OWN)
        await it.pick("make a type of message")
        await it.type("WheelSpeed")
        await it.finish()
        await it.go("something more", "make a node")
        await it.finish()
        await it.go("something more", "make a node")
        await it.press("enter")
        await it.pick("react to what others send")
        await it.finish()
        await it.pick("write the files")
        driver = it.driver
        await driver.until(lambda: type(driver.app.screen).__name__ == "ChooseFile")
        await it.type("two")
        await it.press("enter")
        await driver.until(lambda: type(driver.app.screen).__name__ == "GenerateDialog")
        await it.press("enter")
        await driver.until(lambda: getattr(driver.app.screen, "is_written", False))
        assert it.keys <= MOST_KEYS
    session = Session((here / "two.plastron").read_bytes(), here / "two.plastron", environ={})
    assert session.diagnostics == ()
    nodes = session.workspace.nodes.values()
    assert sum(len(node.of(Publisher)) for node in nodes) == 1
    assert sum(len(node.of(Subscription)) for node in nodes) == 1
    [type_] = {type_ for node in nodes for type_ in node.types}
    assert str(type_) == "two_interfaces/WheelSpeed"
    output = here / "output"
    assert (output / "two_interfaces" / "msg" / "WheelSpeed.msg").is_file()
    assert len(list(output.glob("*.py"))) == 2


@pytest.mark.long
async def test_nodes_become_a_package(here: Path) -> None:
    async with wizard_from_welcome() as it:
        await begin(it)
        await it.pick("make a node")
        await it.finish()
        await it.go("something more", "make it a package", "make a package")
        await it.type("my_robot")
        await it.finish()
        text = it.driver.text
        assert "create_package 'my_robot' as my_robot" in text
        assert "my_robot contains talker" in text
        assert "generate_package my_robot" in text
        assert it.keys <= MOST_KEYS
