"""What was left by another Plastron, an edited one included, is told from its own."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

import pytest

import plastron_tui
from plastron_tui.project.linting import cache


def _package(folder: Path) -> None:
    for name in ("__init__.py", "regular_files.py", "ros/msg.yaml", "lint/a.py", "model/b.py"):
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text("as it was")
        os.utime(folder / name, (0, 0))


@pytest.mark.parametrize(
    ("edit", "is_another"),
    [
        (lambda package: (package / "ros/msg.yaml").write_text("edited"), True),
        (lambda package: (package / "regular_files.py").write_text("edited"), True),
        (lambda package: os.utime(package / "lint/a.py", (1, 1)), True),
        (lambda package: (package / "model/b.py").rename(package / "lint/b.py"), True),
        (lambda package: (package / "lint/a.py").unlink(), True),
        (lambda package: (package / "lint/__pycache__").mkdir(), False),
        (lambda package: _package(package / "lint/__pycache__"), False),
    ],
)
def test_an_edited_plastron_is_another(
    edit: Callable[[Path], object],
    is_another: bool,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    _package(tmp_path)
    monkeypatch.setattr(plastron_tui, "__file__", str(tmp_path / "__init__.py"))
    before = cache._program_stamp()
    edit(tmp_path)
    assert (cache._program_stamp() != before) is is_another


def test_a_plastron_is_the_same_in_whatever_order_its_files_come(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    _package(tmp_path)
    monkeypatch.setattr(plastron_tui, "__file__", str(tmp_path / "__init__.py"))
    before, walked = cache._program_stamp(), list(os.walk(tmp_path))
    monkeypatch.setattr(os, "walk", lambda _: reversed(walked))
    assert cache._program_stamp() == before
