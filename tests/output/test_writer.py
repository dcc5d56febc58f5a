from __future__ import annotations

import fcntl
import os
import stat
import subprocess
import sys
import threading
from pathlib import Path

import pytest

from plastron_tui.output import locks
from plastron_tui.output.manifest import NAME, load_manifest
from plastron_tui.output.plan import OutputFile
from plastron_tui.output.writer import write


def mode(path: Path) -> int:
    return stat.S_IMODE(path.stat().st_mode)


def names(folder: Path) -> set[str]:
    return {path.name for path in folder.iterdir()}


def test_new_files_in_a_new_folder(tmp_path: Path, plan) -> None:
    folder = tmp_path / "deep" / "output"
    files = [OutputFile("a.py", b"\xff\r\n\0"), OutputFile("notes.txt", b"", False)]
    result = write(plan(folder, files))
    assert result.diagnostics == ()
    assert [written.file.name for written in result.written] == ["a.py", "notes.txt"]
    assert names(folder) == {"a.py", "notes.txt", NAME}
    assert (folder / "a.py").read_bytes() == b"\xff\r\n\0"
    assert (mode(folder / "a.py"), mode(folder / "notes.txt")) == (0o755, 0o644)


def test_no_files_make_no_folder(tmp_path: Path, plan) -> None:
    assert write(plan(tmp_path / "output", [])) == ((), ())
    assert names(tmp_path) == set()


def test_the_umask_is_respected(tmp_path: Path, plan) -> None:
    os.umask(0o077)
    write(plan(tmp_path / "output", [OutputFile("a.py", b"")]))
    assert mode(tmp_path / "output" / "a.py") == 0o700


@pytest.mark.parametrize(
    ("before", "is_executable", "after"),
    [
        *((0o644, True, 0o755), (0o640, True, 0o750), (0o600, True, 0o700), (0o744, True, 0o744)),
        *((0o664, False, 0o664), (0o755, False, 0o755), (0o600, False, 0o600)),
    ],
)
def test_an_existing_file_keeps_its_mode(
    tmp_path: Path, plan, before: int, is_executable: bool, after: int
) -> None:
    path = tmp_path / "a.py"
    path.write_bytes(b"old")
    path.chmod(before)
    write(plan(tmp_path, [OutputFile("a.py", b"#!new", is_executable, b"old")]))
    assert (path.read_bytes(), mode(path)) == (b"#!new", after)


@pytest.mark.parametrize("before", [0o644, 0o755])
def test_what_no_kernel_can_run_does_not_get_the_bit(tmp_path: Path, plan, before: int) -> None:
    path = tmp_path / "a.py"
    path.write_bytes(b"old")
    path.chmod(before)
    write(plan(tmp_path, [OutputFile("a.py", b"import rospy", True, b"old")]))
    assert (path.read_bytes(), mode(path)) == (b"import rospy", before)


def test_an_identical_file_is_not_touched(tmp_path: Path, plan) -> None:
    files = [OutputFile("a.py", b"x")]
    write(plan(tmp_path, files))
    before = (tmp_path / "a.py").stat(), (tmp_path / NAME).stat()
    assert write(plan(tmp_path, files)) == ((), ())
    assert ((tmp_path / "a.py").stat(), (tmp_path / NAME).stat()) == before


def test_a_missing_bit_is_mended(tmp_path: Path, plan) -> None:
    files = [OutputFile("a.py", b"#!x")]
    write(plan(tmp_path, files))
    (tmp_path / "a.py").chmod(0o644)
    assert len(write(plan(tmp_path, files)).written) == 1
    assert mode(tmp_path / "a.py") == 0o755


def test_a_conflict_is_left_alone_and_the_others_are_written(tmp_path: Path, plan) -> None:
    (tmp_path / "a.py").write_bytes(b"by hand")
    result = write(plan(tmp_path, [OutputFile("a.py", b"x"), OutputFile("b.py", b"y")]))
    assert [diagnostic.code for diagnostic in result.diagnostics] == ["file-conflict"]
    assert [written.file.name for written in result.written] == ["b.py"]
    assert (tmp_path / "a.py").read_bytes() == b"by hand"
    assert load_manifest(tmp_path)[0].digests.keys() == {"b.py"}


