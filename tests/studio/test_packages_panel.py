"""Packages, launch files and types in the studio: shown, completed, acted on, renamed."""

from __future__ import annotations

from pathlib import Path

import pytest
from loaded_packages import AMENT_PYTHON, IN, lay
from studio_driver import Driver, studio

from plastron_tui.language import Document
from plastron_tui.language.expectations import expected_at
from plastron_tui.session import Options, Session
from plastron_tui.studio.analysis import Analysis, analyse
from plastron_tui.studio.editor.completion import candidates
from plastron_tui.studio.editor.names import variable_at
from plastron_tui.studio.editor.vocabulary import Vocabulary
from plastron_tui.studio.panels.preview import previews_of
from plastron_tui.studio.panels.registry import PACKAGES
from plastron_tui.studio.renaming import renamed, wrong_name

TEXT = """\
create_message_type Speed with float64 left, float64 right
create_service_type Stop with none returning Speed[] last
create_node 'wheels' as wheels
create_message turning of message_type Speed and input 1.0, 2.0
wheels publish turning to 'speed' of message_type Speed
create_node 'watcher' as watcher
subscribe watcher to 'speed' of message_type Speed
create_launch 'bringup' as bringup
bringup starts wheels in 'front'
create_package 'rover' as rover
rover contains wheels as 'drive'
rover contains bringup
generate_package rover
"""


def analysis_of(text: str, path: Path | None = None) -> Analysis:
    return analyse(Session(text.encode(), path, Options(target="rclpy"), environ={}), lambda: None)


def test_the_panel_has_each_thing_with_what_it_holds() -> None:
    analysis = analysis_of(TEXT)
    assert analysis.diagnostics == ()
    shown = [
        f"{'  ' * each.depth}{each.sign} {each.text} {each.detail}".rstrip()
        for each in PACKAGES.make(analysis, None).all  # type: ignore[attr-defined]
    ]
    assert shown == [
        "▣ rover",
        "  ● drive wheels",
        "  ▶ bringup",
        "▶ bringup launch file",
        "  ● wheels in front",
        "◫ Speed message of your own",
        "◫ Stop service of your own",
    ]
    assert PACKAGES.count(analysis) == 4


@pytest.mark.parametrize(
    ("line", "first"),
    [
        ("rover contains ", ["wheels", "watcher", "bringup"]),
        ("rover no_longer_contains ", ["wheels", "bringup"]),
        ("generate_package ", ["rover"]),
        ("generate_launch ", ["bringup"]),
        ("bringup starts ", ["wheels", "watcher"]),
        ("bringup no_longer_starts ", ["'wheels'"]),
        ("drop_type ", ["Speed", "Stop"]),
        ('Stop has_field "bool on" in ', ["request"]),
        ("subscribe watcher to 'new' of message_type ", ["Speed"]),
        ("create_message_type More with ", ["float64"]),
        ("create_message_type More with float64 x, Sp", ["Speed"]),
        ("create_package 'arm' as ", ["arm"]),
        ("load_launch 'launch/other.launch.xml' as ", ["other"]),
        ("create_package 'arm' as arm licensed_under ", ['"Apache-2.0"']),
    ],
)
def test_completion_offers_what_there_is(line: str, first: list[str]) -> None:
    session = Session((TEXT + line + "\n").encode(), environ={})
    known = Session(TEXT.encode(), environ={})
    expected = expected_at(session.document, len((TEXT + line).encode()))
    found = candidates(expected, Vocabulary(known.program, known.workspace), session)
    assert [each.text for each in found][: len(first)] == first


@pytest.mark.parametrize(
    ("key", "new", "changed"),
    [
        ("package rover", "robot", ["as robot", "create_package 'robot'", "robot contains wheels"]),
        ("launch bringup", "all_of_it", ["create_launch 'all_of_it' as all_of_it",
                                         "rover contains all_of_it", "all_of_it starts wheels"]),
        ("type Speed", "Pace", ["create_message_type Pace", "returning Pace[] last",
                                "subscribe watcher to 'speed' of message_type Pace"]),
    ],
)  # fmt: skip
def test_another_name_is_put_everywhere(key: str, new: str, changed: list[str]) -> None:
    analysis = analysis_of(TEXT)
    assert PACKAGES.make is not None
    entries = PACKAGES.make(analysis, None).all  # type: ignore[attr-defined]
    entry = next(each for each in entries if each.key == key)
    assert wrong_name(analysis, entry, new) is None
    assert wrong_name(analysis, entry, entry.text) is not None
    text = TEXT
    edits = renamed(analysis, entry, new).edits
    for edit in sorted(edits, key=lambda each: each.span.start, reverse=True):
        text = text[: edit.span.start] + edit.text + text[edit.span.end :]
    assert analysis_of(text).diagnostics == ()
    assert all(each in text for each in changed)


