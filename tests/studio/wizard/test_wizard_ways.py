"""How one comes to the wizard, how it explains itself, and where it leads."""

from __future__ import annotations

from pathlib import Path

import pytest
from machine import mostly_long
from studio_driver import studio
from textual.widgets import Button
from wizard_courses import CHANGE, MAKE, MESSAGE, REACT, SEND, TWO_NODES
from wizard_driver import WizardDriver, wizard

from plastron_tui.studio.main.screen import MainScreen
from plastron_tui.studio.wizard.pages import PageKind
from plastron_tui.studio.wizard.result_view import ResultView
from plastron_tui.studio.wizard.screen import Wizard
from plastron_tui.studio.wizard.statement_view import StatementView

EXAMPLES = Path(__file__).parents[3] / "examples"


async def test_it_is_opened_from_the_welcome_by_a_key_and_from_the_menu(here: Path) -> None:
    async with studio(None, (80, 24), welcome=True) as driver:
        it = WizardDriver(driver)
        await driver.dialog("Welcome")
        await driver.pilot.click("#welcome-list", offset=(3, 0))
        for way, leaves in (("alt+w", "escape"), ("f10", "ctrl+q")):
            await driver.until(lambda: it.is_open)
            await it.press(leaves)
            await driver.back()
            await driver.pilot.press(way)
            if way == "f10":
                await driver.dialog("ActionMenu")
                await driver.pilot.press(*"wizard", "enter")
        await driver.until(lambda: it.is_open)
        # What was filled in is asked about, as it is by Esc.
        await it.press("enter", *"horn")
        await driver.pilot.press("ctrl+q")
        question = await driver.dialog("Question")
        assert [str(button.label) for button in question.query(Button)] == ["Stay", "Leave"]
        await driver.pilot.press("l")
        await driver.back()
        assert driver.text == ""


async def test_nothing_is_offered_before_the_first_page_is_known(
    program: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(Wizard, "changed", lambda *_: None)
    async with studio(program, (120, 40)) as driver:
        await driver.pilot.press("alt+w")
        shown = await driver.dialog("Wizard")
        assert not any(button.display for button in shown.query(Button))
        assert not shown.query_one(ResultView).display
        assert not shown.query_one(StatementView).display
        await driver.pilot.press("escape")
        await driver.back()


def test_nothing_of_it_is_loaded_before_it_is_opened() -> None:
    import subprocess
    import sys

    code = (
        "import sys, plastron_tui.studio.app; "
        "print([name for name in sys.modules if 'studio.wizard' in name])"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"


@pytest.mark.parametrize("steps", mostly_long(range(6), [4]))
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
            assert "create_node 'NODE_NAME' as VARIABLE [managed] [using CLIENT_LIBRARY]" in text
        await it.pilot.press("enter")
        await it.settle()
        assert it.title == title


@pytest.mark.long
async def test_the_node_is_named_though_something_else_is_wrong(here: Path) -> None:
    async with wizard() as it:
        await it.go(MAKE, SEND)
        await it.write("rate", "often")
        await it.press("f2")
        about = it.screen.query_one("#wizard-about")
        assert str(about.content) == "Choose what `talker` shall do."  # type: ignore[attr-defined]
        # The focus is where it was.
        await it.press("enter")
        assert it.form.row_here is it.row("rate")


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


async def test_the_file_may_be_left_out(here: Path) -> None:
    async with wizard() as it:
        await it.go(MAKE, REACT)
        await it.press("enter")
        assert it.kind is PageKind.REVIEW
        assert it.statements[-1] == "generate_node listener"
        await it.click("#wizard-generates")
        assert it.statements[-1].startswith("subscribe")
        await it.press("enter")
        assert "generate_node" not in it.driver.text
        closed = {item.title: item.closed for item in it.screen._items}
        assert (
            closed["write the files"]
            == closed["run the nodes"]
            == ("the program writes nothing to a file yet")
        )


@pytest.mark.parametrize(
    "entry",
    mostly_long(["write the files", "run the nodes", "back to the text"], ["run the nodes"]),
)
async def test_what_comes_after(two: Path, entry: str, monkeypatch: pytest.MonkeyPatch) -> None:
    done: list[str] = []
    monkeypatch.setattr(MainScreen, "action_generate", lambda _: done.append("write the files"))
    monkeypatch.setattr(MainScreen, "action_run", lambda *_: done.append("run the nodes"))
    async with wizard(two) as it:
        await it.pick(MESSAGE)
        await it.press("enter", "enter")
        assert it.screen.is_done
        await it.click_item(entry)
        assert not it.is_open
        assert done == ([] if entry == "back to the text" else [entry])
        assert it.driver.main.editor.view.has_focus


async def test_write_the_files_writes_at_once_where_all_is_generated(two: Path) -> None:
    async with wizard(two) as it:
        await it.pick("write a node to its file")
        await it.driver.dialog("GenerateDialog")


async def test_a_mistake_elsewhere_is_no_hindrance_but_is_said(here: Path) -> None:
    path = here / "two.plastron"
    path.write_text(f"nothing\n{TWO_NODES}")
    async with wizard(path) as it:
        await it.pick(MESSAGE)
        await it.press("enter", "enter")
        closed = {item.title: item.closed for item in it.screen._items}
        assert closed["write the files"] == "a problem in the program has to be fixed first"


async def test_to_take_away_what_a_node_file_has_is_never_suggested(here: Path) -> None:
    """Not even where a topic that only one side uses would be gone by it."""
    (here / "lamp.py").write_text((EXAMPLES / "nodes" / "lamp.py").read_text())
    async with wizard() as it:
        await it.pick(CHANGE)
        await it.press("enter")
        assert it.kind is PageKind.PURPOSE
        assert it.here == SEND
