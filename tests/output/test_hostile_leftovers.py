"""Leftovers that are another user's, that change while they are looked at, or are no files."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from plastron_tui.output import recovery
from plastron_tui.output.journal import Entry, Journal, journal_text
from plastron_tui.output.manifest import NAME, digest
from plastron_tui.output.own_files import JOURNAL
from plastron_tui.output.plan import OutputFile
from plastron_tui.output.recovery import settle
from plastron_tui.output.replacement import Replacement
from plastron_tui.output.writer import write

NAMES = (".plastron-0.new", ".plastron-0.old", ".plastron-journal.new", ".plastron-0.tmp")


@pytest.fixture
def begun(tmp_path: Path) -> Path:
    """A folder whose only rename is still to come."""
    folder = tmp_path / "output"
    folder.mkdir()
    (folder / "a.py").write_text("old")
    (folder / ".plastron-0.new").write_text("new")
    entry = Entry("a.py", digest(b"old"), digest(b"new"))
    (folder / JOURNAL).write_bytes(journal_text(Journal("0" * 32, (entry,)), os.fspath(folder)))
    return folder


def test_one_s_own_journal_is_finished(begun: Path) -> None:
    settle(begun)
    assert (begun / "a.py").read_text() == "new"
    assert not list(begun.glob(".plastron-*"))


@pytest.mark.parametrize("whose", ["folder", "journal", "both"])
def test_another_user_s_journal_is_told_of_only(begun: Path, monkeypatch, whose: str) -> None:
    """Also the superuser does not do what the owner of a folder has written down."""
    theirs = {"folder": {begun}, "journal": {begun / JOURNAL}}.get(whose)
    inodes = {path.stat().st_ino for path in theirs or {begun, begun / JOURNAL}}
    for name in ("stat", "lstat"):
        real = getattr(os, name)

        def call(path: str, real=real, **named: object) -> os.stat_result:
            status = real(path, **named)
            if status.st_ino not in inodes:
                return status
            return os.stat_result((*status[:4], os.geteuid() + 1, *status[5:]))

        monkeypatch.setattr(os, name, call)
    (found,) = settle(begun)
    assert (found.code, found.severity.value) == ("interrupted-write", "warning")
    assert "another user" in found.message
    assert (begun / "a.py").read_text() == "old"
    # What is one's own goes, else the next write finds it in its way.
    assert sorted(path.name for path in begun.iterdir()) == [JOURNAL, "a.py"]


def test_a_file_that_changes_while_it_is_looked_at(begun: Path, monkeypatch) -> None:
    real = Replacement.finish

    def finish(self: Replacement) -> None:
        (begun / "a.py").write_text("by hand")
        real(self)

    monkeypatch.setattr(Replacement, "finish", finish)
    (found,) = settle(begun)
    assert "`a.py` was changed by hand" in found.message
    assert (begun / "a.py").read_text() == "by hand"


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("kind", ["link", "broken link", "fifo"])
def test_what_is_no_file_is_swept(tmp_path: Path, plan, name: str, kind: str) -> None:
    folder, outside = tmp_path / "output", tmp_path / "outside"
    folder.mkdir()
    if kind == "fifo":
        os.mkfifo(folder / name)
    else:
        (folder / name).symlink_to(outside)
    if kind == "link":
        outside.write_text("outside")
    assert write(plan(folder, [OutputFile("a.py", b"new")])).diagnostics == ()
    assert {path.name for path in folder.iterdir()} == {"a.py", NAME}
    assert outside.exists() == (kind == "link")


@pytest.mark.parametrize("name", [*NAMES[:3], JOURNAL])
def test_a_folder_in_the_way_is_named(tmp_path: Path, plan, snapshot, name: str) -> None:
    (tmp_path / "a.py").write_bytes(b"old")
    made = plan(tmp_path, [OutputFile("a.py", b"new", merged_from=b"old")])
    (tmp_path / name).mkdir()
    (tmp_path / name / "mine").touch()
    before = snapshot(tmp_path)
    found = write(made).diagnostics[-1]
    assert (found.message, found.help) == (f"`{name}` is in the way", "remove it")
    assert found.file == tmp_path / name
    assert snapshot(tmp_path) == before


@pytest.mark.parametrize("name", NAMES)
def test_what_is_another_s_stays(tmp_path: Path, plan, snapshot, monkeypatch, name: str) -> None:
    """A write that finds it in its way does not remove it as if it had made it itself."""
    (tmp_path / "a.py").write_bytes(b"old")
    made = plan(tmp_path, [OutputFile("a.py", b"new", merged_from=b"old")])
    (tmp_path / name).write_text("the only copy")
    monkeypatch.setattr(recovery, "_is_own", lambda path: False)
    monkeypatch.setattr(os, "link", refuse)  # else there is no `.tmp`
    before = snapshot(tmp_path)
    found = write(made).diagnostics[-1]
    assert (found.message, found.help) == (f"`{name}` is in the way", "remove it")
    assert snapshot(tmp_path) == before


def refuse(*_: object, **__: object) -> None:
    raise PermissionError(1, "Operation not permitted")
