"""What the next run finds after a crash: a journal, temporary files, texts that changed since."""

from __future__ import annotations

import errno
import json
import os
from collections.abc import Callable, Sequence
from pathlib import Path

import pytest

from plastron_tui.output.file_calls import digest_of
from plastron_tui.output.journal import Entry, Journal, journal_text
from plastron_tui.output.manifest import NAME, digest, load_manifest
from plastron_tui.output.own_files import JOURNAL
from plastron_tui.output.plan import FilePlan, OutputFile
from plastron_tui.output.recovery import settle
from plastron_tui.output.writer import write

Planning = Callable[[Path, Sequence[OutputFile]], FilePlan]

OLD = {"a.py": "old a", "b.py": "old b", "c.py": "old c"}
NEW = {"a.py": "new a", "b.py": "new b", "c.py": "new c"}


class Killed(BaseException):
    """Stands for the end of the process."""


def outputs(texts: dict[str, str]) -> list[OutputFile]:
    return [OutputFile(name, text.encode(), False) for name, text in texts.items()]


def texts(folder: Path) -> dict[str, str]:
    return {path.name: path.read_text() for path in sorted(folder.iterdir()) if path.name != NAME}


@pytest.fixture
def crashed(tmp_path: Path, plan: Planning, monkeypatch) -> Callable[[int], Path]:
    """Make a folder where the process was killed when it had replaced some of four files."""

    def make(replaced: int, below: str = "output") -> Path:
        folder = tmp_path / below
        assert write(plan(folder, outputs(OLD))).diagnostics == ()
        child = os.fork()
        if child:
            os.waitpid(child, 0)
            return folder
        real, count = os.replace, 0

        def replace(source: str, target: str) -> None:
            nonlocal count
            if count == replaced:
                os._exit(0)
            count += 1
            real(source, target)

        os.replace = replace
        write(plan(folder, outputs(NEW)))
        os._exit(1)

    return make


def manifest_is_of(folder: Path, known: dict[str, str]) -> bool:
    return load_manifest(folder)[0].digests == {
        name: digest(text.encode()) for name, text in known.items()
    }


@pytest.mark.parametrize("replaced", range(4))
def test_what_was_decided_is_finished(crashed, replaced: int) -> None:
    folder = crashed(replaced)
    assert (folder / JOURNAL).exists()
    (found,) = settle(folder)
    assert found.message.startswith("a write that was interrupted was finished: ")
    names = [*NEW, NAME][replaced:]
    assert [name for name in (*NEW, NAME) if f"`{name}`" in found.message] == names
    assert texts(folder) == NEW
    assert manifest_is_of(folder, NEW)


def test_an_edit_of_what_was_not_yet_replaced_takes_all_back(crashed) -> None:
    folder = crashed(1)
    (folder / "b.py").write_text("old b, by hand")
    (found,) = settle(folder)
    assert found.message == "a write that was interrupted was taken back: `a.py`"
    assert texts(folder) == {**OLD, "b.py": "old b, by hand"}
    assert manifest_is_of(folder, OLD)


def test_an_edit_of_what_was_replaced_goes_forward(crashed) -> None:
    folder = crashed(1)
    (folder / "a.py").write_text("new a, by hand")
    assert [each.code for each in settle(folder)] == ["interrupted-write"]
    assert texts(folder) == {**NEW, "a.py": "new a, by hand"}
    assert manifest_is_of(folder, NEW)


def test_edits_of_both_stay_and_are_told(crashed) -> None:
    folder = crashed(1)
    (folder / "a.py").write_text("new a, by hand")
    (folder / "b.py").write_text("old b, by hand")
    found, finished = settle(folder)
    assert (found.code, found.file) == ("interrupted-write", folder / "b.py")
    assert "`c.py`" in finished.message
    assert texts(folder) == {"a.py": "new a, by hand", "b.py": "old b, by hand", "c.py": "new c"}
    assert settle(folder) == ()


def test_what_version_control_put_back_takes_the_rest_back(crashed) -> None:
    folder = crashed(2)
    for name in ("a.py", "b.py"):
        (folder / name).write_text(OLD[name])
    assert settle(folder) == ()
    assert texts(folder) == OLD
    assert manifest_is_of(folder, OLD)


def test_a_writer_finishes_first(crashed, plan: Planning) -> None:
    folder = crashed(2)
    made = plan(folder, outputs({"d.py": "d"}))
    assert "was finished" in write(made).diagnostics[0].message
    assert texts(folder) == {**NEW, "d.py": "d"}


def test_a_copy_of_a_folder_is_not_its_journals(crashed, tmp_path: Path) -> None:
    folder = crashed(1)
    copy = tmp_path / "copy"
    copy.mkdir()
    for path in folder.iterdir():
        (copy / path.name).write_bytes(path.read_bytes())
    before = texts(copy)
    found = settle(copy)
    assert {one.code for one in found} <= {"interrupted-write", "leftover-file"}
    assert "it is of another folder" in found[0].message
    assert {name: before[name] for name in NEW} == {name: texts(copy)[name] for name in NEW}


