"""What the studio keeps in the user's state, when it is killed or the disk fails at any call."""

from __future__ import annotations

import errno
import os
import resource
import signal
import stat
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, NamedTuple

import pytest
from machine import mostly_long

from plastron_tui import private_files
from plastron_tui.studio.config import Remembered, load_remembered, save_remembered
from plastron_tui.studio.journal import Journal, kept_texts
from plastron_tui.studio.screens.failure import last_words

CALLS = ("mkdir", "open", "fchmod", "write", "fsync", "replace", "unlink", "close")
OLD, NEW = "an old text " * 20, "a new text " * 30


class Kind(NamedTuple):
    """One of the things that are kept: how it is written, and what is found of it later."""

    write: Callable[[Path, str], object]
    found: Callable[[Path], str | None]


def _write_journal(folder: Path, text: str) -> OSError | None:
    return Journal(folder, folder / "talk.plastron").write(text.encode(), 0)


def _found_journal(folder: Path) -> str | None:
    texts = [kept.text.decode() for kept in kept_texts(folder)]
    return texts[0] if texts else None


def _found_report(folder: Path) -> str | None:
    file = folder / "report.txt"
    return file.read_text().rpartition("RuntimeError: ")[2].strip() if file.exists() else None


KINDS = {
    "journal": Kind(_write_journal, _found_journal),
    "remembered": Kind(
        lambda folder, text: save_remembered(folder, Remembered(theme=text)),
        lambda folder: load_remembered(folder).theme,
    ),
    "report": Kind(lambda folder, text: last_words(RuntimeError(text), None, folder),
                   _found_report),
}  # fmt: skip


class Counted:
    """Counts the calls to the operating system, and lets something happen at one of them."""

    def __init__(self, wanted: int, happens: Callable[[Callable[..., Any], Any, Any], Any]) -> None:
        self.names: list[str] = []
        self._wanted = wanted
        self._happens = happens

    def install(self, patch: pytest.MonkeyPatch) -> None:
        for name in CALLS:
            patch.setattr(os, name, self._counting(name, getattr(os, name)))

    def _counting(self, name: str, original: Callable[..., Any]) -> Callable[..., Any]:
        def call(*arguments: Any, **options: Any) -> Any:
            self.names.append(name)
            if len(self.names) == self._wanted:
                return self._happens(original, arguments, options)
            return original(*arguments, **options)

        return call


