"""What was not saved is offered with its folder, and never in the place of what was asked for."""

from __future__ import annotations

import json
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path

import pytest
from studio_driver import PROGRAM, Driver, leave_behind, studio
from textual.widgets import Label, OptionList

from plastron_tui.studio.app import StudioApp
from plastron_tui.studio.folder_labels import shown_folder
from plastron_tui.studio.journal import kept_texts
from plastron_tui.user_folders import state_folder

JOURNALS = 4


@pytest.fixture
def elsewhere(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Leave programs of other folders behind; the working folder is an empty one."""
    folder = tmp_path / "else\x1bwhere"
    folder.mkdir()
    old = leave_behind(None, "// of an earlier version, which did not keep the folder\n", folder)
    head, _, text = old.read_bytes().partition(b"\n")
    data = json.loads(head)
    del data["folder"]
    old.write_bytes(json.dumps(data).encode() + b"\n" + text)
    leave_behind(None, "// a new program of another folder\n", folder)
    leave_behind(None, "// the folder is gone\n", tmp_path / "gone")
    leave_behind(folder / "talk.plastron", "// a file of another folder\n")
    here = tmp_path / "here"
    here.mkdir()
    monkeypatch.chdir(here)
    return folder


@asynccontextmanager
async def wizard(path: Path | None) -> AsyncIterator[Driver]:
    app = StudioApp(path, first="wizard")
    async with app.run_test(size=(120, 40)) as pilot:
        yield Driver(app, pilot)


def label(driver: Driver, name: str) -> str:
    return str(driver.app.screen.query_one(f"#dialog-{name}", Label).content)


async def welcome_entry(driver: Driver, words: str) -> None:
    """Choose the line of the welcome that has some words."""
    listed = (await driver.dialog("Welcome")).query_one(OptionList)
    at = next(number for number in range(listed.option_count)
              if words in str(listed.get_option_at_index(number).prompt))  # fmt: skip
    listed.highlighted = at
    await driver.pilot.press("enter")


@pytest.mark.parametrize("name", [None, "mine.plastron"])
async def test_the_wizard_begins_what_was_asked_for(name: str | None, elsewhere: Path) -> None:
    async with wizard(None if name is None else Path(name)) as driver:
        await driver.dialog("Wizard")
        assert driver.main.open.name == (name or "new program")
        assert driver.main.open.text == b""
        # What is to be learned there by watching has no note over it.
        assert "not saved" not in driver.notes()


async def test_what_was_not_saved_elsewhere_is_said_once(elsewhere: Path, tmp_path: Path) -> None:
    mine = tmp_path / "mine.plastron"
    mine.write_text(PROGRAM)
    async with studio(mine) as driver:
        said = driver.notes()
        assert f"talk.plastron in {shown_folder(elsewhere)}" in said
        assert f"a new program begun in {shown_folder(elsewhere)}" in said
        assert f"… and {JOURNALS - 3} more\nthe welcome page (Alt-0) has what was typed" in said
        assert "\x1b" not in said
        assert len(kept_texts(state_folder() / "journal")) == JOURNALS
        # The wizard takes it away.
        await driver.pilot.press("ctrl+u")
        await driver.dialog("Wizard")
        assert not driver.app._notifications
    leave_behind(None, "// new\n", tmp_path / "another")
    async with studio(mine) as driver:
        said = driver.notes()
        assert f"a new program begun in {shown_folder(tmp_path / 'another')}" in said
        assert "talk.plastron" not in said
    async with studio(mine) as driver:
        assert "not saved" not in driver.notes()


async def test_a_new_program_of_the_same_folder_is_offered_with_its_folder(elsewhere: Path) -> None:
    leave_behind(None, PROGRAM, Path.cwd())
    async with wizard(None) as driver:
        await driver.dialog("Question")
        assert label(driver, "title") == "A new program was not saved"
        assert label(driver, "text").startswith(f"Begun in {shown_folder(Path.cwd())}: the studio")
        await driver.pilot.press("r")
        await driver.dialog("Wizard")
        assert driver.main.open.text == PROGRAM.encode()


async def test_the_welcome_opens_a_program_in_the_folder_where_it_was_begun(
    elsewhere: Path,
) -> None:
    async with studio(None, welcome=True) as driver:
        await welcome_entry(driver, f"not saved, begun in {shown_folder(elsewhere)}")
        await driver.dialog("Question")
        await driver.pilot.press("r")
        await driver.back()
        assert driver.text == "// a new program of another folder\n"
        assert driver.main.open.session.folder == elsewhere
        await driver.until(lambda: driver.main.open.journal.file.exists())
        kept = kept_texts(state_folder() / "journal")
        # It is kept again, by this process now, and still knows its folder.
        assert len(kept) == JOURNALS
        assert [each.folder for each in kept if each.file == driver.main.open.journal.file] == [
            elsewhere
        ]


async def test_what_is_not_saved_is_not_replaced_unasked(elsewhere: Path) -> None:
    async with studio(None) as driver:
        await driver.type("// mine")
        driver.main.action_welcome()
        await welcome_entry(driver, "talk.plastron")
        await driver.dialog("Question")
        assert label(driver, "title") == "talk.plastron was not saved"
        assert label(driver, "text").startswith(f"In {shown_folder(elsewhere)}: the studio ended")
        await driver.pilot.press("r")
        await driver.back()
        assert driver.main.open.name == "talk.plastron"
        await driver.press("ctrl+pageup")
        assert driver.text == "// mine"


async def test_a_program_of_a_folder_that_is_gone_is_opened_here(elsewhere: Path) -> None:
    async with studio(None, welcome=True) as driver:
        await welcome_entry(driver, "gone")
        await driver.dialog("Question")
        await driver.pilot.press("r")
        await driver.back()
        assert driver.main.open.session.folder == Path.cwd()
        assert "the folder in which it was begun is gone" in driver.notes()


@pytest.mark.parametrize(
    ("folder", "shown"),
    [
        (Path.home(), "~"),
        (Path.home() / "a", "~/a"),
        (Path("/a\nb\x1b[2J"), r"/a\nb\x1b[2J"),
        (Path("/" + "long/" * 30 + "end"), "…" + ("long/" * 30 + "end")[-59:]),
    ],
)
def test_a_folder_is_shown_shortened_and_escaped(folder: Path, shown: str) -> None:
    assert shown_folder(folder) == shown