def test_a_read_only_folder_is_told_of(crashed, monkeypatch) -> None:
    folder = crashed(1)

    def refuse(*_: object) -> None:
        raise OSError(errno.EROFS, "Read-only file system")

    with monkeypatch.context() as patch:
        for name in ("replace", "rename", "unlink", "link"):
            patch.setattr(os, name, refuse)
        (found,) = settle(folder)
    assert (found.code, found.severity.value) == ("interrupted-write", "warning")
    assert "read-only file system" in found.message
    assert "was finished" in settle(folder)[0].message
    assert texts(folder) == NEW


def hostile(folder: Path, entry: Entry, changes: dict[str, object] | None = None) -> None:
    """Lay a journal into a folder, as its owner could."""
    data = json.loads(journal_text(Journal("0" * 32, (entry,)), os.fspath(folder)))
    changes = dict(changes or {})
    data["files"][0].update(changes.pop("file", {}))
    (folder / JOURNAL).write_text(json.dumps({**data, **changes}))


@pytest.mark.parametrize(
    "name",
    [
        *("../victim.py", "/etc/victim.py", "", ".", "..", "a\0b", ".plastron-journal"),
        *(5, True, None, 1.5, [], ["victim.py"], {}, {"a": 1}),
    ],
    ids=str,
)
@pytest.mark.parametrize("key", ["name", "backup", "others", "decided_by"])
def test_a_journal_names_nothing_outside(tmp_path: Path, key: str, name: object) -> None:
    folder = tmp_path / "output"
    folder.mkdir()
    victim = tmp_path / "victim.py"
    victim.write_text("mine")
    (folder / ".plastron-0.new").write_text("evil")
    changes = {"others": [name], "decided_by": name}
    change = {key: changes[key]} if key in changes else {"file": {key: name}}
    hostile(folder, Entry("victim.py", digest(b"mine"), digest(b"evil")), change)
    found = settle(folder)
    assert {each.code for each in found} <= {"interrupted-write"}
    assert found or key in changes or name is None
    assert victim.read_text() == "mine"


@pytest.mark.parametrize(
    "changes",
    [
        {"file": {"before": digest(b"another")}},
        {"file": {"after": digest(b"another")}},
        {"folder": 1},
        {"others": ["../other\0"]},
        {"decided_by": "../other"},
        {"write": "x"},
        {"files": 7},
        {"version": 2},
    ],
    ids=str,
)
def test_a_journal_replaces_only_what_its_digests_say(tmp_path: Path, changes) -> None:
    (tmp_path / "a.py").write_text("mine")
    (tmp_path / ".plastron-0.new").write_text("evil")
    hostile(tmp_path, Entry("a.py", digest(b"mine"), digest(b"evil")), changes)
    settle(tmp_path)
    assert (tmp_path / "a.py").read_text() == "mine"


@pytest.mark.parametrize("link", ["a.py", ".plastron-0.new", JOURNAL])
def test_a_journal_leads_through_no_link(tmp_path: Path, link: str) -> None:
    folder = tmp_path / "output"
    folder.mkdir()
    (folder / "a.py").write_text("mine")
    (folder / ".plastron-0.new").write_text("evil")
    hostile(folder, Entry("a.py", digest(b"mine"), digest(b"evil")))
    outside = tmp_path / "outside"
    os.replace(folder / link, outside)
    (folder / link).symlink_to(outside)
    before = outside.read_bytes()
    settle(folder)
    assert outside.read_bytes() == before
    assert (folder / "a.py").read_text() in ("mine",)


def test_a_journal_in_another_folder_counts_only_with_one_here(tmp_path: Path) -> None:
    """Who can write to one folder does not get to another by naming it."""
    theirs, mine = tmp_path / "theirs", tmp_path / "mine"
    theirs.mkdir()
    mine.mkdir()
    for folder in (theirs, mine):
        (folder / "a.py").write_text("mine")
        (folder / ".plastron-0.new").write_text("evil")
    hostile(theirs, Entry("a.py", digest(b"mine"), digest(b"evil")), {"others": ["../mine"]})
    assert [found.file for found in settle(theirs)] == [theirs / "a.py"]
    assert (mine / "a.py").read_text() == "mine"
    assert (mine / ".plastron-0.new").exists()


@pytest.mark.parametrize("kind", ["fifo", "folder", "endless", "huge"])
def test_a_journal_that_is_no_file(tmp_path: Path, plan: Planning, kind: str) -> None:
    path = tmp_path / JOURNAL
    if kind == "fifo":
        os.mkfifo(path)
    elif kind == "folder":
        path.mkdir()
    elif kind == "endless":
        path.symlink_to("/dev/zero")
    else:
        path.touch()
        os.truncate(path, 10 * 1024**3)
    (found,) = settle(tmp_path)
    assert found.code == "interrupted-write"


