"""Launch files in Python: what is written is read again, and literals of others are read."""

from __future__ import annotations

import ast

from hypothesis import HealthCheck, Phase, given, settings
from launch_files import launch_files

from plastron_tui.ros.launch import LaunchFile
from plastron_tui.sources.launch.python_reader import read_launch_python
from plastron_tui.targets.launch.python import write_python


@settings(
    max_examples=60,
    deadline=None,
    suppress_health_check=list(HealthCheck),
    phases=(Phase.explicit, Phase.reuse, Phase.generate),
)
@given(launch=launch_files(2))
def test_what_is_written_is_read_again(launch: LaunchFile) -> None:
    written = write_python(launch)
    ast.parse(written)
    read = read_launch_python(written.encode())
    assert read.diagnostics == ()
    assert read.launch == launch, written
