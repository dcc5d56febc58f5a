"""What the writer reports is what is on the disk, whatever others do in the folder meanwhile."""

from __future__ import annotations

import errno
import fcntl
import os
from collections.abc import Callable
from pathlib import Path

import pytest

from plastron_tui.output.locks import FolderLocks
from plastron_tui.output.own_files import JOURNAL, temporary_kind
from plastron_tui.output.plan import OutputFile
from plastron_tui.output.recovery import settle
from plastron_tui.output.writer import write
from plastron_tui.studio.files import open_file, save_file

OLD = {"a.py": b"old a", "b.py": b"old b"}
NEW = {"a.py": b"new a", "b.py": b"new b"}


def outputs(texts: dict[str, bytes]) -> list[OutputFile]:
    return [OutputFile(name, text, False) for name, text in texts.items()]


def texts(folder: Path) -> dict[str, bytes]:
    return {name: (folder / name).read_bytes() for name in OLD}


def cleaned(folder: Path, *kinds: str | None) -> None:
    """Remove what `git clean` would: files that no repository knows."""
    for path in folder.iterdir():
        kind = "journal" if path.name == JOURNAL else temporary_kind(path.name)
        if kind in kinds:
            path.unlink()


@pytest.fixture
def before_replace(monkeypatch) -> Callable[[int, Callable[[], object]], None]:
    """Let something happen before the nth file is replaced."""

    def arrange(at: int, event: Callable[[], object]) -> None:
        real, count = os.replace, 0

        def replace(source: str, target: str) -> None:
            nonlocal count
            count += 1
            if count == at:
                event()
            real(source, target)

        monkeypatch.setattr(os, "replace", replace)

    return arrange


@pytest.fixture
def no_locks(monkeypatch) -> None:
    def refuse(*_: object) -> None:
        raise OSError(errno.ENOLCK, os.strerror(errno.ENOLCK))

    monkeypatch.setattr(fcntl, "flock", refuse)


@pytest.mark.parametrize("kinds", [("new",), ("new", "old"), ("new", "old", "journal")], ids=str)
@pytest.mark.parametrize("at", [1, 2])
def test_temporary_files_that_vanish(
    tmp_path: Path, plan, before_replace, at: int, kinds: tuple[str, ...]
) -> None:
    write(plan(tmp_path, outputs(OLD)))
    made = plan(tmp_path, outputs(NEW))
    before_replace(at, lambda: cleaned(tmp_path, *kinds))
    result = write(made)
    assert result.written == ()
    assert {found.code for found in result.diagnostics} == {"cannot-write"}
    assert texts(tmp_path) == OLD


def test_new_texts_that_vanish_before_the_journal(tmp_path: Path, plan, monkeypatch) -> None:
    write(plan(tmp_path, outputs(OLD)))
    made = plan(tmp_path, outputs(NEW))
    real = os.link

    def link(path: str, other: str) -> None:
        cleaned(tmp_path, "new")
        real(path, other)

    monkeypatch.setattr(os, "link", link)
    result = write(made)
    assert (result.written, texts(tmp_path)) == ((), OLD)
    assert {found.code for found in result.diagnostics} == {"cannot-write"}


def test_what_was_written_by_hand_is_not_lost_with_its_second_name(
    tmp_path: Path, plan, before_replace
) -> None:
    (tmp_path / "a.py").write_bytes(b"by hand")
    (tmp_path / "b.py").write_bytes(b"by hand, too")
    made = plan(tmp_path, outputs(NEW))
    before_replace(2, lambda: cleaned(tmp_path, "old"))
    result = write(made, force=True)
    kept = {path.read_bytes() for path in tmp_path.iterdir()}
    assert {b"by hand", b"by hand, too"} <= kept
    for each in result.written:
        assert each.backup is None or each.backup.exists()


def test_a_new_text_that_another_one_took_the_place_of(
    tmp_path: Path, plan, before_replace
) -> None:
    write(plan(tmp_path, outputs(OLD)))
    made = plan(tmp_path, outputs(NEW))
    before_replace(1, lambda: (tmp_path / ".plastron-0.new").write_bytes(b"another's"))
    result = write(made)
    assert result.written == ()
    assert [found.code for found in result.diagnostics] == ["changed-on-disk"]
    assert (tmp_path / "b.py").read_bytes() == OLD["b.py"]


@pytest.mark.usefixtures("no_locks")
def test_a_reader_without_locks_touches_nothing(tmp_path: Path, plan, before_replace) -> None:
    write(plan(tmp_path, outputs(OLD)))
    made = plan(tmp_path, outputs(NEW))
    before_replace(2, lambda: settle(tmp_path))
    assert write(made).diagnostics == ()
    assert texts(tmp_path) == NEW


@pytest.mark.usefixtures("no_locks")
def test_saved_without_locks_beside_a_reader(tmp_path: Path, monkeypatch) -> None:
    """At each call that the writer makes, a reader of the same process looks."""
    path = tmp_path / "a.plastron"
    path.write_bytes(b"# 0\n")
    for name in ("fsync", "link", "rename", "replace"):
        real = getattr(os, name)

        def call(*args: object, real: Callable[..., object] = real) -> object:
            settle(tmp_path)
            return real(*args)

        monkeypatch.setattr(os, name, call)
    text = b"create_node 'a' as a\n"
    saved = save_file(path, text, open_file(path).disk)
    assert (saved.problem, path.read_bytes()) == (None, text)


@pytest.mark.usefixtures("no_locks")
def test_without_locks_the_next_write_finishes_first(tmp_path: Path, plan) -> None:
    write(plan(tmp_path, outputs(OLD)))
    child = os.fork()
    if not child:
        os.replace = lambda *_: os._exit(0)
        write(plan(tmp_path, outputs(NEW)))
    os.waitpid(child, 0)
    (found,) = settle(tmp_path)
    assert (found.code, texts(tmp_path)) == ("interrupted-write", OLD)
    assert "no locks" in found.message
    write(plan(tmp_path, outputs({"c.py": b"c"})))
    assert texts(tmp_path) == NEW
    assert settle(tmp_path) == ()


@pytest.mark.usefixtures("no_locks")
def test_locks_say_which_folders_have_none(tmp_path: Path) -> None:
    with FolderLocks() as locks:
        locks.take([os.fspath(tmp_path)])
        assert locks.unlocked == {os.fspath(tmp_path)}
