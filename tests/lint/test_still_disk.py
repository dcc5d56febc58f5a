"""What the disk is asked while it counts as still."""

from __future__ import annotations

from pathlib import Path

import pytest

from plastron_tui.regular_files import observed
from plastron_tui.sources.still_disk import asked_once, is_file, read_once, still_disk


def test_disk_is_asked_once_while_it_counts_as_still(tmp_path: Path) -> None:
    file, other = tmp_path / "a.h", tmp_path / "b.h"
    file.write_text("a")
    asked: list[str] = []

    @asked_once
    def ask(name: str) -> str:
        asked.append(name)
        return name.upper()

    def look() -> tuple[bool, bool, bytes, str]:
        return is_file(str(file)), is_file(str(other)), read_once(file, 100), ask("x")

    with still_disk():
        before = look()
        file.write_text("b")
        other.touch()
        assert look() == before == (True, False, b"a", "X")
        # As in one that reads within another.
        with still_disk():
            assert look() == before
        assert look() == before
    assert asked == ["x"]
    # Nothing of it stays.
    assert look() == (True, True, b"b", "X")
    assert asked == ["x", "x"]
    with still_disk():
        assert look()[1:3] == (True, b"b")


def test_folder_a_link_and_what_is_not_there_are_asked_of_as_ever(tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    (tmp_path / "link").symlink_to("file")
    (tmp_path / "broken").symlink_to("none")
    (tmp_path / "folder").mkdir()
    names = ["file", "link", "broken", "folder", "none", "none/file", "file/none", "\0"]
    paths = [f"{tmp_path}/{name}" for name in names]
    plain = list(map(is_file, paths))
    with still_disk():
        assert list(map(is_file, paths)) == plain
        assert is_file("/none") is is_file("none") is False
    assert plain[:3] == [True, True, False]


def test_who_notes_what_is_read_gets_what_is_known(tmp_path: Path) -> None:
    file = tmp_path / "a.h"
    file.write_text("text")
    noted: list[tuple[str, bytes | None]] = []
    with still_disk():
        for _ in range(2):
            with observed(lambda path, status, text: noted.append((path, text))):
                read_once(file, 100)
                with pytest.raises(OSError, match="larger"):
                    read_once(file, 2)
    assert noted == 2 * [(str(file), b"text"), (str(file), None)]
