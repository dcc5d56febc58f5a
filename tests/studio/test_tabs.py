from __future__ import annotations

from pathlib import Path

import pytest
from studio_driver import PROGRAM, Driver, leave_behind, studio
from textual.widgets import Input, Label, OptionList

from plastron_tui.diagnostics import Edit, Span
from plastron_tui.session import Session
from plastron_tui.studio.files import OnDisk
from plastron_tui.studio.main.tab_line import names_of, window_of
from plastron_tui.studio.open_program import opened

OTHER = "create_node 'arm' as arm\n"


@pytest.fixture
def other(program: Path) -> Path:
    file = program.with_name("other.plastron")
    file.write_text(OTHER)
    return file


def tabs(driver: Driver) -> str:
    return " ".join(driver.main.tab_line.text.split())


async def test_each_program_has_a_tab_with_its_own_undo_cursor_and_panels(
    program: Path, other: Path
) -> None:
    async with studio(program, (80, 24)) as driver:
        main = driver.main
        assert tabs(driver) == ""
        await driver.type("// hi\n")
        place = main.editor.cursor_offset
        await driver.pilot.press("ctrl+o")
        await driver.dialog("ChooseFile")
        await driver.pilot.press(*"oth", "enter")
        await driver.back()
        assert tabs(driver) == "talk ● other"
        assert driver.text == OTHER
        # What is open is not what Enter would open again.
        await driver.pilot.press("ctrl+o")
        listed = (await driver.dialog("ChooseFile")).query_one(OptionList)
        assert listed.get_option_at_index(listed.highlighted).id == "talk.plastron"
        await driver.pilot.press("escape")
        await driver.back()
        assert [name.split()[1] for name in driver.shown("nodes")] == ["arm"]
        # What waits keeps its text and what can be undone, and not what the text means.
        assert main.program.tabs[0].open.analysis is None
        await driver.press("ctrl+z")
        assert driver.text == OTHER
        await driver.press("alt+e")
        assert driver.text == "// hi\n" + PROGRAM
        assert main.editor.cursor_offset == place
        assert driver.shown("nodes")[0].startswith("● talker")
        await driver.press("ctrl+z", "ctrl+z", "ctrl+z")
        assert driver.text == PROGRAM
        # A file that is open comes in front, and is not read again.
        main.files.open_file(other.parent / "." / "other.plastron")
        await driver.settle()
        assert [tab.open.name for tab in main.program.tabs] == ["talk.plastron", "other.plastron"]
        assert driver.text == OTHER
        await driver.pilot.click("#tabs", offset=(3, 0))
        await driver.settle()
        assert driver.text == PROGRAM
        await driver.press("ctrl+pageup", "alt+q")
        assert driver.text == PROGRAM
        assert tabs(driver) == ""


async def test_what_is_not_saved_in_any_tab_is_asked_about_once(program: Path, other: Path) -> None:
    async with studio(program, (80, 24), others=[other]) as driver:
        await driver.type("// one\n")
        await driver.press("alt+e")
        await driver.type("// two\n")
        # A new program is no reason to lose anything, nor is closing one.
        await driver.press("ctrl+n")
        assert tabs(driver) == "talk ● other ● new program"
        await driver.press("alt+q")
        await driver.pilot.press("alt+q")
        assert await said(driver) == "Save other.plastron?"
        await driver.pilot.press("escape")
        await driver.back()
        await driver.until(lambda: all(tab.open.journal.file.exists() for tab in tabs_of(driver)))
        await driver.pilot.press("ctrl+q")
        assert await said(driver) == "Save 2 programs?"
        await driver.pilot.press("s")
        await driver.until(lambda: driver.app._exit)
    assert program.read_text() == "// one\n" + PROGRAM
    assert other.read_text() == "// two\n" + OTHER


