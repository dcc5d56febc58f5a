"""A disk that is full, and one that is read-only: nothing is changed, and a diagnostic says why."""

from __future__ import annotations

import errno
import os
import shutil
import subprocess
from collections.abc import Iterator
from pathlib import Path

import pytest

from plastron_tui.output.manifest import load_manifest
from plastron_tui.output.plan import OutputFile, make_plan
from plastron_tui.output.writer import write


def mount(*arguments: str) -> bool:
    program = shutil.which("mount")
    return (
        bool(program) and not subprocess.run([program, *arguments], capture_output=True).returncode
    )


@pytest.fixture
def full_disk(tmp_path: Path, monkeypatch) -> Iterator[Path]:
    """A folder with 32 KiB of room: a file system of its own, or writes that fail like one."""
    folder = tmp_path / "disk"
    folder.mkdir()
    if mount("-t", "tmpfs", "-o", "size=32k", "tmpfs", str(folder)):
        yield folder
        subprocess.run(["umount", str(folder)], check=True)
        return
    room = 32 * 1024
    real = os.write

    def write_some(descriptor: int, text: memoryview) -> int:
        nonlocal room
        if not room:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        count = real(descriptor, text[:room])
        room -= count
        return count

    monkeypatch.setattr(os, "write", write_some)
    yield folder


def test_a_full_disk(full_disk: Path, snapshot) -> None:
    (full_disk / "n0.py").write_bytes(b"mine")
    before = snapshot(full_disk)
    files = [OutputFile(f"n{number}.py", b"x" * 7000, True) for number in range(9)]
    plan, _ = make_plan(full_disk / ".", files, load_manifest(full_disk)[0])
    result = write(plan, force=True)
    (diagnostic,) = result.diagnostics
    assert (diagnostic.code, result.written) == ("cannot-write", ())
    assert "no space left" in diagnostic.message
    assert diagnostic.help is not None
    assert snapshot(full_disk) == before


@pytest.fixture
def read_only(tmp_path: Path, monkeypatch) -> Iterator[Path]:
    """A folder that nobody may write to, the superuser included."""
    folder = tmp_path / "read_only"
    folder.mkdir()
    (folder / "a.py").write_bytes(b"mine")
    if os.geteuid() != 0:
        folder.chmod(0o555)
        yield folder
        folder.chmod(0o755)
    elif mount("--bind", str(folder), str(folder)):
        assert mount("-o", "remount,bind,ro", str(folder))
        yield folder
        subprocess.run(["umount", str(folder)], check=True)
    else:
        real = os.open

        def open_to_read(path: str, flags: int, *mode: int) -> int:
            if flags & os.O_CREAT:
                raise OSError(errno.EROFS, os.strerror(errno.EROFS))
            return real(path, flags, *mode)

        def refuse(*_: object) -> None:
            raise OSError(errno.EROFS, os.strerror(errno.EROFS))

        monkeypatch.setattr(os, "open", open_to_read)
        monkeypatch.setattr(os, "mkdir", refuse)
        yield folder


@pytest.mark.parametrize("below", [".", "new/output"])
def test_a_read_only_folder(read_only: Path, snapshot, below: str) -> None:
    before = snapshot(read_only)
    folder = read_only / below
    files = [OutputFile("a.py", b"x"), OutputFile("b.py", b"y")]
    plan, diagnostics = make_plan(folder, files, load_manifest(folder)[0])
    assert diagnostics == ()
    result = write(plan, force=True)
    (diagnostic,) = result.diagnostics
    assert diagnostic.code == "cannot-write"
    assert diagnostic.help is not None
    assert snapshot(read_only) == before
