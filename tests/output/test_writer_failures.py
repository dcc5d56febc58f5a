"""Whatever call to the operating system fails, the disk is wholly old or wholly new."""

from __future__ import annotations

import errno
import os
import shutil
import signal
import subprocess
from collections.abc import Callable, Iterator
from pathlib import Path
from types import FrameType

import pytest

from plastron_tui.diagnostics import IO_CODES
from plastron_tui.output import transaction
from plastron_tui.output.manifest import load_manifest
from plastron_tui.output.plan import FilePlan, OutputFile, make_plan
from plastron_tui.output.writer import write

_CALLS = {
    *("open", "write", "fsync", "close", "link", "replace", "unlink", "mkdir", "lstat"),
    *("fchown", "fchmod"),
}


class WatchedOs:
    """The `os` module, with something that happens at the nth call that matters."""

    def __init__(self, at: int, event: Callable[[], None], *, is_after: bool = False) -> None:
        self.at = at
        self.event = event
        self.is_after = is_after
        self.calls = 0

    def __getattr__(self, name: str) -> object:
        real = getattr(os, name)
        if name not in _CALLS:
            return real

        def call(*args: object, **kwargs: object) -> object:
            self.calls += 1
            is_now = self.calls == self.at
            if is_now and not self.is_after:
                self.event()
            try:
                return real(*args, **kwargs)
            finally:
                if is_now and self.is_after:
                    self.event()

        return call

    @property
    def has_happened(self) -> bool:
        return self.calls >= self.at


def raising(error: BaseException) -> Callable[[], None]:
    def event() -> None:
        raise error

    return event


def old_folder(root: Path) -> None:
    """One file of each kind: ours, by hand, merged, without the bit, identical."""
    folder = root / "output"
    ours = [OutputFile(name, b"old") for name in ("ours.py", "hand.py", "bit.py", "same.py")]
    write(make_plan(folder, ours, load_manifest(folder)[0])[0])
    (folder / "hand.py").write_bytes(b"by hand")
    (folder / "hand.py.bak").write_bytes(b"an older backup")
    (folder / "bit.py").chmod(0o644)
    (root / "src").mkdir()
    (root / "src" / "merged.py").write_bytes(b"merge me")


def old_plan(root: Path) -> FilePlan:
    folder = root / "output"
    files = [
        *(OutputFile(name, b"new") for name in ("ours.py", "hand.py", "new.py")),
        *(OutputFile(name, b"old") for name in ("bit.py", "same.py")),
        OutputFile("merged.py", b"merged", False, b"merge me", root / "src" / "merged.py"),
    ]
    plan, diagnostics = make_plan(folder, files, load_manifest(folder)[0])
    assert diagnostics == ()
    return plan


def fresh_plan(root: Path) -> FilePlan:
    folder = root / "deep" / "output"
    files = [OutputFile("a.py", b"a"), OutputFile("b.py", b"b")]
    return make_plan(folder, files, load_manifest(folder)[0])[0]


SCENES = {"old": (old_folder, old_plan), "fresh": (lambda root: None, fresh_plan)}


@pytest.fixture(params=SCENES)
def scene(request, tmp_path: Path) -> Iterator[Callable[[], tuple[Path, FilePlan]]]:
    """Builds the same folder again and again, with the plan for it."""
    prepare, plan = SCENES[request.param]
    count = 0

    def build() -> tuple[Path, FilePlan]:
        nonlocal count
        count += 1
        root = tmp_path / str(count)
        root.mkdir()
        prepare(root)
        return root, plan(root)

    yield build
    shutil.rmtree(tmp_path)


@pytest.fixture(params=["links", "no links"])
def _links(request, monkeypatch) -> None:
    if request.param == "no links":

        def refuse(*_: object) -> None:
            raise OSError(errno.EPERM, "Operation not permitted")

        monkeypatch.setattr(os, "link", refuse)


def tidied(found: dict[str, object]) -> dict[str, object]:
    """Without a text that was kept aside, where removing it is what failed."""
    return {name: what for name, what in found.items() if not name.endswith(".old")}


def ends(scene, snapshot) -> tuple[object, object]:
    root, plan = scene()
    before = snapshot(root)
    assert write(plan, force=True).diagnostics == ()
    after = snapshot(root)
    assert before != after
    return before, after


@pytest.mark.usefixtures("_links")
def test_interrupted_at_each_call(scene, snapshot, monkeypatch) -> None:
    interrupt_each_call(scene, snapshot, monkeypatch, is_after=False)


def test_interrupted_after_each_call(scene, snapshot, monkeypatch) -> None:
    interrupt_each_call(scene, snapshot, monkeypatch, is_after=True)


def interrupt_each_call(scene, snapshot, monkeypatch, *, is_after: bool) -> None:
    before, after = ends(scene, snapshot)
    seen = set()
    for at in range(1, 1000):
        root, plan = scene()
        watched = WatchedOs(at, raising(KeyboardInterrupt()), is_after=is_after)
        with monkeypatch.context() as patch:
            patch.setattr(transaction, "os", watched)
            try:
                write(plan, force=True)
            except KeyboardInterrupt:
                assert watched.has_happened
            else:
                assert not watched.has_happened
        found = snapshot(root)
        assert found == before or tidied(found) == after, at
        seen.add(found != before)
        if not watched.has_happened:
            break
    assert at > 15
    assert seen == {True, False}


