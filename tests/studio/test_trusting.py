"""A folder that somebody else made, in the studio."""

from __future__ import annotations

from pathlib import Path

import pytest
from studio_driver import PROGRAM, studio

from plastron_tui.trust import TrustStore


@pytest.fixture
def foreign(program: Path) -> Path:
    """A program in a project with templates of its own."""
    folder = program.parent
    (folder / "plastron.yaml").write_text("templates: mine\n")
    (folder / "mine" / "rospy").mkdir(parents=True)
    (folder / "mine" / "rospy" / "node.py.j2").write_text("# foreign\n")
    return program


async def test_templates_are_used_after_the_user_trusts_them(foreign: Path) -> None:
    async with studio(foreign) as driver:
        driver.main.action_show("preview")
        await driver.settle()
        await driver.until(lambda: "not used until you trust it" in driver.notes())
        assert "If you trust it: alt+u" in driver.notes()
        assert "rospy.init_node" in driver.main.preview.text
        await driver.pilot.press("alt+u")
        dialog = await driver.dialog("Question")
        assert str(foreign.parent) in str(dialog.query_one("#dialog-text").render())
        await driver.pilot.press("t")
        await driver.back()
        await driver.until(lambda: "# foreign" in driver.main.preview.text)
        assert TrustStore().folders() == [foreign.parent]


async def test_nothing_is_trusted_by_the_first_answer(foreign: Path) -> None:
    async with studio(foreign) as driver:
        await driver.until(lambda: "not used until you trust it" in driver.notes())
        await driver.pilot.press("alt+u")
        await driver.dialog("Question")
        await driver.pilot.press("enter")
        await driver.back()
        assert TrustStore().folders() == []


async def test_nothing_is_written_before(foreign: Path) -> None:
    async with studio(foreign) as driver:
        await driver.settle()
        await driver.pilot.press("f6")
        dialog = await driver.dialog("GenerateDialog")
        assert not dialog.query_one("#write").display
        await driver.pilot.press("f6", "enter")
        assert not (foreign.parent / "output").exists()


async def test_a_project_of_ones_own_asks_nothing(program: Path) -> None:
    (program.parent / "plastron.yaml").write_text("output: nodes\n")
    async with studio(program) as driver:
        await driver.settle()
        assert "trust" not in driver.notes()
        assert driver.text == PROGRAM
