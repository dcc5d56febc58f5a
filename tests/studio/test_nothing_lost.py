"""What goes wrong around the studio, and in it: the text is still there."""

from __future__ import annotations

import json
import os
import random
import subprocess
import sys
import time
from pathlib import Path

import pytest
from studio_driver import PROGRAM, SIZES, fail, leave_behind, studio

from plastron_tui.studio.config import load_remembered
from plastron_tui.studio.journal import Journal, kept_texts
from plastron_tui.studio.main.screen import MainScreen
from plastron_tui.user_folders import state_folder


@pytest.mark.parametrize("size", SIZES)
async def test_a_read_only_file_is_not_written_over(program: Path, size: tuple[int, int]) -> None:
    program.chmod(0o444)
    async with studio(program, size) as driver:
        await driver.type("// hi")
        await driver.press("ctrl+s")
        await driver.until(lambda: "it is read-only" in driver.notes())
        assert program.read_text() == PROGRAM
        assert driver.text.startswith("// hi")
        assert driver.main.open.is_changed
        program.chmod(0o644)
        await driver.press("ctrl+s")
        await driver.until(lambda: not driver.main.open.is_changed)
    assert program.read_text() == "// hi" + PROGRAM


async def test_a_file_that_goes_away_is_said_once_and_saved_anew(program: Path) -> None:
    async with studio(program) as driver:
        program.unlink()
        driver.main.look_at_disk()
        driver.main.look_at_disk()
        await driver.settle()
        assert driver.notes().count("no longer on the disk") == 1
        assert driver.text == PROGRAM
        await driver.press("ctrl+s")
        await driver.until(program.exists)
    assert program.read_text() == PROGRAM


async def test_a_journal_that_cannot_be_written_is_said_once(program: Path) -> None:
    state_folder().mkdir(parents=True)
    (state_folder() / "journal").write_text("no folder")
    async with studio(program) as driver:
        for _ in range(2):
            await driver.type("// hi")
            await driver.pilot.pause(0.7)
        await driver.until(lambda: "what you type is not kept" in driver.notes())
        assert driver.notes().count("what you type is not kept") == 1


async def test_opening_another_file_offers_what_was_typed_in_it(
    program: Path,
) -> None:
    other = program.with_name("other.plastron")
    other.write_text("// other\n")
    leave_behind(other, "// other\n// typed\n")
    async with studio(program) as driver:
        assert "other.plastron" in driver.notes()
        driver.main.files.open_file(other)
        dialog = await driver.dialog("Question")
        assert "+// typed" in dialog.query_one("TextView").text
        await driver.pilot.press("r")
        await driver.back()
        assert driver.text == "// other\n// typed\n"
        assert driver.main.open.path == other


async def test_what_is_put_off_is_offered_again_whatever_is_typed_meanwhile(
    program: Path,
) -> None:
    kept = leave_behind(program, "// typed\n" + PROGRAM)
    async with studio(program, welcome=True) as driver:
        await driver.dialog("Question")
        await driver.pilot.press("l")
        await driver.back()
        await driver.type("// more")
        await driver.pilot.pause(0.7)
        await driver.press("ctrl+s")
        await driver.until(lambda: not driver.main.open.is_changed)
    [found] = kept_texts(state_folder() / "journal")
    assert found.file == kept
    assert found.text.startswith(b"// typed")


async def test_what_is_saved_already_is_not_offered(
    program: Path,
) -> None:
    kept = leave_behind(program, PROGRAM)
    async with studio(program) as driver:
        await driver.until(lambda: not kept.exists())
        assert driver.text == PROGRAM


def test_two_studios_keep_the_same_file_apart(
    program: Path,
) -> None:
    first = leave_behind(program, "one")
    assert Journal(state_folder() / "journal", program).file != first


@pytest.mark.parametrize("text", ["", "[]", "3", "null", "\0", "{"])
def test_a_memory_that_is_none_is_as_if_there_were_none(tmp_path: Path, text: str) -> None:
    (tmp_path / "studio.json").write_text(text)
    assert load_remembered(tmp_path) == load_remembered(tmp_path / "nowhere")


@pytest.mark.parametrize(
    "text",
    [
        "{", '{"theme": {}, "tabs": {"outline": []}}',
        '{"recent": [1, {}], "sizes": {"outline": "x", "result": -5}, "hidden": {}}',
        '{"sizes": {"outline": 100000, "bottom": 100000}, "tabs": {"front": "nothing"}}',
    ],
)  # fmt: skip
async def test_a_broken_memory_is_forgotten(program: Path, text: str) -> None:
    state_folder().mkdir(parents=True)
    (state_folder() / "studio.json").write_text(text)
    async with studio(program, (80, 24)) as driver:
        assert driver.text == PROGRAM
        assert driver.main.editor.view.size.height >= 1
        await driver.pilot.press("ctrl+q")
        await driver.until(lambda: driver.app._exit)
    assert load_remembered(state_folder()).recent == [str(program)]


