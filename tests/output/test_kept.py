"""What belongs to a file beside its text: whether it may be written, attributes, other names."""

from __future__ import annotations

import os
import stat
from pathlib import Path

import pytest

from plastron_tui.diagnostics import has_errors
from plastron_tui.output import file_calls, transaction
from plastron_tui.output.manifest import Manifest
from plastron_tui.output.plan import OutputFile, make_plan
from plastron_tui.output.writer import write
from plastron_tui.studio.files import open_file, save_file

FILES = [OutputFile("a.py", b"new", merged_from=b"old")]


@pytest.fixture
def file(tmp_path: Path) -> Path:
    path = tmp_path / "a.py"
    path.write_bytes(b"old")
    return path


@pytest.mark.parametrize("mode", [0o444, 0o555, 0o400])
def test_a_read_only_file_is_refused_whoever_asks(file: Path, mode: int) -> None:
    file.chmod(mode)
    for merged_from in (b"old", None):
        wanted = [OutputFile("a.py", b"new", merged_from=merged_from)]
        plan, (found,) = make_plan(file.parent, wanted, Manifest())
        assert (plan.files, found.code) == ((), "cannot-write")
        assert "it is read-only" in found.message
    assert make_plan(file.parent, [OutputFile("a.py", b"old")], Manifest())[1] == ()
    saved = save_file(file, b"new", open_file(file).disk)
    assert saved.problem is not None
    assert "it is read-only" in saved.problem.message
    assert (file.read_bytes(), stat.S_IMODE(file.stat().st_mode)) == (b"old", mode)


def test_a_read_only_manifest_is_not_replaced(tmp_path: Path, plan) -> None:
    write(plan(tmp_path, [OutputFile("a.py", b"x")]))
    (tmp_path / ".plastron.json").chmod(0o444)
    (found,) = write(plan(tmp_path, [OutputFile("b.py", b"x")])).diagnostics
    assert (found.code, "it is read-only" in found.message) == ("cannot-write", True)
    assert not (tmp_path / "b.py").exists()


def test_other_names_of_a_file_are_told_of(file: Path, plan) -> None:
    os.link(file, file.with_name("other.py"))
    result = write(plan(file.parent, FILES))
    (found,) = result.diagnostics
    assert (found.code, found.severity.value) == ("not-kept", "warning")
    assert (file.read_bytes(), file.with_name("other.py").read_bytes()) == (b"new", b"old")
    assert len(result.written) == 1


def test_saving_tells_of_other_names_and_saves(file: Path) -> None:
    os.link(file, file.with_name("other.py"))
    saved = save_file(file, b"new", open_file(file).disk)
    assert saved.disk is not None
    assert saved.problem is not None
    assert "hard link" in saved.problem.message


@pytest.mark.parametrize("has_links", [True, False])
def test_extended_attributes_come_along(
    file: Path, plan, monkeypatch, has_links: bool, attributes: dict[tuple[str, str], bytes]
) -> None:
    os.setxattr(file, "user.note", b"mine")
    if not has_links:
        monkeypatch.setattr(os, "link", refuse)
    assert write(plan(file.parent, FILES)).diagnostics == ()
    assert os.getxattr(file, "user.note") == b"mine"
    assert write(plan(file.parent, [OutputFile("a.py", b"x")]), force=True).diagnostics == ()
    assert os.getxattr(file.with_name("a.py.bak"), "user.note") == b"mine"


def test_an_attribute_that_cannot_come_along_is_told_of(file: Path, plan, monkeypatch) -> None:
    monkeypatch.setattr(os, "listxattr", lambda *_, **__: ["security.mine"])
    monkeypatch.setattr(os, "getxattr", lambda *_, **__: b"x")
    monkeypatch.setattr(os, "setxattr", refuse)
    assert write(plan(file.parent, FILES)).diagnostics == ()  # the kernel has set it itself
    values = iter([b"x", b"another"])
    monkeypatch.setattr(os, "getxattr", lambda *_, **__: next(values))
    again = [OutputFile("a.py", b"newer", merged_from=b"new")]
    result = write(plan(file.parent, again))
    assert [found.code for found in result.diagnostics] == ["not-kept"]
    assert "security.mine" in result.diagnostics[0].message
    assert not has_errors(result.diagnostics)


