from __future__ import annotations

import json
import os
from pathlib import Path

import pytest
from machine import mostly_long
from studio_driver import PROGRAM, SIZES, leave_behind, studio
from textual.widgets import Label, OptionList

from plastron_tui.studio.files import lost
from plastron_tui.studio.journal import kept_texts
from plastron_tui.studio.main.screen import MainScreen
from plastron_tui.studio.screens.choose_file import recent_in
from plastron_tui.user_folders import state_folder


@pytest.mark.parametrize("size", SIZES)
async def test_a_program_is_saved_and_what_is_typed_is_marked(
    program: Path, size: tuple[int, int]
) -> None:
    program.chmod(0o640)
    async with studio(program, size) as driver:
        title = driver.main.query_one("#title")
        assert "●" not in title.text
        await driver.type("// hi\n")
        assert "●" in title.text
        await driver.press("ctrl+s")
        await driver.until(lambda: not driver.main.open.is_changed)
        assert "●" not in title.text
    assert program.read_text() == "// hi\n" + PROGRAM
    assert program.stat().st_mode & 0o777 == 0o640


async def test_line_endings_are_kept(program: Path) -> None:
    program.write_bytes(PROGRAM.replace("\n", "\r\n").encode())
    async with studio(program) as driver:
        await driver.type("// hi\n")
        await driver.press("ctrl+s")
        await driver.until(lambda: not driver.main.open.is_changed)
    assert program.read_bytes() == ("// hi\n" + PROGRAM).replace("\n", "\r\n").encode()