@pytest.mark.parametrize("has_links", [True, False])
def test_force_never_overwrites_a_backup(tmp_path: Path, plan, monkeypatch, has_links) -> None:
    if not has_links:
        monkeypatch.setattr(os, "link", no_links)
    path = tmp_path / "a.py"
    for number, suffix in enumerate([".bak", ".bak1", ".bak2"]):
        path.write_bytes(b"by hand %d" % number)
        path.chmod(0o640)
        result = write(plan(tmp_path, [OutputFile("a.py", b"x")]), force=True)
        assert result.diagnostics == ()
        backup = tmp_path / f"a.py{suffix}"
        assert result.written[0].backup == backup
        assert (backup.read_bytes(), mode(backup)) == (b"by hand %d" % number, 0o640)
        assert path.read_bytes() == b"x"
    assert names(tmp_path) == {"a.py", "a.py.bak", "a.py.bak1", "a.py.bak2", NAME}
    assert (tmp_path / "a.py.bak").read_bytes() == b"by hand 0"


def no_links(*_: object) -> None:
    raise PermissionError(1, "Operation not permitted")


def test_what_is_ours_gets_no_backup(tmp_path: Path, plan) -> None:
    write(plan(tmp_path, [OutputFile("a.py", b"x")]))
    result = write(plan(tmp_path, [OutputFile("a.py", b"y")]), force=True)
    assert result.written[0].backup is None
    assert names(tmp_path) == {"a.py", NAME}


def test_a_link_inside_the_folder_stays_a_link(tmp_path: Path, plan) -> None:
    (tmp_path / "real.py").write_bytes(b"old")
    (tmp_path / "a.py").symlink_to("real.py")
    write(plan(tmp_path, [OutputFile("a.py", b"new", True, b"old")]))
    assert (tmp_path / "a.py").is_symlink()
    assert (tmp_path / "real.py").read_bytes() == b"new"


def test_in_place_writes_beside_no_manifest(tmp_path: Path, plan) -> None:
    source = tmp_path / "src" / "a.py"
    source.parent.mkdir()
    source.write_bytes(b"old")
    result = write(plan(tmp_path / "output", [OutputFile("a.py", b"new", True, b"old", source)]))
    assert result.diagnostics == ()
    assert source.read_bytes() == b"new"
    assert names(tmp_path) == {"src"}
    assert names(source.parent) == {"a.py"}


def test_a_disk_that_moved_on_since_the_plan(tmp_path: Path, plan, snapshot) -> None:
    files = [OutputFile("a.py", b"x"), OutputFile("b.py", b"y")]
    made = plan(tmp_path, files)
    (tmp_path / "b.py").write_bytes(b"somebody was faster")
    before = snapshot(tmp_path)
    result = write(made, force=True)
    assert [diagnostic.code for diagnostic in result.diagnostics] == ["changed-on-disk"]
    assert (result.written, snapshot(tmp_path)) == ((), before)


def test_a_link_that_appears_after_the_plan_is_not_followed(tmp_path: Path, plan) -> None:
    victim = tmp_path / "victim.py"
    victim.write_bytes(b"mine")
    made = plan(tmp_path / "output", [OutputFile("a.py", b"x")])
    (tmp_path / "output").mkdir()
    (tmp_path / "output" / "a.py").symlink_to(victim)
    result = write(made)
    assert [diagnostic.code for diagnostic in result.diagnostics] == ["changed-on-disk"]
    assert victim.read_bytes() == b"mine"


def test_a_folder_that_becomes_another_after_the_plan_gets_nothing(tmp_path: Path, plan) -> None:
    for name in ("real", "other"):
        (tmp_path / name).mkdir()
    (tmp_path / "out").symlink_to("real")
    made = plan(tmp_path / "out", [OutputFile("a.py", b"1\n")])
    (tmp_path / "out").unlink()
    (tmp_path / "out").symlink_to("other")
    write(made)
    assert sorted(path.name for path in (tmp_path / "real").iterdir()) == [NAME, "a.py"]
    assert not list((tmp_path / "other").iterdir())


def test_another_process_that_wrote_the_same_is_no_mistake(tmp_path: Path, plan) -> None:
    files = [OutputFile("a.py", b"x"), OutputFile("b.py", b"y")]
    first, second = plan(tmp_path, files), plan(tmp_path, files)
    assert len(write(first).written) == 2
    assert write(second) == ((), ())