def calls_of(kind: Kind, folder: Path, monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Write once and return the calls that it takes."""
    counted = Counted(0, lambda *_: None)
    with monkeypatch.context() as patch:
        counted.install(patch)
        kind.write(folder, OLD)
    return counted.names


def _kill(original: Callable[..., Any], arguments: Any, options: Any) -> None:
    os.kill(os.getpid(), signal.SIGKILL)


def _kill_after(original: Callable[..., Any], arguments: Any, options: Any) -> None:
    original(*arguments, **options)
    os.kill(os.getpid(), signal.SIGKILL)


def _kill_within(original: Callable[..., Any], arguments: Any, options: Any) -> None:
    if original.__name__ == "write":
        original(arguments[0], arguments[1][: len(arguments[1]) // 2])
    os.kill(os.getpid(), signal.SIGKILL)


QUICK = ("journal", _kill_within)
"""What the quick suite tries of the kills, at each call."""


def in_child(action: Callable[[], object]) -> int:
    """Do something in a copy of this process, and return how that ended."""
    child = os.fork()
    if child == 0:
        try:
            action()
        finally:
            os._exit(0)
    return os.waitpid(child, 0)[1]


def only_whole_files(folder: Path) -> bool:
    """Sweep as the next start does, and tell whether nothing but what was meant is there."""
    private_files.sweep(folder)
    return not list(folder.glob("*.tmp"))


ENUMERATED = [
    pytest.param(name, has_old, how, marks=[pytest.mark.long] if (name, how) != QUICK else [])
    for name in KINDS
    for has_old in (True, False)
    for how in (_kill, _kill_after, _kill_within)
]


@pytest.mark.parametrize(("name", "has_old", "how"), ENUMERATED)
def test_a_kill_at_any_call_leaves_the_old_text_or_the_new(
    name: str, has_old: bool, how: Callable[..., Any], tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:  # fmt: skip
    kind = KINDS[name]
    calls = calls_of(kind, tmp_path / "counted", monkeypatch)
    assert {"mkdir", "open", "write", "fsync", "replace"} <= set(calls)
    seen = set()
    for number in range(1, len(calls) + 1):
        folder = tmp_path / str(number)
        if has_old:
            # By a process that has ended, as the next start finds it.
            in_child(lambda to=folder: kind.write(to, OLD))  # type: ignore[misc]
        counted = Counted(number, how)

        def write(counted: Counted = counted, folder: Path = folder) -> None:
            counted.install(monkeypatch)
            kind.write(folder, NEW)

        died = in_child(write)
        # Without the folder to make there are fewer calls.
        assert has_old or died == signal.SIGKILL
        found = kind.found(folder)
        seen.add(found)
        assert (found or "").strip() in ((OLD.strip() if has_old else ""), NEW.strip())
        assert not folder.exists() or only_whole_files(folder)
    assert len(seen) == 2


@pytest.mark.parametrize(
    "code", mostly_long([errno.EIO, errno.ENOSPC, errno.EPERM], [errno.ENOSPC])
)
@pytest.mark.parametrize("name", KINDS)
def test_a_call_that_fails_leaves_the_old_text_or_the_new(
    name: str, code: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(*_: object) -> None:
        raise OSError(code, os.strerror(code))

    kind = KINDS[name]
    calls = calls_of(kind, tmp_path / "counted", monkeypatch)
    for number in range(1, len(calls) + 1):
        folder = tmp_path / str(number)
        in_child(lambda to=folder: kind.write(to, OLD))  # type: ignore[misc]
        counted = Counted(number, fail)
        with monkeypatch.context() as patch:
            counted.install(patch)
            kind.write(folder, NEW)
        assert (kind.found(folder) or "").strip() in (OLD.strip(), NEW.strip())
        with monkeypatch.context() as patch:
            # The next process.
            patch.setattr(private_files, "_TOKEN", "00000000")
            assert only_whole_files(folder)


def test_a_disk_that_is_full_in_the_middle_keeps_the_old_text(tmp_path: Path) -> None:
    in_child(lambda: _write_journal(tmp_path, OLD))

    def write() -> None:
        resource.setrlimit(resource.RLIMIT_FSIZE, (100, 100))
        os._exit(3 if _write_journal(tmp_path, NEW) is not None else 4)

    assert os.waitstatus_to_exitcode(in_child(write)) == 3
    assert _found_journal(tmp_path) == OLD
    assert only_whole_files(tmp_path)


def test_the_text_is_synced_before_it_has_its_name_and_the_folder_then(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    calls = calls_of(KINDS["journal"], tmp_path, monkeypatch)
    assert [name for name in calls if name in ("write", "fsync", "replace")] == [
        "write", "fsync", "replace", "fsync",
    ]  # fmt: skip


@pytest.fixture(params=[".tmp", "-0a1b2c3d.tmp"])
def left(request: pytest.FixtureRequest, tmp_path: Path) -> Iterator[Path]:
    file = tmp_path / f".a.journal.{2**22 + 7}{request.param}"
    file.write_text("half")
    yield file


def test_what_a_process_that_has_ended_left_is_swept(left: Path) -> None:
    mine = left.with_name(f".b.journal.{private_files.process_mark()}.tmp")
    mine.touch()
    assert kept_texts(left.parent) == []
    assert not left.exists()
    assert mine.exists()


# Where what is written goes.


@pytest.mark.parametrize("name", KINDS)
def test_only_the_user_can_read_what_is_kept(name: str, tmp_path: Path) -> None:
    folder = tmp_path / "state" / "plastron"
    folder.mkdir(parents=True, mode=0o777)
    folder.chmod(0o777)
    KINDS[name].write(folder / "made", OLD)
    KINDS[name].write(folder, OLD)
    assert [stat.S_IMODE(path.stat().st_mode) for path in (folder, folder / "made")] == [0o700] * 2
    for file in (*folder.glob("*.*"), *(folder / "made").iterdir()):
        assert stat.S_IMODE(file.stat().st_mode) == 0o600


def test_a_link_in_the_place_of_what_is_kept_leads_nowhere(tmp_path: Path) -> None:
    target = tmp_path / "target"
    target.write_text("precious")
    folder = tmp_path / "state"
    folder.mkdir()
    journal = Journal(folder, None)
    mark = private_files.process_mark()
    for name in (journal.file.name, f".{journal.file.name}.{mark}.tmp"):
        (folder / name).symlink_to(target)
    assert journal.write(b"typed", 0) is None
    assert target.read_text() == "precious"
    assert not journal.file.is_symlink()
    assert [kept.text for kept in kept_texts(folder)] == [b"typed"]


@pytest.mark.parametrize("name", KINDS)
@pytest.mark.parametrize("has_link", [False, True])
def test_a_folder_of_another_user_is_not_used(
    name: str, has_link: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = tmp_path / "state"
    (tmp_path / "theirs").mkdir(mode=0o777)
    if has_link:
        folder.symlink_to(tmp_path / "theirs")
    else:
        folder.mkdir()
    with monkeypatch.context() as patch:
        patch.setattr(os, "geteuid", lambda: os.getuid() + 1)
        KINDS[name].write(folder, OLD)
    assert list(folder.iterdir()) == []


def test_a_folder_that_somebody_makes_meanwhile_is_not_used(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder, lexists = tmp_path / "plastron" / "journal", os.path.lexists
    with monkeypatch.context() as patch:
        patch.setattr(os, "geteuid", lambda: os.getuid() + 1)
        patch.setattr(os.path, "lexists", lambda path: lexists(path) or folder.mkdir(parents=True))
        error = _write_journal(folder, OLD)
    assert isinstance(error, PermissionError)
    assert list(folder.iterdir()) == []


def _link(file: Path, text: bytes) -> None:
    file.with_name("elsewhere").write_bytes(text)
    file.symlink_to("elsewhere")


def _fifo(file: Path, text: bytes) -> None:
    os.mkfifo(file)


def _foreign(file: Path, text: bytes) -> None:
    file.write_bytes(text)


def _huge(file: Path, text: bytes) -> None:
    file.write_bytes(text)
    os.truncate(file, 2**40)


def _zeros(file: Path, text: bytes) -> None:
    file.symlink_to("/dev/zero")


@pytest.mark.parametrize("make", [_link, _fifo, _foreign, _huge, _zeros])
def test_what_the_studio_did_not_write_is_left_out(
    make: Callable[[Path, bytes], None], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = tmp_path / "state"
    _write_journal(folder, OLD)
    save_remembered(folder, Remembered(theme="nord"))
    for file in list(folder.iterdir()):
        text = file.read_bytes()
        file.unlink()
        make(file, text)
    if make is _foreign:
        monkeypatch.setattr(os, "geteuid", lambda: os.getuid() + 1)
    assert kept_texts(folder) == []
    assert load_remembered(folder) == Remembered()
