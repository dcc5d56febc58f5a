from __future__ import annotations

import threading
from pathlib import Path

import pytest
from studio_driver import PROGRAM, SIZES, Driver, studio
from textual.widgets import Button, Label, Static

from plastron_tui.diagnostics import Edit, Span
from plastron_tui.output.writer import write
from plastron_tui.session import Session

FILE = """\
import rospy
from std_msgs.msg import String

def heard(message):
    rospy.loginfo(message.data)

rospy.init_node('old')
rospy.Subscriber('chatter', String, heard)  # by hand
rospy.Subscriber('alarm', String, heard)
rospy.spin()
"""
LOADED = "load 'old.py' as old\nunsubscribe old from 'alarm'\ngenerate_node old\n"


async def ask(driver: Driver) -> Driver:
    await driver.pilot.press("f6")
    return await driver.dialog("GenerateDialog")


def said(dialog: object) -> str:
    return str(dialog.query_one("#dialog-text", Label).content)  # type: ignore[attr-defined]


def seen(dialog: object) -> tuple[str, str]:
    """Return the line above the text, and the text."""
    title = dialog.query_one("#dialog-seen", Label).content  # type: ignore[attr-defined]
    return str(title), dialog.query_one("TextView").text  # type: ignore[attr-defined]


async def test_a_robot_alone_is_written_and_not_run(tmp_path: Path) -> None:
    path = tmp_path / "robot.plastron"
    path.write_text("create_robot 'r' as r\nr has_link 'base'\ngenerate_robot r\n")
    async with studio(path) as driver:
        dialog = await ask(driver)
        await driver.pilot.press("enter")
        await driver.until(lambda: dialog.is_written)
        assert said(dialog) == "Written."
        assert not dialog.query_one("#run", Button).display


@pytest.mark.parametrize("size", [*SIZES, pytest.param((60, 20), marks=pytest.mark.long)])
async def test_a_loaded_node_is_shown_as_what_differs_from_its_file(
    loaded: Path, size: tuple[int, int]
) -> None:
    async with studio(loaded, size) as driver:
        dialog = await ask(driver)
        assert [file.state.value for file in dialog.plan.files] == ["create"]
        title, lines = seen(dialog)
        assert title.startswith("what differs from old.py")
        assert "-rospy.Subscriber('alarm', String, heard)" in lines
        await driver.pilot.press("d")
        title, lines = seen(dialog)
        assert title.startswith("the whole file")
        assert lines.startswith("import rospy")
        await driver.pilot.press("d", "enter")
        await driver.until(lambda: dialog.is_written)
        assert "plastron run" in said(dialog).replace("\n", " ")
        assert dialog.query_one("#run", Button).has_focus
    assert "alarm" not in (loaded.parent / "output" / "old.py").read_text()
    assert (loaded.parent / "old.py").read_text() == FILE


async def test_the_preview_of_a_loaded_node_is_what_differs_from_its_file(loaded: Path) -> None:
    async with studio(loaded) as driver:
        for _ in range(2):
            driver.main.action_show("preview")
            await driver.settle()
            assert "-rospy.Subscriber('alarm', String, heard)" in driver.main.panels["preview"].text
            dialog = await ask(driver)
            if dialog.query_one("#write", Button).display:
                await driver.pilot.press("enter")
                await driver.until(lambda dialog=dialog: dialog.is_written)
            await driver.pilot.press("escape")
            await driver.back()


async def test_the_preview_says_what_comes_first(loaded: Path) -> None:
    loaded.write_text(LOADED.replace("'alarm'", "'nothing'"))
    async with studio(loaded) as driver:
        panel = driver.main.panels["preview"]

        def head() -> str:
            return str(panel.query_one("#preview-head", Static).content)

        await driver.show("preview")
        said = "old.py  as it was loaded: nothing in it changes  mend 1 problem first"
        assert head() == said
        assert panel.text == FILE.rstrip("\n")
        driver.main.editor.replace_all(LOADED.encode())
        await driver.settle()
        assert head() == "output/old.py  will be created: what differs from old.py"
        driver.main.editor.replace_all(b"load 'gone.py' as old\nfoo\n")
        await driver.settle()
        assert head() == "mend 2 problems first"
        assert panel.text == ""