@pytest.mark.parametrize(
    ("at", "definition"),
    [
        ("contains wheels", "rover as rover"),
        ("watcher to 'speed' of message_type Speed", "Speed with"),
        ("Speed[] last", "Speed with"),
        ("bringup starts", "bringup\n"),
    ],
)
def test_a_name_leads_to_where_it_is_made(at: str, definition: str) -> None:
    word = at.split()[-1] if at.startswith("watcher") else at.split()[0].rstrip("[]")
    if at.startswith("contains"):
        at, word, definition = "rover contains wheels", "rover", "rover\nrover contains"
    offset = TEXT.index(at) + at.index(word)
    found = variable_at(Document(TEXT.encode()), offset)
    assert found is not None and found.definition is not None
    assert TEXT[found.definition.start :].startswith(definition)


@pytest.mark.parametrize(
    ("variable", "files"),
    [
        ("rover", {"rover/package.xml", "rover/rover/drive.py", "rover/launch/bringup.launch.xml"}),
        ("bringup", {"rover/launch/bringup.launch.xml"}),
        ("Speed", {"rover_interfaces/msg/Speed.msg"}),
    ],
)
def test_the_preview_has_the_files_of_what_is_at_the_cursor(
    variable: str, files: set[str], tmp_path: Path
) -> None:
    analysis = analysis_of(TEXT, tmp_path / "x.plastron")
    names = {each.name for each in previews_of(analysis, variable)}
    assert files <= names
    assert variable == "rover" or names == files
    statement = {"rover": "generate_package", "bringup": "bringup starts", "Speed": "create_mess"}
    assert analysis.written_at(TEXT.index(statement[variable])) == variable


def test_the_preview_of_a_loaded_package_has_what_is_changed(tmp_path: Path) -> None:
    lay(tmp_path, AMENT_PYTHON)
    analysis = analysis_of(IN, tmp_path / "x.plastron")
    names = {each.name for each in previews_of(analysis, "demo")}
    assert names == {"demo/package.xml", "demo/setup.py", "demo/demo/talker.py"}


async def act(driver: Driver, start: str, key: str) -> None:
    await driver.show("packages")
    rows = driver.shown("packages")
    at = next(number for number, line in enumerate(rows) if line.startswith(start))
    await driver.press("home", *["down"] * at)
    await driver.press(key)


async def test_what_is_deleted_is_taken_out_by_a_statement(program: Path) -> None:
    program.write_text(TEXT)
    async with studio(program) as driver:
        await act(driver, "● drive", "delete")
        assert "rover no_longer_contains wheels\ngenerate_package rover\n" in driver.text
        await act(driver, "● wheels", "delete")
        assert "bringup no_longer_starts 'wheels'" in driver.text
        await act(driver, "▶ bringup launch file", "g")
        assert driver.text.endswith("generate_launch bringup\n")


def test_the_panel_has_the_package_that_no_statement_makes(tmp_path: Path) -> None:
    text = "".join(
        f"create_node '{name}' as {name[0]} using {library}\n"
        f"subscribe {name[0]} to 'a' of message_type String\ngenerate_node {name[0]}\n"
        for name, library in (("ears", "rclcpp"), ("voice", "rclpy"), ("old", "rospy"))
    )
    analysis = analysis_of(text, tmp_path / "robot.plastron")
    entries = PACKAGES.make(analysis, None).all  # type: ignore[attr-defined]
    assert [(each.depth, each.text, each.detail) for each in entries] == [
        (0, "robot", "of the program's own"),
        (1, "ears", "e"),
        (1, "voice", "v"),
    ]
    assert PACKAGES.count(analysis) == 1
    assert entries[0].writing is None