@pytest.mark.usefixtures("_links")
@pytest.mark.parametrize("number", [errno.EIO, errno.ENOSPC, errno.EROFS])
def test_refused_at_each_call(scene, snapshot, monkeypatch, number: int) -> None:
    before, after = ends(scene, snapshot)
    for at in range(1, 1000):
        root, plan = scene()
        watched = WatchedOs(at, raising(OSError(number, os.strerror(number))))
        with monkeypatch.context() as patch:
            patch.setattr(transaction, "os", watched)
            result = write(plan, force=True)
        found = snapshot(root)
        if result.diagnostics:
            assert {diagnostic.code for diagnostic in result.diagnostics} <= IO_CODES
            assert len(result.diagnostics) == 1
            assert (found, result.written) == (before, ()), at
        else:
            assert tidied(found) == after, at
        if not watched.has_happened:
            break
    assert at > 15


def test_a_real_signal_at_each_call(scene, snapshot, monkeypatch) -> None:
    before, after = ends(scene, snapshot)
    seen = set()
    for at in range(1, 1000):
        root, plan = scene()
        watched = WatchedOs(at, lambda: os.kill(os.getpid(), signal.SIGINT))
        with monkeypatch.context() as patch:
            patch.setattr(transaction, "os", watched)
            try:
                write(plan, force=True)
            except KeyboardInterrupt:
                assert watched.has_happened
            else:
                assert not watched.has_happened
        found = snapshot(root)
        assert found in (before, after), at
        seen.add(found == after)
        assert signal.getsignal(signal.SIGINT) is signal.default_int_handler
        if not watched.has_happened:
            break
    assert seen == {True, False}


def test_other_signals_reach_their_handler_and_do_not_pass_for_success(
    scene, snapshot, monkeypatch
) -> None:
    root, plan = scene()
    before = snapshot(root)
    arrived: list[int] = []

    def remember(number: int, frame: FrameType | None) -> None:
        arrived.append(number)

    usual = signal.signal(signal.SIGTERM, remember)
    try:
        watched = WatchedOs(3, lambda: os.kill(os.getpid(), signal.SIGTERM))
        monkeypatch.setattr(transaction, "os", watched)
        with pytest.raises(KeyboardInterrupt):
            write(plan, force=True)
    finally:
        signal.signal(signal.SIGTERM, usual)
    assert (arrived, snapshot(root)) == ([signal.SIGTERM], before)


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


def test_what_cannot_be_put_back_is_told_and_kept(tmp_path: Path, monkeypatch) -> None:
    """The second rename fails, and then the first cannot be undone either."""
    folder = tmp_path / "output"
    files = [OutputFile("a.py", b"old"), OutputFile("b.py", b"old")]
    write(make_plan(folder, files, load_manifest(folder)[0])[0])
    files = [OutputFile("a.py", b"new"), OutputFile("b.py", b"new")]
    plan, _ = make_plan(folder, files, load_manifest(folder)[0])
    calls = 0
    real = os.replace

    def replace(source: str, target: str) -> None:
        nonlocal calls
        calls += 1
        if calls > 1:
            raise OSError(errno.EIO, "Input/output error")
        real(source, target)

    monkeypatch.setattr(os, "replace", replace)
    result = write(plan)
    assert [diagnostic.code for diagnostic in result.diagnostics] == ["cannot-write"] * 2
    assert "cannot put `a.py` back" in result.diagnostics[1].message
    assert (folder / ".plastron-0.old").read_bytes() == b"old"
    assert (folder / "b.py").read_bytes() == b"old"


@pytest.mark.parametrize("name", ["a.py", "b.py"], ids=["replaced", "new"])
def test_an_editor_that_saves_while_the_writer_works(
    tmp_path: Path, snapshot, monkeypatch, name: str
) -> None:
    (tmp_path / "a.py").write_bytes(b"old")
    files = [OutputFile("c.py", b""), OutputFile("a.py", b"new", False, b"old")]
    files.append(OutputFile("b.py", b"new"))
    plan, _ = make_plan(tmp_path, files, load_manifest(tmp_path)[0])
    # The first rename is of `c.py`: the others have long been looked at, and are not yet replaced.
    real = os.replace

    def replace(source: str, target: str) -> None:
        if target.endswith("c.py"):
            (tmp_path / name).write_bytes(b"saved by an editor")
        real(source, target)

    monkeypatch.setattr(os, "replace", replace)
    result = write(plan, force=True)
    assert [diagnostic.code for diagnostic in result.diagnostics] == ["changed-on-disk"]
    left = {"a.py": (0o644, b"old")} | {name: (0o644, b"saved by an editor")}
    assert snapshot(tmp_path) == left
