"""Two programs of one name that are generated into one folder at the same time.

Wherever the one is when the other runs, the folder is as if one had run after the other.
"""

from __future__ import annotations

import os
import shutil
from collections.abc import Callable, Iterable
from pathlib import Path

import pytest
from file_sets import one

from plastron_tui.cli.group import cli
from plastron_tui.output import locks
from plastron_tui.output.locks import FolderLocks
from plastron_tui.targets import read_source


def program(*topics: str) -> str:
    lines = [f"subscribe arm to '{topic}' of message_type String\n" for topic in topics]
    return "create_node 'arm' as arm\n" + "".join(lines) + "generate_node arm\n"


def generate(folder: Path, at: str) -> int:
    """Generate one of the two programs; return the status."""
    try:
        cli.main(["generate", str(folder / at / "a.plastron"), "-o", str(folder / "out")])
    except SystemExit as left:
        return left.code if isinstance(left.code, int) else 1
    return 0


def prepared(folder: Path) -> Path:
    """Two programs, and the node of an earlier one that was changed by hand."""
    for at, topics in (("one", ("old", "x", "y")), ("two", ("old", "z", "w"))):
        (folder / at).mkdir(parents=True)
        (folder / at / "a.plastron").write_text(program(*topics))
    earlier = folder / "one" / "a.plastron"
    wanted = earlier.read_text()
    earlier.write_text(program("old", "older"))
    assert generate(folder, "one") == 0
    earlier.write_text(wanted)
    (node,) = (folder / "out").glob("*.py")
    node.write_text(node.read_text() + "\n\ndef mine():\n    pass\n")
    return folder


def endpoints(folder: Path) -> set[str]:
    (node,) = (folder / "out").glob("*.py")
    assert "def mine" in node.read_text()
    source = read_source(node, one(node.read_bytes())).source
    return {str(each.name) for each in source.endpoints}


class Meanwhile:
    """Runs another process when something in the output folder is looked at for the nth time.

    While the lock is held the other is waited for until it wants the lock, else until it ends.
    """

    def __init__(self, at: int, folder: Path) -> None:
        self.at, self.folder, self.count = at, folder, 0
        self.locked: list[int] = []
        self.child = 0
        self.was_locked = False
        self.name = ""

    def seen(self, path: object) -> None:
        if "/out/" in str(path):
            self.count += 1
            if self.count == self.at:
                self.name = Path(str(path)).name
                self.was_locked = bool(self.locked)
                self.start()
                if not self.was_locked:
                    self.join()

    def start(self) -> None:
        reading, writing = os.pipe()
        self.child = os.fork()
        if not self.child:
            for descriptor in self.locked:
                os.close(descriptor)
            real = FolderLocks.take

            def take(locks: FolderLocks, folders: Iterable[str]) -> None:
                os.write(writing, b".")
                real(locks, folders)

            FolderLocks.take = take  # type: ignore[method-assign]
            self.at = 0
            os._exit(generate(self.folder, "two"))
        assert os.read(reading, 1) == b"."

    def join(self) -> None:
        assert os.waitstatus_to_exitcode(os.waitpid(self.child, 0)[1]) == 0


def watch(patch: pytest.MonkeyPatch, meanwhile: Meanwhile, calls: Iterable[str]) -> None:
    """Let some calls to the operating system, and locks, be seen."""
    real_take, real_release = FolderLocks.take, FolderLocks.release

    def seeing(real: Callable[..., object]) -> Callable[..., object]:
        def call(path: Path | str, *rest: object, **named: object) -> object:
            meanwhile.seen(path)
            return real(path, *rest, **named)

        return call

    def take(locks: FolderLocks, folders: Iterable[str]) -> None:
        real_take(locks, folders)
        meanwhile.locked = list(locks.descriptors.values())

    def release(locks: FolderLocks) -> None:
        meanwhile.locked = []
        real_release(locks)

    patch.setattr(FolderLocks, "take", take)
    patch.setattr(FolderLocks, "release", release)
    patch.setattr(locks, "LOCK_SECONDS", 600.0)
    for name in calls:
        patch.setattr(os, name, seeing(getattr(os, name)))


def interleaved(tmp_path: Path, monkeypatch, *calls: str) -> None:
    base = prepared(tmp_path / "base")
    seen, names = set(), set()
    for at in range(1, 1000):
        folder = tmp_path / str(at)
        shutil.copytree(base, folder)
        meanwhile = Meanwhile(at, folder)
        with monkeypatch.context() as patch:
            watch(patch, meanwhile, calls)
            assert generate(folder, "one") == 0
        if meanwhile.count < at:
            break
        if meanwhile.was_locked:
            meanwhile.join()
        later = {"z", "w"} if meanwhile.was_locked else {"x", "y"}
        assert endpoints(folder) == {"old"} | later, at
        seen.add(meanwhile.was_locked)
        names.add(meanwhile.name)
    assert seen == {True, False}
    (node,) = (base / "out").glob("*.py")
    assert {node.name, ".plastron.json"} <= names


@pytest.mark.long
def test_one_program_that_comes_in_between(tmp_path: Path, monkeypatch) -> None:
    interleaved(tmp_path, monkeypatch, "open")


@pytest.mark.long
def test_one_program_that_comes_in_between_anywhere(tmp_path: Path, monkeypatch) -> None:
    interleaved(tmp_path, monkeypatch, "open", "lstat", "stat", "link", "replace", "unlink")
