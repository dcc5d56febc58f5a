"""The files that would be written, as a tree."""

from __future__ import annotations

from pathlib import Path

import pytest
from studio_driver import SIZES, Driver, studio

from plastron_tui.output.plan import FileState
from plastron_tui.studio.panels.file_tree import (
    FileTree,
    TreeFile,
    entries_of,
    first_seen,
    keys_of,
    size_text,
)
from plastron_tui.studio.panels.preview import Preview
from plastron_tui.studio.panels.styles import Piece

NEW, SAME, OTHER, HAND = (
    FileState.CREATE, FileState.IDENTICAL, FileState.CHANGED, FileState.CONFLICT,
)  # fmt: skip
PACKAGE = [
    ("rover/package.xml", NEW),
    ("rover/setup.py", OTHER),
    ("rover/rover/__init__.py", SAME),
    ("rover/rover/talker.py", HAND),
    ("rover/launch/rover.launch.xml", NEW),
    ("rover_interfaces/msg/Speed.msg", NEW),
]


def files(*named: tuple[str, FileState | None]) -> list[TreeFile]:
    return [TreeFile(name, state, 1500) for name, state in named]


def lines(found: list[TreeFile]) -> list[str]:
    return [
        "  " * each.depth + f"{each.sign.strip()} {each.text} {each.detail}".rstrip()
        for each in entries_of(found).all
    ]


@pytest.mark.parametrize(
    ("found", "shown"),
    [
        (files(("talker.py", NEW)), ["+ create talker.py"]),
        (
            files(("a.py", NEW), ("b.py", SAME), ("c.py", HAND)),
            ["+ create a.py", "= identical b.py", "! conflict c.py"],
        ),
        (files(("in/a.py", NEW), ("in/b.py", None)), ["+ create in/a.py", "· in/b.py"]),
        (
            files(*PACKAGE),
            [
                "▾ rover/ 5 files, 1 changed, 1 by hand",
                "  ▾ launch/ 1 file",
                "    + rover.launch.xml 1.5 kB",
                "  ▾ rover/ 2 files, 1 by hand",
                "    = __init__.py 1.5 kB",
                "    ! talker.py 1.5 kB",
                "  + package.xml 1.5 kB",
                "  ~ setup.py 1.5 kB",
                "▾ rover_interfaces/msg/ 1 file",
                "  + Speed.msg 1.5 kB",
            ],
        ),
        (
            files(("/opt/a/x.py", NEW), ("/opt/a/y.py", NEW), ("z.py", NEW)),
            ["▾ /opt/a/ 2 files", "  + x.py 1.5 kB", "  + y.py 1.5 kB", "+ z.py 1.5 kB"],
        ),
        ([], []),
    ],
)
def test_files_are_listed_and_many_in_folders_are_a_tree(
    found: list[TreeFile], shown: list[str]
) -> None:
    assert lines(found) == shown


@pytest.mark.parametrize(
    ("states", "first"),
    [
        (["identical", "create", "changed", "conflict"], 3),
        (["identical", "create", "changed"], 2),
        (["identical", "create", "create"], 1),
        (["identical", "identical"], 0),
        ([None, None], 0),
    ],
)
def test_what_has_to_be_decided_is_seen_first(states: list[str | None], first: int) -> None:
    files = [
        TreeFile(f"{number}.py", None if each is None else FileState(each), 0)
        for number, each in enumerate(states)
    ]
    assert first_seen(files) == first


def test_files_of_one_name_have_lines_of_their_own() -> None:
    found = files(("a/x.py", NEW), ("a/x.py", HAND), ("a/y.py", NEW))
    assert len(set(keys_of(found))) == 3
    assert lines(found)[1:3] == ["  + x.py 1.5 kB", "  ! x.py 1.5 kB"]


@pytest.mark.parametrize(
    ("size", "text"),
    [
        (0, "0 B"),
        (999, "999 B"),
        (1000, "1.0 kB"),
        (999_949, "999.9 kB"),
        (999_951, "1.0 MB"),
        (64 * 1024 * 1024, "67.1 MB"),
    ],
)
def test_sizes_are_short(size: int, text: str) -> None:
    assert size_text(size) == text


def preview(name: str, state: FileState | None) -> Preview:
    text = ((Piece(f"the text of {name}"),),)
    return Preview(name, Path(name), state, text, None, (), 100)


def tree_of(driver: Driver) -> FileTree:
    return driver.main.panels["preview"].query_one(FileTree)


@pytest.mark.parametrize("size", SIZES)
async def test_the_preview_of_a_package_is_walked_through_as_a_tree(
    program: Path, size: tuple[int, int]
) -> None:
    async with studio(program, size) as driver:
        await driver.show("preview")
        panel, tree = driver.main.panels["preview"], tree_of(driver)
        assert not tree.display
        panel.show(tuple(preview(*each) for each in PACKAGE))
        panel.focus()
        await driver.pilot.pause()
        assert tree.display
        assert driver.main.focused is tree
        assert panel.current.name == "rover/package.xml"
        await driver.pilot.press("down")
        assert panel.text == "the text of rover/setup.py"
        await driver.pilot.press("up", "up", "up", "left")
        assert panel.text == "the text of rover/rover/__init__.py"
        assert [each.text for each in tree._shown][:3] == ["rover/", "launch/", "rover.launch.xml"]
        assert "talker.py" not in [each.text for each in tree._shown]
        # A file in a folder that is folded is shown by `n`, and lies open then.
        await driver.pilot.press("n")
        assert panel.text == "the text of rover/rover/talker.py"
        assert tree.current.text == "talker.py"
        await driver.pilot.press("enter")
        assert driver.main.focused is panel._view
        await driver.pilot.press("t")
        assert driver.main.focused is tree


async def test_a_click_shows_a_file_and_folds_a_folder(program: Path) -> None:
    async with studio(program) as driver:
        await driver.show("preview")
        panel, tree = driver.main.panels["preview"], tree_of(driver)
        panel.show(tuple(preview(*each) for each in PACKAGE))
        await driver.pilot.pause()
        tree.scroll_home(animate=False)
        await driver.pilot.pause()
        assert await driver.pilot.click(tree, offset=(6, 2))
        await driver.pilot.pause()
        assert panel.text == "the text of rover/launch/rover.launch.xml"
        assert await driver.pilot.click(tree, offset=(6, 1))
        await driver.pilot.pause()
        assert tree._shown[2].text == "rover/"
        assert panel.text == "the text of rover/launch/rover.launch.xml"


async def test_the_tree_goes_with_the_files(program: Path) -> None:
    async with studio(program, (80, 24)) as driver:
        await driver.show("preview")
        panel, tree = driver.main.panels["preview"], tree_of(driver)
        panel.show(tuple(preview(*each) for each in PACKAGE))
        panel.focus()
        await driver.pilot.press("down")
        more = [*PACKAGE, ("rover/LICENSE", NEW)]
        panel.show(tuple(preview(*each) for each in more))
        assert panel.text == "the text of rover/setup.py"
        panel.show((preview("talker.py", NEW),))
        await driver.pilot.pause()
        assert not tree.display
        assert driver.main.focused is panel._view
        assert panel.text == "the text of talker.py"