async def test_texts_of_all_tabs_are_kept_until_they_are_not_wanted(
    program: Path, other: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("plastron_tui.studio.main.recovery._KEEP", 3600.0)
    link = program.with_name("link.plastron")
    link.symlink_to(other)
    hard = program.with_name("hard.plastron")
    hard.hardlink_to(other)
    forgetful = list[Session]()
    files_changed = Session.files_changed

    def forget(session: Session) -> None:
        forgetful.append(session)
        files_changed(session)

    monkeypatch.setattr(Session, "files_changed", forget)
    async with studio(program, (80, 24), others=[other]) as driver:
        main = driver.main
        await driver.type("// one\n")
        left = main.open.session
        await driver.press("alt+e")
        # What it loads may be another text by the time that it is in front again.
        assert left in forgetful
        await driver.type("// two\n")
        # A link to a file that is open is that file.
        for each in (link, hard):
            main.files.open_file(each)
            await driver.settle()
        journals = [tab.open.journal.file for tab in main.program.tabs]
        assert len(journals) == 2
        assert not any(file.exists() for file in journals)
        main.recovery.keep_now()
        assert all(file.exists() for file in journals)
        await driver.pilot.press("ctrl+q")
        assert await said(driver) == "Save 2 programs?"
        await driver.pilot.press("d")
        await driver.until(lambda: driver.app._exit)
        assert not any(file.exists() for file in journals)
    assert other.read_text() == OTHER


def tabs_of(driver: Driver) -> list[object]:
    return list(driver.main.program.tabs)


async def said(driver: Driver) -> str:
    dialog = await driver.dialog("Question")
    return str(dialog.query_one("#dialog-title", Label).content)


async def test_a_file_of_another_tab_is_not_written_over(program: Path, other: Path) -> None:
    leave_behind(other, "// kept\n" + OTHER)
    async with studio(program, (80, 24), others=[other], welcome=True) as driver:
        assert await said(driver) == "other.plastron was not saved"
        await driver.pilot.press("r")
        await driver.back()
        assert driver.text == "// kept\n" + OTHER
        assert tabs(driver) == "talk other ●"
        await driver.pilot.press("alt+s")
        dialog = await driver.dialog("ChooseFile")
        dialog.query_one(Input).value = "talk"
        await driver.pilot.press("enter")
        await driver.until(lambda: "talk.plastron is open in another tab" in driver.notes())
        # What others write is taken when the program is in front; nothing of its own is lost.
        program.write_text("// theirs\n")
        await driver.pilot.press("alt+e")
        await driver.until(lambda: driver.text == "// theirs\n")


@pytest.mark.parametrize(
    ("active", "room", "window"),
    [(0, 100, (0, 4)), (0, 12, (0, 1)), (3, 21, (2, 4)), (1, 30, (1, 4)), (2, 1, (2, 3))],
)
def test_the_tab_in_front_is_in_sight(active: int, room: int, window: tuple[int, int]) -> None:
    assert window_of([10, 10, 10, 10], active, room) == window


def test_tabs_are_told_apart_by_their_folders(tmp_path: Path) -> None:
    paths = [tmp_path / "a/x.plastron", tmp_path / "b/x.plastron", tmp_path / f"{'long' * 9}.txt"]
    programs = [opened(OnDisk(path, b"", None), tmp_path) for path in paths]
    assert names_of(programs)[:2] == ["a/x", "b/x"]
    assert names_of(programs)[2].endswith("longlong.txt")
    assert len(names_of(programs)[2]) == 24


@pytest.mark.parametrize(
    ("files", "names"),
    [
        (["a/src/x", "b/src/x", "b/x", "c/src/x"], ["a/src/x", "b/src/x", "b/x", "c/src/x"]),
        (["left/of_an_arm/program", "at_the_right/of_an_arm/program"],
         ["left/of_an_arm/program", "at_the_right/…/program"]),
        (["a/" + 30 * "x", "b/" + 30 * "x"], ["…" + 23 * "x", "…" + 23 * "x" + " 2"]),
        (["", ""], ["new program", "new program 2"]),
    ],
)  # fmt: skip
def test_no_two_tabs_are_called_alike(tmp_path: Path, files: list[str], names: list[str]) -> None:
    disks = [OnDisk(tmp_path / f"{each}.plastron", b"", None) if each else None for each in files]
    assert names_of([opened(disk, tmp_path) for disk in disks]) == names


async def test_nodes_go_on_while_another_program_is_in_front(
    program: Path, other: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def command(path: Path, *_: object) -> list[str]:
        return ["sh", "-c", f"trap '{end}' INT TERM; echo from {path.stem}; {rest}"]

    may_end = tmp_path / "may_end"
    rest = "while :; do sleep 0.05; done"
    end = f"until [ -e {may_end} ]; do sleep 0.05; done; exit 130"
    monkeypatch.setattr("plastron_tui.studio.running._command", command)
    other.write_text(
        f"{OTHER}subscribe arm to 'chatter' of message_type String\ngenerate_node arm\n"
    )
    async with studio(program, (80, 24), others=[other]) as driver:
        output = driver.main.panels["output"]
        await driver.pilot.press("f5")
        await driver.until(lambda: "from talk" in output.text)
        await driver.press("ctrl+pagedown")
        assert output.text == ""
        assert tabs(driver) == "talk ▶ other"
        await driver.press("shift+f5")
        assert "nothing runs here; nodes run of talk.plastron" in driver.notes()
        await driver.pilot.press("f5")
        await driver.until(lambda: "from other" in output.text)
        assert tabs(driver) == "talk ▶ other ▶"
        await driver.press("ctrl+pageup", "shift+f5", "ctrl+pagedown")
        may_end.touch()
        await driver.until(lambda: "the nodes of talk.plastron have ended" in driver.notes())
        assert tabs(driver) == "talk other ▶"
        assert "from talk" not in output.text
        await driver.press("alt+q")
        assert "the nodes of other.plastron were stopped" in driver.notes()
        assert output.text.splitlines()[-1] == "stopped"
        # Behind the last program there is a new one, of which nothing has run.
        await driver.press("alt+q")
        assert driver.main.open.path is None
        assert output.text == ""


async def test_the_cursor_is_in_sight_in_a_tab_that_comes_back_to_a_smaller_window(
    program: Path, other: Path
) -> None:
    program.write_text("// a line\n" * 60)
    async with studio(program, (120, 40), others=[other]) as driver:
        editor = driver.main.editor
        editor.go_to(len("// a line\n") * 30)
        assert editor.view.scroll_offset.y > 0
        await driver.press(*["down"] * 10, "alt+e")
        assert driver.text == OTHER
        await driver.pilot.resize_terminal(80, 16)
        await driver.press("alt+e")
        assert editor.state.row == 40
        assert 0 <= editor.view.cell_of(editor.cursor_offset).y < editor.view.size.height


async def test_jumps_lead_back_and_forth_through_texts_and_tabs(program: Path, other: Path) -> None:
    other.write_text(f"// nothing\n\n{OTHER}")
    async with studio(program, others=[other]) as driver:
        main, editor = driver.main, driver.main.editor

        def place() -> tuple[str, int]:
            return main.open.name, editor.state.row

        editor.go_to(PROGRAM.index("greeting to"))
        await driver.press("f12")
        assert place() == ("talk.plastron", 1)
        # A panel that is walked through is one step, wherever it leads.
        await driver.show("nodes")
        await driver.press("down", "down", "down", "enter")
        await driver.until(lambda: place() == ("talk.plastron", 6))
        await driver.press("alt+e")
        assert main.open.name == "other.plastron"
        assert editor.view.has_focus
        await driver.press("down", "down", "alt+comma")
        assert place() == ("talk.plastron", 6)
        assert editor.view.has_focus
        # What is written above moves the places along.
        editor.apply([Edit(Span(0, 0), "// a line\n")])
        await driver.press("alt+comma")
        assert place() == ("talk.plastron", 2)
        await driver.press("alt+comma")
        assert place() == ("talk.plastron", 3)
        await driver.press("alt+full_stop", "alt+full_stop", "alt+full_stop")
        assert place() == ("other.plastron", 2)
        await driver.press("alt+full_stop")
        assert "there is no place to go forward to" in driver.notes()
        # The places of a text that is closed are none any more.
        editor.go_to(0)
        await driver.press("alt+q", "alt+comma")
        assert place() == ("talk.plastron", 2)
        assert "there is no place to go back to" not in driver.notes()
        main.files.open_file(other)
        await driver.until(lambda: main.open.name == "other.plastron")
        await driver.press("alt+comma")
        assert place() == ("talk.plastron", 2)