def test_a_touched_file_is_still_the_same(tmp_path: Path, plan) -> None:
    write(plan(tmp_path, [OutputFile("a.py", b"x")]))
    made = plan(tmp_path, [OutputFile("a.py", b"y")])
    os.utime(tmp_path / "a.py", ns=(0, 0))
    assert write(made).diagnostics == ()
    assert (tmp_path / "a.py").read_bytes() == b"y"


def test_a_lock_that_is_not_given_back(tmp_path: Path, plan, snapshot, monkeypatch) -> None:
    monkeypatch.setattr(locks, "LOCK_SECONDS", 0.05)
    descriptor = os.open(tmp_path, os.O_RDONLY)
    fcntl.flock(descriptor, fcntl.LOCK_EX)
    made = plan(tmp_path, [OutputFile("a.py", b"x")])
    before = snapshot(tmp_path)
    result = write(made)
    assert [diagnostic.code for diagnostic in result.diagnostics] == ["cannot-write"]
    assert snapshot(tmp_path) == before
    os.close(descriptor)
    assert write(made).diagnostics == ()


@pytest.mark.parametrize("is_made_anew", [False, True])
def test_a_folder_that_goes_while_its_lock_is_waited_for(
    tmp_path: Path, plan, monkeypatch, *, is_made_anew: bool
) -> None:
    """Who made it and failed takes it back; a lock on what is gone keeps nobody out."""
    folder = tmp_path / "output"
    folder.mkdir()
    held = os.open(folder, os.O_RDONLY)
    fcntl.flock(held, fcntl.LOCK_EX)
    made = plan(folder, [OutputFile("a.py", b"x")])
    other = []

    def give_back(_: float) -> None:
        if not other:
            os.rename(folder, tmp_path / "gone")
            other.append(held)
            if is_made_anew:
                folder.mkdir()
                other.append(os.open(folder, os.O_RDONLY))
                fcntl.flock(other[1], fcntl.LOCK_EX)
            os.close(held)
        elif len(other) == 2:
            assert not (folder / ".plastron-0.new").exists()
            os.close(other.pop())

    monkeypatch.setattr(locks.time, "sleep", give_back)
    assert write(made).diagnostics == ()
    assert (folder / "a.py").read_bytes() == b"x"
    assert list((tmp_path / "gone").iterdir()) == []
    assert len(other) == 1


_WRITER = """
import sys
from pathlib import Path
from plastron_tui.output.manifest import load_manifest
from plastron_tui.output.plan import OutputFile, make_plan
from plastron_tui.output.writer import write
folder, letter = Path(sys.argv[1]), sys.argv[2]
for number in range(20):
    files = [OutputFile(f"{letter}{number}.py", b"x"), OutputFile("both.py", b"x")]
    plan, diagnostics = make_plan(folder, files, load_manifest(folder)[0])
    diagnostics += write(plan).diagnostics
    assert diagnostics == (), diagnostics
"""


def test_two_processes_at_once_forget_nothing(tmp_path: Path) -> None:
    folder = tmp_path / "output"
    processes = [
        subprocess.Popen([sys.executable, "-c", _WRITER, str(folder), letter]) for letter in "ab"
    ]
    assert [process.wait() for process in processes] == [0, 0]
    wanted = {f"{letter}{number}.py" for letter in "ab" for number in range(20)} | {"both.py"}
    assert names(folder) == wanted | {NAME}
    assert load_manifest(folder)[0].digests.keys() == wanted


def test_in_another_thread(tmp_path: Path, plan) -> None:
    made = plan(tmp_path, [OutputFile("a.py", b"x")])
    results = []
    thread = threading.Thread(target=lambda: results.append(write(made)))
    thread.start()
    thread.join()
    assert len(results[0].written) == 1


def test_few_calls_a_file(tmp_path: Path, plan, monkeypatch) -> None:
    """One sync a file, manifest and journal; two for the folder, one for where it is new."""
    synced: list[int] = []
    real = os.fsync
    monkeypatch.setattr(os, "fsync", lambda fd: (synced.append(fd), real(fd)))
    write(plan(tmp_path / "output", [OutputFile(f"{n}.py", b"x") for n in range(10)]))
    assert len(synced) == 10 + 1 + 1 + 2 + 1