async def test_a_new_program_asks_where_to(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    async with studio(None) as driver:
        await driver.type("create_node 'arm' as arm\n")
        await driver.pilot.press("ctrl+s")
        dialog = await driver.dialog("ChooseFile")
        assert dialog.query_one("Input").value == "arm.plastron"
        dialog.query_one("Input").value = "mine"
        await driver.pilot.press("enter")
        await driver.back()
        assert driver.main.open.path == tmp_path / "mine.plastron"
        assert "create_node 'arm' as arm" in (tmp_path / "mine.plastron").read_text()
        assert not list(tmp_path.glob(".plastron*"))
        await driver.type("// more\n")
        await driver.press("ctrl+s")
        await driver.until(lambda: not driver.main.open.is_changed)


@pytest.mark.parametrize(
    ("key", "is_open", "is_saved"), [("c", True, False), ("d", False, False), ("s", False, True)]
)
async def test_leaving_asks_about_what_is_not_saved(
    program: Path, key: str, is_open: bool, is_saved: bool
) -> None:
    async with studio(program, (80, 24)) as driver:
        await driver.type("// hi")
        await driver.pilot.press("ctrl+q")
        await driver.dialog("Question")
        await driver.pilot.press(key)
        if is_open:
            await driver.back()
            assert driver.app._exit is False
        else:
            await driver.until(lambda: driver.app._exit)
    assert ("// hi" in program.read_text()) == is_saved


async def test_nothing_replaces_a_text_that_is_not_saved(program: Path) -> None:
    async with studio(program) as driver:
        await driver.type("// hi")
        tab = driver.main.program.tab
        await driver.press("ctrl+n")
        driver.main.action_welcome()
        await driver.dialog("Welcome")
        await driver.pilot.press("down", "enter")
        await driver.back()
        assert driver.main.program.tab is not tab
        assert tab.open.text.startswith(b"// hi")


async def test_a_program_is_opened(program: Path) -> None:
    other = program.with_name("other.plastron")
    other.write_text("create_node 'arm' as arm\n")
    async with studio(program) as driver:
        await driver.pilot.press("ctrl+o")
        await driver.dialog("ChooseFile")
        await driver.pilot.press(*"oth", "enter")
        await driver.back()
        assert driver.main.open.path == other
        assert driver.shown("nodes") == ["● arm rospy does nothing"]
        assert driver.app.profile.remembered.recent[0] == str(other)
        # What was open lately can be opened from any folder, but for what is open.
        late = program.parent.parent / "late" / "walk.plastron"
        late.parent.mkdir()
        late.write_text("// late\n")
        driver.app.profile.remembered.opened(late)
        await driver.pilot.press("ctrl+o")
        dialog = await driver.dialog("ChooseFile")
        rows = [str(each.prompt).split("  ")[0] for each in dialog.query_one(OptionList).options]
        assert rows[0] == "walk.plastron" and rows[2:] == ["../", "other.plastron", "talk.plastron"]
        assert str(dialog.query_one("#dialog-folder", Label).content) == "opened lately"
        await driver.pilot.press("enter")
        await driver.back()
        assert driver.main.open.path == late


@pytest.mark.parametrize(
    ("written", "offered"),
    [("", ["b", "c"]), ("B", ["b"]), ("x", []), ("/w/", []), ("../b", [])],
)
def test_files_of_late_are_those_that_fit_and_are_in_other_folders(
    written: str, offered: list[str]
) -> None:
    recent = [Path("/w/a"), Path("/other/b"), Path("/other/c")]
    part = written.rpartition("/")[2]
    found = recent_in(recent, Path("/w"), part, written)
    assert [path.name for path in found] == offered


NO_PROGRAMS = {
    "latin": (b"\xff\xfe", "the file is not UTF-8 (line 1)"),
    "binary": (b"a\0b", "NUL"),
    "20 MB": (b"// x\n" * (4 * 1024 * 1024), "larger than 16 MB"),
}


async def test_a_file_that_is_no_program_is_said_and_the_text_stays(program: Path) -> None:
    async with studio(program) as driver:
        for name, (contents, said) in NO_PROGRAMS.items():
            bad = program.with_name(f"{name}.plastron")
            bad.write_bytes(contents)
            driver.main.files.open_file(bad)
            await driver.until(lambda said=said: said in driver.notes())
            assert driver.text == PROGRAM
            assert bad.read_bytes() == contents


@pytest.mark.parametrize("name", mostly_long(NO_PROGRAMS, ["binary"]))
async def test_a_studio_that_starts_with_no_program_says_so(tmp_path: Path, name: str) -> None:
    contents, said = NO_PROGRAMS[name]
    bad = tmp_path / "bad.plastron"
    bad.write_bytes(contents)
    async with studio(bad) as driver:
        assert said in driver.notes()
        assert driver.text == ""
    assert bad.read_bytes() == contents


async def test_a_file_that_cannot_be_written_is_said_and_the_text_stays(
    program: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    async with studio(program) as driver:
        await driver.type("// hi")

        def full(*_: object, **__: object) -> None:
            raise OSError(28, "No space left on device")

        with monkeypatch.context() as patch:
            patch.setattr(os, "fsync", full)
            await driver.press("ctrl+s")
            await driver.until(lambda: "no space left" in driver.notes())
        assert driver.text.startswith("// hi")
        assert driver.main.open.is_changed
        assert program.read_text() == PROGRAM
        for file in program.parent.iterdir():
            file.unlink()
        program.parent.rmdir()
        await driver.press("ctrl+s")
        await driver.until(lambda: "is not there" in driver.notes())
        assert driver.text.startswith("// hi")


@pytest.mark.parametrize(("key", "text"), [("k", "// mine"), ("l", "// theirs")])
async def test_a_file_that_others_change_is_asked_about(program: Path, key: str, text: str) -> None:
    async with studio(program) as driver:
        await driver.type("// mine")
        program.write_text("// theirs\n" + PROGRAM)
        driver.main.look_at_disk()
        dialog = await driver.dialog("Question")
        shown = dialog.query_one("TextView").text
        assert "-// mine" in shown
        assert "+// theirs" in shown
        await driver.pilot.press(key)
        await driver.back()
        assert driver.text.startswith(text)
        driver.main.look_at_disk()
        await driver.settle()
        assert driver.app.screen is driver.main


async def test_a_text_that_nobody_touched_gives_way_to_what_others_write(program: Path) -> None:
    async with studio(program) as driver:
        main = driver.main
        await driver.press("down")
        program.write_text(PROGRAM.replace("hello", "bye") + "// theirs\n")
        main.look_at_disk()
        await driver.until(lambda: driver.text.endswith("// theirs\n"))
        assert driver.app.screen is main
        assert not main.open.is_changed
        assert main.editor.state.row == 1
        assert "talk.plastron was changed by another program" in driver.notes()
        await driver.press("ctrl+z")
        assert driver.text == PROGRAM
        assert main.open.is_changed
        # What one has written oneself meanwhile is no other text.
        program.write_text(PROGRAM)
        main.look_at_disk()
        assert not main.open.is_changed
        # What is no program any more leaves the text alone.
        program.write_bytes(b"\xff\xfe")
        main.look_at_disk()
        await driver.until(lambda: "not UTF-8" in driver.notes())
        assert driver.text == PROGRAM


async def test_what_was_kept_in_place_of_the_file_is_saved_without_another_question(
    program: Path,
) -> None:
    async with studio(program) as driver:
        await driver.type("// hi\n")
        program.write_text("// theirs\n" + PROGRAM)
        driver.main.look_at_disk()
        await driver.dialog("Question")
        await driver.pilot.press("k")
        await driver.back()
        assert driver.main.open.is_changed
        await driver.until(lambda: driver.main.open.journal.file.exists())
        await driver.press("ctrl+s")
        await driver.until(lambda: program.read_text() == "// hi\n" + PROGRAM)
        assert driver.app.screen is driver.main
        program.write_text("// others\n" + PROGRAM)
        await driver.type("// mine")
        await driver.press("ctrl+s")
        await driver.dialog("Question")
        assert program.read_text() == "// others\n" + PROGRAM


async def test_a_file_that_the_program_loads_is_read_again_when_it_changes(program: Path) -> None:
    program.write_text("load 'old.py' as old\n")
    node = program.with_name("old.py")
    head = "import rospy\nfrom std_msgs.msg import String\nrospy.init_node('old')\n"
    async with studio(program) as driver:
        driver.main.look_at_disk()
        node.write_text(head)
        driver.main.look_at_disk()
        await driver.until(lambda: driver.shown("nodes") == ["● old old.py does nothing"])
        driver.main.look_at_disk()
        node.write_text(head + "rospy.Publisher('chatter', String, queue_size=1)\n")
        driver.main.look_at_disk()
        await driver.until(lambda: "↑ chatter std_msgs/String · depth 1" in driver.shown("nodes"))
        node.unlink()
        driver.main.look_at_disk()
        await driver.until(lambda: driver.shown("nodes") == [])
        assert driver.text == "load 'old.py' as old\n"


async def test_saving_does_not_overwrite_what_others_wrote(
    program: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    # The look at the disk that comes from time to time would ask first.
    monkeypatch.setattr(MainScreen, "look_at_disk", lambda _: None)
    async with studio(program) as driver:
        await driver.type("// mine")
        program.write_text("// theirs\n")
        await driver.pilot.press("ctrl+s")
        await driver.dialog("Question")
        await driver.pilot.press("c")
        await driver.back()
        assert program.read_text() == "// theirs\n"
        await driver.pilot.press("ctrl+s")
        await driver.dialog("Question")
        await driver.pilot.press("o")
        await driver.until(lambda: not driver.main.open.is_changed)
    assert program.read_text().startswith("// mine")


async def test_what_was_typed_is_in_the_journal_within_a_second(program: Path) -> None:
    folder = state_folder() / "journal"
    async with studio(program) as driver:
        await driver.type("// hi")
        await driver.until(lambda: any(folder.glob("*.journal")))
        await driver.press("ctrl+s")
        await driver.until(lambda: not any(folder.glob("*.journal")))


@pytest.mark.parametrize(("key", "text"), [("r", "// kept\n"), ("f", ""), ("l", "")])
async def test_what_a_crash_left_is_offered(
    program: Path, key: str, text: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    kept = leave_behind(program, "// kept\n" + PROGRAM, cursor=3)
    monkeypatch.chdir(program.parent)
    async with studio(Path(program.name), welcome=True) as driver:
        dialog = await driver.dialog("Question")
        assert "+// kept" in dialog.query_one("TextView").text
        await driver.pilot.press(key)
        await driver.back()
        assert driver.text == text + PROGRAM
        if key == "r":
            assert driver.main.editor.cursor_offset == 3
            assert driver.main.open.is_changed
        await driver.until(lambda: kept.exists() == (key == "l"))
        assert driver.main.open.journal.file.exists() == (key == "r")
        assert len(driver.main.program.tabs) == 1
        await driver.press("ctrl+z")
        assert driver.text == PROGRAM


def test_a_journal_that_is_no_journal_is_left_out(tmp_path: Path) -> None:
    (tmp_path / "a.journal").write_bytes(b"{}\nx")
    (tmp_path / "b.journal").write_bytes(b"\xff")
    (tmp_path / "c.journal").mkdir()
    assert kept_texts(tmp_path) == []


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("cursor", "Infinity"),
        ("cursor", "NaN"),
        ("pid", "Infinity"),
        ("pid", "1e400"),
        ("when", "[]"),
        ("path", "[]"),
    ],
)
def test_a_broken_journal_hides_no_other(tmp_path: Path, name: str, value: str) -> None:
    good = leave_behind(tmp_path / "a.plastron", PROGRAM)
    head, _, text = good.read_bytes().partition(b"\n")
    file = good.parent / "b.journal"
    fields = {key: json.dumps(each) for key, each in json.loads(head).items()} | {name: value}
    broken = "{" + ", ".join(f'"{key}": {each}' for key, each in fields.items()) + "}\n"
    file.write_bytes(broken.encode() + text)
    file.chmod(0o600)
    assert [kept.file for kept in kept_texts(good.parent)] == [good]


def test_a_journal_of_no_time_is_an_old_one(tmp_path: Path) -> None:
    file = leave_behind(tmp_path / "a.plastron", PROGRAM)
    head, newline, text = file.read_bytes().partition(b"\n")
    when = json.dumps(json.loads(head)["when"]).encode()
    file.write_bytes(head.replace(b'"when": ' + when, b'"when": NaN') + newline + text)
    (kept,) = kept_texts(file.parent)
    assert kept.when == 0


def test_what_has_become_of_a_file_is_said_as_it_is(tmp_path: Path) -> None:
    folder, pipe, loop, link = (tmp_path / name for name in ("folder", "pipe", "loop", "link"))
    folder.mkdir()
    os.mkfifo(pipe)
    loop.symlink_to(loop)
    link.symlink_to(tmp_path / "nothing")
    found = {path.name: lost(path).partition(";")[0] for path in (folder, pipe, loop, link)}
    assert found == {
        "folder": "folder can no longer be read: it is a folder now",
        "pipe": "pipe can no longer be read: it is not a regular file",
        "loop": "loop can no longer be read: too many levels of symbolic links",
        "link": "link can no longer be read: it is a link to nothing",
    }
    assert lost(tmp_path / "gone") == "gone is no longer on the disk; save it to keep it"
