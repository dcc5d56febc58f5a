"""What must be on the disk before what, should the machine stop: read off the calls of a write."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from plastron_tui.output.own_files import JOURNAL, JOURNAL_NEW
from plastron_tui.output.plan import OutputFile
from plastron_tui.output.writer import write

Call = tuple[str, ...]


@pytest.fixture
def calls(monkeypatch) -> list[Call]:
    """The calls that change the disk, with the paths that they are about."""
    found: list[Call] = []
    real = {name: getattr(os, name) for name in ("write", "fsync", "replace", "rename", "unlink")}

    def path(descriptor: int) -> str:
        return os.readlink(f"/proc/self/fd/{descriptor}")

    def write_(descriptor: int, text: bytes) -> int:
        found.append(("write", path(descriptor)))
        return real["write"](descriptor, text)

    def fsync(descriptor: int) -> None:
        real["fsync"](descriptor)
        found.append(("sync", path(descriptor)))

    def rename(source: str, target: str) -> None:
        real["rename"](source, target)
        found.append(("rename", str(source), str(target)))

    def unlink(path: str) -> None:
        real["unlink"](path)
        found.append(("unlink", str(path)))

    for name, call in (("write", write_), ("fsync", fsync), ("unlink", unlink)):
        monkeypatch.setattr(os, name, call)
    for name in ("rename", "replace"):
        monkeypatch.setattr(os, name, rename)
    return found


@pytest.mark.parametrize("force", [True, False])
def test_each_step_is_on_the_disk_before_the_next(
    tmp_path: Path, plan, calls: list[Call], force: bool
) -> None:
    output, source = tmp_path / "output", tmp_path / "src" / "robot.py"
    source.parent.mkdir()
    output.mkdir()
    source.write_bytes(b"old")
    if force:
        (output / "a.py").write_bytes(b"by hand")
    files = [
        *(OutputFile(name, b"new") for name in ("a.py", "b.py")),
        OutputFile("robot.py", b"new", False, b"old", source),
    ]
    made = plan(output, files)
    calls.clear()
    assert write(made, force=force).diagnostics == ()
    folders = {os.fspath(output), os.fspath(source.parent)}
    journals = [i for i, call in enumerate(calls) if call[0] == "rename" and is_journal(call[2])]
    renames = [
        i for i, call in enumerate(calls) if call[0] == "rename" and call[1].endswith(".new")
        and i not in journals
    ]  # fmt: skip
    removals = [i for i, call in enumerate(calls) if call[0] == "unlink" and is_journal(call[1])]
    assert (len(journals), len(renames), len(removals)) == (2, 4, 2)
    # Every text, and every journal, is synced after its last byte and before the journal counts.
    for i in (*journals, *renames):
        name = calls[i][1]
        written = max(j for j, call in enumerate(calls) if call == ("write", name))
        assert any(written < j < min(i, journals[-1]) for j in synced(calls, name))
    # Each journal's folder is synced before the next journal, the last one before the first rename.
    for i, then in zip(journals, (*journals[1:], renames[0]), strict=True):
        assert any(i < j < then for j in synced(calls, os.path.dirname(calls[i][2])))
    # All folders are synced between the last rename and the first removal of a journal.
    for folder in folders:
        assert any(renames[-1] < j < removals[0] for j in synced(calls, folder))
    # The journal that decides was the last to appear, and goes last, for good after the others.
    assert calls[removals[-1]][1] == calls[journals[-1]][2]
    other = os.path.dirname(calls[removals[0]][1])
    assert any(removals[0] < j < removals[1] for j in synced(calls, other))


def is_journal(path: str) -> bool:
    return os.path.basename(path) == JOURNAL


def synced(calls: list[Call], path: str) -> list[int]:
    assert not path.endswith("/")
    return [i for i, call in enumerate(calls) if call == ("sync", path)]


def test_the_journal_is_never_half_written(tmp_path: Path, plan, calls: list[Call]) -> None:
    write(plan(tmp_path, [OutputFile("a.py", b"new")]))
    assert ("write", os.fspath(tmp_path / JOURNAL_NEW)) in calls
    assert ("write", os.fspath(tmp_path / JOURNAL)) not in calls
