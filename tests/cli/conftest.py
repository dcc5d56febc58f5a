from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest
from command_line import Run, run_in_copy


@pytest.fixture
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A working folder of its own, with no ROS around it."""
    monkeypatch.chdir(tmp_path)
    for name in ("ROS_VERSION", "ROS_DISTRO", "ROS_PACKAGE_PATH", "AMENT_PREFIX_PATH"):
        monkeypatch.delenv(name, raising=False)
    for name in ("NO_COLOR", "FORCE_COLOR"):
        monkeypatch.delenv(name, raising=False)
    return tmp_path


@pytest.fixture
def run(here: Path) -> Run:
    """Run plastron as a process in the working folder; it comes out with no traceback."""

    def run(
        *arguments: str | Path,
        stdin: bytes = b"",
        env: dict[str, str] | None = None,
        cwd: Path = here,
    ) -> subprocess.CompletedProcess[bytes]:
        result = run_in_copy([os.fspath(each) for each in arguments], cwd, stdin, env or {})
        assert b"Traceback" not in result.stderr, result.stderr.decode()
        return result

    return run