def test_leftovers_of_a_killed_process_are_swept(tmp_path: Path, plan: Planning) -> None:
    write(plan(tmp_path, outputs(OLD)))
    for name in (".plastron-0.new", ".plastron-17.new", ".plastron-1.tmp", ".plastron-journal.new"):
        (tmp_path / name).write_bytes(b"half a te")
    os.link(tmp_path / "a.py", tmp_path / ".plastron-0.old")
    (tmp_path / ".plastron-1.old").write_text("old b")
    kept = {".plastron-notes.txt": "mine", "x.plastron-0.new": "mine"}
    for name, text in kept.items():
        (tmp_path / name).write_text(text)
    assert settle(tmp_path) == ()
    assert texts(tmp_path) == {**OLD, **kept}


def test_the_last_copy_of_a_text_is_kept_and_told(tmp_path: Path, plan: Planning) -> None:
    write(plan(tmp_path, outputs(OLD)))
    (tmp_path / ".plastron-3.old").write_text("somebody's")
    (found,) = write(plan(tmp_path, outputs(NEW))).diagnostics
    assert (found.code, found.severity.value) == ("leftover-file", "warning")
    assert texts(tmp_path) == {**NEW, ".plastron-kept": "somebody's"}
    assert write(plan(tmp_path, outputs(OLD))).diagnostics == ()


def test_a_failed_unlink_is_told_and_tried_again(tmp_path: Path, plan, monkeypatch) -> None:
    write(plan(tmp_path, outputs(OLD)))

    def refuse(*_: object) -> None:
        raise PermissionError(errno.EPERM, "Operation not permitted")

    with monkeypatch.context() as patch:
        patch.setattr(os, "unlink", refuse)
        found = write(plan(tmp_path, outputs(NEW))).diagnostics
    assert {one.code for one in found} == {"leftover-file"}
    assert "operation not permitted" in found[0].message
    assert settle(tmp_path) == ()
    assert texts(tmp_path) == NEW


@pytest.mark.parametrize("refused", ["every unlink", "every unlink and rename", "the last unlink"])
def test_what_was_reported_as_done_is_not_taken_back(
    tmp_path: Path, plan, monkeypatch, refused: str
) -> None:
    write(plan(tmp_path, outputs(OLD)))
    real_unlink, real_rename = os.unlink, os.rename

    def unlink(path: str, **named: int) -> None:
        if refused != "the last unlink" or path.endswith(JOURNAL):
            raise PermissionError(errno.EPERM, "Operation not permitted")
        real_unlink(path, **named)

    def rename(source: str, target: str) -> None:
        if (tmp_path / JOURNAL).exists() and refused == "every unlink and rename":
            # Then nothing but removing the journal is left; see `unlink`.
            patch.setattr(os, "unlink", real_unlink)
            raise PermissionError(errno.EPERM, "Operation not permitted")
        real_rename(source, target)

    with monkeypatch.context() as patch:
        patch.setattr(os, "unlink", unlink)
        patch.setattr(os, "rename", rename)
        result = write(plan(tmp_path, outputs(NEW)))
    assert len(result.written) == len(NEW)
    assert {each.code for each in result.diagnostics} == {"leftover-file"}
    (tmp_path / "a.py").write_text(OLD["a.py"])
    settle(tmp_path)
    kept = {name: text for name, text in texts(tmp_path).items() if "kept" not in name}
    assert kept == {**NEW, "a.py": OLD["a.py"]} or refused == "every unlink and rename"
    assert {name: kept[name] for name in ("b.py", "c.py")} == {
        name: NEW[name] for name in ("b.py", "c.py")
    }


def test_who_writes_just_now_is_left_alone(tmp_path: Path, plan: Planning, monkeypatch) -> None:
    """A reader that comes between two renames waits, and then finds nothing to do."""
    folder = tmp_path / "output"
    write(plan(folder, outputs(OLD)))
    real, seen = os.replace, []

    def replace(source: str, target: str) -> None:
        real(source, target)
        child = os.fork()
        if not child:
            from plastron_tui.output import locks

            locks.LOCK_SECONDS = 0.0
            os._exit(len(settle(folder)))
        seen.append(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))

    with monkeypatch.context() as patch:
        patch.setattr(os, "replace", replace)
        assert write(plan(folder, outputs(NEW))).diagnostics == ()
    assert seen == [1] * 4
    assert texts(folder) == NEW


def test_a_digest_is_of_regular_files_only(tmp_path: Path) -> None:
    (tmp_path / "link").symlink_to("/dev/zero")
    os.mkfifo(tmp_path / "fifo")
    found = {digest_of(os.fspath(tmp_path / name)) for name in ("link", "fifo", ".")}
    assert found == {"unknown"}
    assert digest_of(os.fspath(tmp_path / "none")) is None
