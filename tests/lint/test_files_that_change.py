"""What `lint` writes into files of any name, and into files that others change meanwhile."""

from __future__ import annotations

import errno
import os
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

import pytest
from linted import run_over, told, write_tree

from plastron_tui.lint.rules import RULES
from plastron_tui.project.linting import rewriting
from plastron_tui.project.linting.rewriting import Changes, Rewrite, mend, note_all, write_baseline
from plastron_tui.project.linting.run import LintRun

BROKEN = RULES["RM203"].bad["driver.py"]
MENDED = RULES["RM203"].good["driver.py"]
NOTED = BROKEN.replace(".x = 1\n", ".x = 1  # noqa: RM203\n")
NAMES = {
    "no_utf_8": b"a\xff.py",
    "backslash": b"a\\b.py",
    "control_characters": b"a\x1b[31m.py",
    "new_line": b"a\nb.py",
    "blank": b" .py",
    "separators": b"a:b,c%0A.py",
}
CHANGES = {"mended": (mend, MENDED), "noted": (note_all, NOTED)}
Change = Callable[[LintRun], Changes]


@pytest.mark.parametrize("name", NAMES.values(), ids=NAMES)
@pytest.mark.parametrize(("change", "after"), CHANGES.values(), ids=CHANGES)
def test_a_file_of_any_name_is_changed(
    tmp_path: Path, name: bytes, change: Change, after: str
) -> None:
    file = tmp_path / os.fsdecode(name)
    file.write_text(BROKEN)
    changes = change(run_over(tmp_path, "RM203"))
    assert (changes.done, changes.files, changes.diagnostics) == (1, 1, ())
    assert file.read_text() == after
    assert [os.fsencode(each.name) for each in tmp_path.iterdir()] == [name]


LINE = "# somebody else wrote this\n"


def _before_writing(monkeypatch: pytest.MonkeyPatch, act: Callable[[], object]) -> None:
    """Let something happen before the first time that files are written."""
    acts, write_all = [act], rewriting.write_all

    def write(rewrites: Iterable[Rewrite]) -> object:
        if acts:
            acts.pop()()
        return write_all(rewrites)

    monkeypatch.setattr(rewriting, "write_all", write)


def test_what_somebody_changes_meanwhile_is_read_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    root = write_tree(tmp_path, {"a.py": BROKEN})
    file = root / "a.py"
    _before_writing(monkeypatch, lambda: file.write_text(BROKEN + LINE))
    changes = mend(run_over(root, "RM203"))
    assert (changes.done, changes.files, changes.diagnostics) == (1, 1, ())
    assert file.read_text() == MENDED + LINE


def test_what_another_one_has_mended_meanwhile_is_done(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    root = write_tree(tmp_path, {"a.py": BROKEN, "b.py": BROKEN})
    _before_writing(monkeypatch, lambda: mend(run_over(root, "RM203")))
    changes = mend(run_over(root, "RM203"))
    assert (changes.done, changes.diagnostics, told(changes.run)) == (0, (), [])
    assert (root / "a.py").read_text() == (root / "b.py").read_text() == MENDED


def test_what_is_changed_over_and_over_is_told_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    root = write_tree(tmp_path, {"a.py": BROKEN})
    file, write_all = root / "a.py", rewriting.write_all

    def write(rewrites: Iterable[Rewrite]) -> object:
        file.write_text(LINE + file.read_text())
        return write_all(rewrites)

    monkeypatch.setattr(rewriting, "write_all", write)
    changes = mend(run_over(root, "RM203"))
    assert [str(each.code) for each in changes.diagnostics] == ["changed-on-disk"]
    assert file.read_text().endswith(LINE + BROKEN)


@pytest.mark.parametrize("change", [mend, note_all])
@pytest.mark.parametrize("is_warm", [False, True], ids=["cold", "warm"])
def test_places_of_another_text_are_not_changed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, change: Change, is_warm: bool
) -> None:
    root = write_tree(tmp_path, {"a.py": BROKEN})
    file = root / "a.py"
    if is_warm:
        assert run_over(root, "RM203").found
    run = run_over(root, "RM203")
    lines = [LINE]

    def changed_since(asked: Path) -> bytes | None:
        # Between the reading of a node and the look at its comments.
        if lines:
            file.write_text(lines.pop() + BROKEN)
        return file.read_bytes()

    monkeypatch.setattr(run._files, "text", changed_since)
    changes = change(run)
    assert file.read_text() == LINE + (MENDED if change is mend else BROKEN)
    assert changes.done == (1 if change is mend else 0)


def test_what_a_killed_process_has_left_is_no_name_of_a_file(tmp_path: Path) -> None:
    root = write_tree(tmp_path, {"a.py": BROKEN, ".plastron-0.new": MENDED})
    os.link(root / "a.py", root / ".plastron-0.old")
    changes = mend(run_over(root, "RM203"))
    assert (changes.done, changes.diagnostics) == (1, ())
    assert [each.name for each in root.iterdir()] == ["a.py"]


FAILED = {"cannot_be_opened": "open", "cannot_be_synced": "fsync", "disk_is_full": "write"}


def _full(call: str) -> Callable[..., Any]:
    """Return what a call for the system does where there is no room for anything new."""
    real = getattr(os, call)

    def full(*given: Any, **named: Any) -> Any:
        if call != "open" or given[1] & os.O_CREAT:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        return real(*given, **named)

    return full


@pytest.mark.parametrize("call", FAILED.values(), ids=FAILED)
@pytest.mark.parametrize("before", [None, b"", b'{"version": 1, "findings": []}'])
def test_baseline_is_written_as_a_whole_or_not_at_all(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, call: str, before: bytes | None
) -> None:
    file = tmp_path / "known.json"
    if before is not None:
        file.write_bytes(before)
    with monkeypatch.context() as patch:
        patch.setattr(os, call, _full(call))
        (problem,) = write_baseline(file, b'{"version": 1, "findings": [1]}')
    assert problem.code == "cannot-write"
    assert (file.read_bytes() if file.exists() else None) == before
    assert list(tmp_path.iterdir()) == [file] * (before is not None)
    # The folder is no output folder: it gets no manifest.
    assert write_baseline(file, b"{}") == ()
    assert list(tmp_path.iterdir()) == [file]


@pytest.mark.parametrize("call", FAILED.values(), ids=FAILED)
@pytest.mark.parametrize("change", [mend, note_all])
def test_what_a_full_disk_does_not_take_counts_for_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, change: Change, call: str
) -> None:
    root = write_tree(tmp_path, {"a.py": BROKEN})
    monkeypatch.setattr(os, call, _full(call))
    changes = change(run_over(root, "RM203"))
    assert (changes.done, changes.files) == (0, 0)
    assert [str(each.code) for each in changes.diagnostics] == ["cannot-write"]
    assert [each.read_text() for each in root.iterdir()] == [BROKEN]
