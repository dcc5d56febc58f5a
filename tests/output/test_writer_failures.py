"""Whatever call to the operating system fails, the disk is wholly old or wholly new."""

from __future__ import annotations

import errno
import os
import shutil
import signal
from collections.abc import Callable, Iterator
from pathlib import Path
from types import FrameType

import pytest

from plastron_tui.diagnostics import has_errors
from plastron_tui.output import file_calls, journal, locks, recovery, replacement, transaction
from plastron_tui.output.manifest import load_manifest
from plastron_tui.output.own_files import settled
from plastron_tui.output.plan import FilePlan, OutputFile, make_plan
from plastron_tui.output.writer import write

_CALLS = {
    *("open", "write", "fsync", "close", "link", "replace", "rename", "unlink", "mkdir", "rmdir"),
    *("lstat", "stat", "fstat", "read", "listdir", "fchown", "fchmod", "listxattr"),
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


def watch(patch: pytest.MonkeyPatch, watched: WatchedOs) -> None:
    """Let the modules that write see another `os`."""
    for module in (file_calls, journal, locks, recovery, replacement, transaction):
        patch.setattr(module, "os", watched)


def raising(error: BaseException) -> Callable[[], None]:
    def event() -> None:
        raise error

    return event


def old_folder(root: Path) -> None:
    """One file of each kind: ours, by hand, merged, without the bit, identical."""
    folder = root / "output"
    ours = [OutputFile(name, b"#!old") for name in ("ours.py", "hand.py", "bit.py", "same.py")]
    write(make_plan(folder, ours, load_manifest(folder)[0])[0])
    (folder / "hand.py").write_bytes(b"by hand")
    (folder / "hand.py.bak").write_bytes(b"an older backup")
    (folder / "bit.py").chmod(0o644)
    (root / "src").mkdir()
    (root / "src" / "merged.py").write_bytes(b"merge me")


def old_plan(root: Path) -> FilePlan:
    folder = root / "output"
    files = [
        *(OutputFile(name, b"#!new") for name in ("ours.py", "hand.py", "new.py")),
        *(OutputFile(name, b"#!old") for name in ("bit.py", "same.py")),
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


@pytest.fixture(
    params=[
        pytest.param(("old", 1), marks=pytest.mark.long),
        pytest.param(("fresh", 1), marks=pytest.mark.long),
        *(("old", 11), ("fresh", 5)),
    ],
    ids=lambda param: f"{param[0]}, {'each' if param[1] == 1 else 'some'}",
)
def which(request) -> tuple[str, int]:
    """What there is, and by how many calls two rounds differ."""
    found: tuple[str, int] = request.param
    return found


@pytest.fixture
def calls(which) -> range:
    """The calls to the operating system at which something happens."""
    return range(1, 1000, which[1])


@pytest.fixture
def scene(which, tmp_path: Path) -> Iterator[Callable[[], tuple[Path, FilePlan]]]:
    """Builds the same folder again and again, with the plan for it."""
    prepare, plan = SCENES[which[0]]
    # To write it takes as long as what is tried in it: it is written once.
    (written := tmp_path / "written").mkdir()
    prepare(written)
    count = 0

    def build() -> tuple[Path, FilePlan]:
        nonlocal count
        count += 1
        root = Path(shutil.copytree(written, tmp_path / str(count)))
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
    """Without what the writer made for itself, where removing it is what failed."""
    return {name: what for name, what in found.items() if "/.plastron-" not in name}


def swept(root: Path) -> None:
    """What the next run does first."""
    for folder in (root, *(path for path in root.rglob("*") if path.is_dir())):
        assert settled(folder) == ()


def ends(scene, snapshot) -> tuple[object, object]:
    root, plan = scene()
    before = snapshot(root)
    assert write(plan, force=True).diagnostics == ()
    after = snapshot(root)
    assert before != after
    return before, after


@pytest.mark.usefixtures("_links")
def test_interrupted_at_each_call(scene, calls, snapshot, monkeypatch) -> None:
    interrupt_each_call(scene, calls, snapshot, monkeypatch, is_after=False)


def test_interrupted_after_each_call(scene, calls, snapshot, monkeypatch) -> None:
    interrupt_each_call(scene, calls, snapshot, monkeypatch, is_after=True)


def interrupt_each_call(scene, calls, snapshot, monkeypatch, *, is_after: bool) -> None:
    before, after = ends(scene, snapshot)
    seen = set()
    for at in calls:
        root, plan = scene()
        watched = WatchedOs(at, raising(KeyboardInterrupt()), is_after=is_after)
        with monkeypatch.context() as patch:
            watch(patch, watched)
            try:
                write(plan, force=True)
            except KeyboardInterrupt:
                assert watched.has_happened
            else:
                assert not watched.has_happened
        found = snapshot(root)
        assert found == before or tidied(found) == after, at
        seen.add(found != before)
        swept(root)
        assert snapshot(root) in (before, after), at
        if not watched.has_happened:
            break
    assert at > 15
    assert seen == {True, False}


@pytest.mark.usefixtures("_links")
@pytest.mark.parametrize("number", [errno.EIO, errno.ENOSPC, errno.EROFS])
def test_refused_at_each_call(scene, calls, snapshot, monkeypatch, number: int) -> None:
    before, after = ends(scene, snapshot)
    for at in calls:
        root, plan = scene()
        watched = WatchedOs(at, raising(OSError(number, os.strerror(number))))
        with monkeypatch.context() as patch:
            watch(patch, watched)
            result = write(plan, force=True)
        found = snapshot(root)
        if has_errors(result.diagnostics):
            assert all(diagnostic.code.is_io for diagnostic in result.diagnostics)
            assert len(result.diagnostics) == 1
            assert (found, result.written) == (before, ()), at
        else:
            assert tidied(found) == after, at
            is_tidy = tidied(found) == found
            codes = [diagnostic.code for diagnostic in result.diagnostics]
            assert codes in ([], ["not-kept"]) if is_tidy else codes == ["leftover-file"], at
            swept(root)
            assert snapshot(root) == after, at
        if not watched.has_happened:
            break
    assert at > 15


def test_a_real_signal_at_each_call(scene, calls, snapshot, monkeypatch) -> None:
    before, after = ends(scene, snapshot)
    seen = set()
    for at in calls:
        root, plan = scene()
        watched = WatchedOs(at, lambda: os.kill(os.getpid(), signal.SIGINT))
        with monkeypatch.context() as patch:
            watch(patch, watched)
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
        watch(monkeypatch, watched)
        with pytest.raises(KeyboardInterrupt):
            write(plan, force=True)
    finally:
        signal.signal(signal.SIGTERM, usual)
    assert (arrived, snapshot(root)) == ([signal.SIGTERM], before)


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
