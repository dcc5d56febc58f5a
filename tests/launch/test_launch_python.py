"""Launch files in Python: what is written is read again, and literals of others are read."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest
from ament_linters import findings
from hypothesis import HealthCheck, Phase, given, settings
from launch_files import launch_files

from plastron_tui.ros.launch import LaunchFile
from plastron_tui.sources.launch.python_reader import read_launch_python
from plastron_tui.targets.launch.python import write_python

written_often = settings(
    max_examples=60,
    deadline=None,
    suppress_health_check=list(HealthCheck),
    phases=(Phase.explicit, Phase.reuse, Phase.generate),
)


@written_often
@given(launch=launch_files(2))
def test_what_is_written_is_read_again(launch: LaunchFile) -> None:
    written = write_python(launch)
    ast.parse(written)
    read = read_launch_python(written.encode())
    assert read.diagnostics == ()
    assert read.launch == launch, written


@pytest.mark.long
def test_what_is_written_is_clean(tmp_path: Path) -> None:
    made: list[Path] = []

    @written_often
    @given(launch_files(2))
    def make(launch: LaunchFile) -> None:
        made.append(tmp_path / f"made_{len(made)}.launch.py")
        made[-1].write_text(write_python(launch), encoding="utf-8")

    make()
    assert findings(tmp_path) == []
