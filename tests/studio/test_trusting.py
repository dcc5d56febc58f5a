"""A folder that somebody else made, in the studio."""

from __future__ import annotations

from pathlib import Path

import pytest
from studio_driver import PROGRAM, studio
from textual.widgets import Button
from textual.widgets._toast import Toast, ToastRack

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
        assert "If you trust it: Alt-U" in driver.notes()
        assert "rospy.init_node" in driver.main.panels["preview"].text
        await driver.pilot.press("alt+u")
        dialog = await driver.dialog("Question")
        assert str(foreign.parent) in str(dialog.query_one("#dialog-text").render())
        await driver.pilot.press("t")
        await driver.back()
        await driver.until(lambda: "# foreign" in driver.main.panels["preview"].text)
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


@pytest.mark.parametrize("key", ["f5", "f6"])
async def test_what_only_waits_for_trust_is_no_mistake_of_the_program(
    program: Path, key: str
) -> None:
    (program.parent / "plastron.yaml").write_text("output: ../elsewhere\n")
    async with studio(program) as driver:
        await driver.settle()
        await driver.press(key)
        await driver.until(lambda: driver.main.panels["problems"].has_focus)
        assert "only once you trust this project: Alt-U" in driver.notes()
        assert "mended" not in driver.notes()
        await driver.press("enter")
        assert "this is about plastron.yaml:1, not about a statement" in driver.notes()


async def test_messages_leave_the_answers_in_sight(foreign: Path) -> None:
    (foreign.parent / "plastron.yaml").write_text("output: ../elsewhere\n")
    async with studio(foreign, (80, 24)) as driver:
        # In a test Textual shows no messages, unless they are asked for.
        driver.app._disable_notifications = False
        await driver.until(lambda: "is outside of the project" in driver.notes())
        await driver.press("f5", "f6")
        await driver.until(lambda: driver.notes().count("only once you trust") == 2)
        await driver.press("escape")
        await driver.type("// mine")
        await driver.pilot.press("ctrl+q")
        dialog = await driver.dialog("Question")
        rack = dialog.get_child_by_type(ToastRack)
        await driver.until(lambda: any(toast.region.area for toast in rack.query(Toast)))
        for button in dialog.query(Button):
            assert dialog.get_widget_at(*button.region.offset)[0] is button
        await driver.pilot.press("escape")
        await driver.back()
        await driver.pilot.press("alt+u")
        dialog = await driver.dialog("Question")
        assert not driver.app._notifications
        await driver.pilot.press("t")
        await driver.back()
        await driver.pilot.press("alt+u")
        assert "you trust this project already" in driver.notes()