@pytest.mark.parametrize("when", ["Infinity", "-1e300", "1e18"])
def test_a_journal_of_an_impossible_time_is_read(tmp_path: Path, when: str) -> None:
    head = '{"plastron-journal": 1, "path": null, "cursor": 0, "pid": 4194311, "when": %s}'
    (tmp_path / "a.journal").write_text(head % when + "\ntext")
    assert [kept.text for kept in kept_texts(tmp_path)] == [b"text"]


@pytest.mark.long
@pytest.mark.parametrize("seed", range(2))
async def test_the_window_changes_its_size_at_any_moment(program: Path, seed: int) -> None:
    chance = random.Random(seed)
    keys = ["f1", "f6", "f7", "f10", "ctrl+f", "ctrl+t", "escape", "escape", "alt+6", "alt+5",
            "a", "enter", "down", "f9", "ctrl+z", "ctrl+space"]  # fmt: skip
    async with studio(program) as driver:
        for _ in range(25):
            size = (chance.randint(1, 220), chance.randint(1, 70))
            await driver.pilot.resize_terminal(*size)
            await driver.pilot.press(chance.choice(keys))
        await driver.pilot.resize_terminal(80, 24)
        for _ in range(4):
            await driver.pilot.press("escape")
        await driver.until(lambda: driver.app.screen is driver.main)
        # The palette may have closed it, or brought another one in front.
        driver.main.files.open_file(program)
        await driver.settle()
        for _ in range(60):
            driver.main.editor.undo()
        assert driver.text == PROGRAM


async def test_an_error_in_a_worker_is_shown_and_the_studio_goes_on(
    program: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    async with studio(program) as driver:
        await driver.type("// hi\n")
        with monkeypatch.context() as patch:
            patch.setattr("plastron_tui.session.Session.generated", fail)
            await driver.pilot.press("f6")
            await driver.failure(PROGRAM.encode())
        await driver.pilot.press("escape")
        await driver.back()
        await driver.type("!")
        assert driver.text.startswith("// hi\n!")


async def test_an_error_that_ends_the_studio_says_where_the_text_is(
    program: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(MainScreen, "action_panels", fail)
    with pytest.raises(RuntimeError, match="a deliberate error"):
        async with studio(program) as driver:
            await driver.type("// hi")
            app, journal = driver.app, driver.main.open.journal.file
            await driver.pilot.press("f9")
            await driver.until(lambda: bool(app.last_words))
    shown = app.last_words
    assert str(journal) in shown
    assert "a deliberate error" in shown
    assert "a deliberate error" in (state_folder() / "report.txt").read_text()
    assert json.loads(journal.read_bytes().partition(b"\n")[0])["path"] == str(program)
    assert journal.read_bytes().endswith(b"// hi" + PROGRAM.encode())


def test_what_is_dropped_while_it_is_written_stays_dropped(
    program: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    journal = Journal(state_folder() / "journal", program)
    replace = os.replace

    def replace_late(*arguments: str, **options: int) -> None:
        journal.drop()
        replace(*arguments, **options)

    monkeypatch.setattr(os, "replace", replace_late)
    assert journal.write(b"old", 0) is None
    assert not journal.file.exists()


def test_of_texts_that_are_written_in_any_order_the_last_is_kept(program: Path) -> None:
    journal = Journal(state_folder() / "journal", program)
    first, second = journal.turn(), journal.turn()
    assert journal.write(b"new", 0, second) is None
    assert journal.write(b"old", 0, first) is None
    assert journal.file.read_bytes().endswith(b"\nnew")
    third = journal.turn()
    journal.drop()
    assert journal.write(b"dropped", 0, third) is None
    assert not journal.file.exists()


@pytest.mark.skipif(not Path("/proc/self/cmdline").exists(), reason="needs /proc")
@pytest.mark.parametrize(("word", "is_offered"), [("something", True), ("plastron", False)])
def test_another_program_with_the_number_of_a_studio_hides_nothing(
    tmp_path: Path, word: str, is_offered: bool
) -> None:
    command = [sys.executable, "-c", "input()", word]
    with subprocess.Popen(command, stdin=subprocess.PIPE) as process:
        head = {"plastron-journal": 1, "path": None, "cursor": 0, "pid": process.pid, "when": 1}
        (tmp_path / "a.journal").write_text(json.dumps(head) + "\ntext")
        # Until the program is another one the process is a copy of this.
        command_line = Path(f"/proc/{process.pid}/cmdline")
        while word.encode() not in command_line.read_bytes():
            time.sleep(0.01)
        found = kept_texts(tmp_path)
        assert process.stdin is not None
        process.stdin.close()
    assert bool(found) is is_offered