@pytest.mark.parametrize("lost", [["owner"], ["owner", "group"]])
def test_an_owner_that_cannot_be_kept_is_told_of(
    file: Path, plan, monkeypatch, lost: list[str]
) -> None:
    """The group is kept where only the owner cannot be, and no bit lends another's rights."""
    file.chmod(0o6775)
    wanted = plan(file.parent, FILES)
    real, group = os.fstat, file.stat().st_gid

    def change(descriptor: int, owner: int, group: int) -> None:
        if owner != -1 or "group" in lost:
            refuse()

    def theirs(descriptor: int) -> os.stat_result:
        status = real(descriptor)
        of_group = group + 1 if "group" in lost else group
        return os.stat_result((*status[:4], status.st_uid + 1, of_group, *status[6:]))

    monkeypatch.setattr(file_calls.os, "fchown", change)
    monkeypatch.setattr(file_calls.os, "fstat", theirs)
    descriptor = os.open(file.with_name("b.py"), os.O_WRONLY | os.O_CREAT)
    told = file_calls.take_after(descriptor, os.fspath(file), file.stat(), is_executable=False)
    monkeypatch.undo()
    os.close(descriptor)
    assert told == lost
    assert stat.S_IMODE(file.with_name("b.py").stat().st_mode) == 0o775
    monkeypatch.setattr(transaction, "take_after", lambda *_, **__: told)
    result = write(wanted)
    assert [found.message for found in result.diagnostics] == [
        f"`a.py` lost its {name}" for name in lost
    ]


def test_a_private_file_is_read_by_nobody_while_it_is_replaced(
    file: Path, plan, monkeypatch
) -> None:
    file.chmod(0o600)
    modes = []
    real = file_calls.take_after

    def look(descriptor: int, *arguments: object, **named: object) -> list[str]:
        modes.append(stat.S_IMODE(os.fstat(descriptor).st_mode))
        return real(descriptor, *arguments, **named)

    monkeypatch.setattr(transaction, "take_after", look)
    assert write(plan(file.parent, FILES)).diagnostics == ()
    assert modes == [0o600]
    assert stat.S_IMODE(file.stat().st_mode) == 0o600


def refuse(*_: object) -> None:
    raise PermissionError(1, "Operation not permitted")


@pytest.fixture
def attributes(file: Path, monkeypatch) -> dict[tuple[str, str], bytes]:
    """Extended attributes: those of the file system, or where it has none, kept by inode."""
    kept: dict[tuple[int, str], bytes] = {}
    try:
        os.setxattr(file, "user.probe", b"")
        os.removexattr(file, "user.probe")
    except OSError:

        def inode(file: object) -> int:
            return os.stat(file).st_ino

        def set_(file: object, name: str, value: bytes) -> None:
            kept[inode(file), name] = value

        monkeypatch.setattr(os, "setxattr", set_)
        monkeypatch.setattr(os, "getxattr", lambda file, name, **_: kept[inode(file), name])
        monkeypatch.setattr(
            os, "listxattr", lambda file, **_: [n for at, n in kept if at == inode(file)]
        )
    return kept


def test_an_access_list_is_one_with_the_mode(file: Path, monkeypatch) -> None:
    """The mode is set last: what a list of attributes says of it must not undo the new bit."""
    calls: list[str] = []
    monkeypatch.setattr(os, "listxattr", lambda *_, **__: ["system.posix_acl_access"])
    monkeypatch.setattr(os, "getxattr", lambda *_, **__: b"")
    monkeypatch.setattr(os, "setxattr", lambda *_, **__: calls.append("attributes"))
    monkeypatch.setattr(os, "fchmod", lambda *_: calls.append("mode"))
    descriptor = os.open(file, os.O_RDONLY)
    file_calls.take_after(descriptor, os.fspath(file), file.stat(), is_executable=True)
    os.close(descriptor)
    assert calls == ["attributes", "mode"]
