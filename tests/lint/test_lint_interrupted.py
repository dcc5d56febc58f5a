"""Lint that is interrupted while several processes read."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

import pytest
from machine import wait_until

_NODE = "import rclpy\nnode = rclpy.create_node('a')\n" + "x = 1\n" * 20_000


@pytest.fixture
def root(tmp_path: Path) -> Path:
    """Make a workspace that takes long to read."""
    folder = tmp_path / "src"
    folder.mkdir()
    for at in range(60):
        (folder / f"node_{at}.py").write_text(_NODE)
    return folder


@contextmanager
def _linting(root: Path) -> Iterator[subprocess.Popen[str]]:
    command = [sys.executable, "-m", "plastron_tui", "lint", "-j2", str(root)]
    environ = {**os.environ, "XDG_CACHE_HOME": str(root.parent / "cache")}
    with subprocess.Popen(
        command,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        env=environ,
        start_new_session=True,
    ) as process:
        try:
            wait_until(lambda: len(_children(process.pid)) == 2, "two processes")
            yield process
        finally:
            with suppress(ProcessLookupError):
                os.killpg(process.pid, signal.SIGKILL)


def _children(process: int) -> list[int]:
    with suppress(OSError):
        found = Path(f"/proc/{process}/task/{process}/children").read_text()
        return [int(each) for each in found.split()]
    return []


@pytest.mark.parametrize(
    ("way", "status", "line"), [(signal.SIGINT, 130, "\n"), (signal.SIGTERM, -signal.SIGTERM, "")]
)
def test_interrupt_ends_all_processes_at_once(root: Path, way: int, status: int, line: str) -> None:
    with _linting(root) as process:
        # As a terminal does it: all of them get it.
        os.killpg(process.pid, way)
        # They hold the pipes as long as they live.
        told, said = process.communicate()
        assert (process.wait(), told, said) == (status, "", line)
    assert not (root.parent / "cache").exists()
