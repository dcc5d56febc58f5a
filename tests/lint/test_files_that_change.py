"""What `lint` writes into files of any name, and into files that others change meanwhile."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable
from pathlib import Path

import pytest
from linted import run_over, told, write_tree

from plastron_tui.lint.rules import RULES
from plastron_tui.project.linting import rewriting
from plastron_tui.project.linting.rewriting import Changes, Rewrite, mend, note_all
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