async def test_each_state_is_listed_with_what_it_is_about(program: Path) -> None:
    output = program.parent / "output"
    async with studio(program) as driver:
        dialog = await ask(driver)
        await driver.pilot.press("enter")
        await driver.until(lambda: dialog.is_written)
        await driver.pilot.press("escape")
        await driver.back()
        (output / "listener_sub1.py").write_text("mine\n")
        text = PROGRAM.replace("hello", "hallo") + (
            "create_node 'more' as more\n"
            "subscribe more to 'chatter' of message_type String\n"
            "generate_node more\n"
        )
        driver.main.editor.replace_all(text.encode())
        await driver.settle()
        dialog = await ask(driver)
        files = {file.name: file.state.value for file in dialog.plan.files}
        assert files == {
            "talker_pub.py": "changed", "listener_sub1.py": "conflict", "more_sub1.py": "create",
        }  # fmt: skip
        assert "-mine" in seen(dialog)[1], "what was written by hand is seen first"
        await driver.pilot.press("up")
        assert "+" in seen(dialog)[1] and "hallo" in seen(dialog)[1]
        await driver.pilot.press("down", "down")
        assert seen(dialog)[0] == "the whole file"
        assert "changed by hand" in said(dialog)
        assert not dialog.query_one("#write", Button).display
        await driver.pilot.press("f6")
        assert not (output / "more_sub1.py").exists()


async def test_what_cannot_be_written_is_said_and_nothing_is_lost(
    program: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    import os

    async with studio(program) as driver:
        dialog = await ask(driver)

        def full(*_: object, **__: object) -> None:
            raise OSError(28, "No space left on device")

        with monkeypatch.context() as patch:
            patch.setattr(os, "fsync", full)
            await driver.pilot.press("enter")
            await driver.until(lambda: "no space left" in driver.notes())
        assert not dialog.is_written
        assert not list(program.parent.glob("output/*.py"))
        await driver.pilot.press("enter")
        await driver.until(lambda: dialog.is_written)


async def test_a_program_that_generates_nothing_says_what_to_write(program: Path) -> None:
    program.write_text("// nothing yet\n")
    async with studio(program) as driver:
        dialog = await ask(driver)
        assert "generate_node" in seen(dialog)[1]
        await driver.pilot.press("enter", "escape")
        await driver.back()


async def test_a_program_without_a_file_is_saved_first(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    async with studio(None) as driver:
        driver.main.editor.replace_all(PROGRAM.encode())
        await driver.settle()
        await driver.pilot.press("f6")
        await driver.dialog("ChooseFile")
        await driver.pilot.press("enter")
        dialog = await driver.dialog("GenerateDialog")
        assert len(dialog.plan.files) == 2
        assert dialog.plan.folder == tmp_path / "output"


async def test_the_mistakes_of_a_new_text_are_awaited_from_the_worker(
    program: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked: list[threading.Thread] = []
    real = Session.diagnostics.fget  # type: ignore[attr-defined]

    def diagnostics(self: Session) -> object:
        asked.append(threading.current_thread())
        return real(self)

    monkeypatch.setattr(Session, "diagnostics", property(diagnostics))
    async with studio(program) as driver:
        driver.main.editor.apply([Edit(Span(0, 0), "generate_node nobody\n")])
        assert driver.is_missing
        driver.main.action_generate()
        await driver.until(lambda: "1 problem has to be fixed" in driver.notes())
        assert asked
        assert threading.main_thread() not in asked


async def test_what_cannot_be_found_out_is_said_instead_of_awaited(
    program: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(_: Session) -> None:
        raise RuntimeError("a deliberate error")

    async with studio(program) as driver:
        monkeypatch.setattr(Session, "diagnostics", property(fail))
        driver.main.editor.apply([Edit(Span(0, 0), "// new\n")])
        driver.main.action_generate()
        dialog = await driver.dialog("Failure")
        assert "a deliberate error" in dialog.report


async def test_a_file_that_another_process_writes_meanwhile(program: Path) -> None:
    """What the dialog shows is no longer so: the plan is made again, as by the command line."""
    async with studio(program) as driver:
        dialog = await ask(driver)
        others = Session(program.read_bytes().replace(b"hello", b"hallo"), program)
        made, _ = others.plan()
        write(made)
        await driver.pilot.press("enter")
        await driver.until(lambda: dialog.is_written)
        assert not driver.app._notifications
