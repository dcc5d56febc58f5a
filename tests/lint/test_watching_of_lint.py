"""What `plastron lint --watch` looks again for."""

from __future__ import annotations

import os
from collections.abc import Callable
from itertools import islice
from pathlib import Path

import pytest

from plastron_tui.project.linting.run import LintOptions
from plastron_tui.project.linting.watching import watched

MOST_LOOKS = 3


def _runs_after(folder: Path, change: Callable[[Path], object]) -> int:
    """Return how many runs there are when a file changes after the first."""
    looks = 0

    def sleep(_seconds: float) -> None:
        nonlocal looks
        looks += 1
        if looks == 1:
            change(folder)
        if looks > MOST_LOOKS:
            raise KeyboardInterrupt

    runs = 0
    options = LintOptions((folder / "src",), baseline=folder / "known.json")
    with pytest.raises(KeyboardInterrupt):
        for _ in islice(watched(options, sleep), MOST_LOOKS):
            runs += 1
    return runs


CHANGES: dict[str, tuple[Callable[[Path], object], int]] = {
    "a node": (lambda folder: (folder / "src/node.py").write_text("x = 2  # longer"), 2),
    "a new node": (lambda folder: (folder / "src/other.py").write_text(""), 2),
    "what may be run": (lambda folder: (folder / "src/node.py").chmod(0o755), 2),
    "the baseline": (lambda folder: (folder / "known.json").write_text("{}"), 2),
    "a recording that goes on": (lambda folder: (folder / "src/a.BAG").write_text("more"), 1),
    "a log": (lambda folder: (folder / "src/lint.log").write_text("more"), 1),
    "nothing": (lambda _folder: None, 1),
}


@pytest.mark.parametrize(("change", "runs"), CHANGES.values(), ids=CHANGES)
def test_what_counts_is_looked_at_again(
    tmp_path: Path, change: Callable[[Path], object], runs: int
) -> None:
    (tmp_path / "src").mkdir()
    for name in ("node.py", "a.BAG", "lint.log"):
        (tmp_path / "src" / name).write_text("x")
    (tmp_path / "src/node.py").chmod(0o644)
    assert _runs_after(tmp_path, change) == runs


def test_what_is_told_is_no_reason_to_look_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """`plastron lint --watch > found.txt` in the workspace itself would never end."""
    (tmp_path / "src").mkdir()
    with (tmp_path / "src/found.txt").open("w") as out:
        real = os.fstat
        monkeypatch.setattr(os, "fstat", lambda number: real(out.fileno() if number == 1 else 2))
        assert _runs_after(tmp_path, lambda _folder: (out.write("told\n"), out.flush())) == 1
