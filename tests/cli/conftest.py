from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest
from command_line import Copies, Run, run_in_copy


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
def run(here: Path, copied: Copies, request: pytest.FixtureRequest) -> Run:
    """Run plastron as a process in the working folder; it comes out with no traceback.

    The process has nothing of what a test has patched; see `run_patched`.
    """
    is_debian = request.node.get_closest_marker("live") is None

    def run(
        *arguments: str | Path,
        stdin: bytes = b"",
        env: dict[str, str] | None = None,
        cwd: Path = here,
    ) -> subprocess.CompletedProcess[bytes]:
        given = [os.fspath(each) for each in arguments]
        return _without_traceback(copied.run(given, cwd, stdin, env or {}, is_debian=is_debian))

    return run


@pytest.fixture
def run_patched(here: Path) -> Run:
    """Run plastron in a copy of this process, with what the test has patched."""

    def run(*arguments: str | Path, stdin: bytes = b"") -> subprocess.CompletedProcess[bytes]:
        given = [os.fspath(each) for each in arguments]
        return _without_traceback(run_in_copy(given, here, stdin, {}))

    return run


def _without_traceback(
    result: subprocess.CompletedProcess[bytes],
) -> subprocess.CompletedProcess[bytes]:
    assert b"Traceback" not in result.stderr, result.stderr.decode()
    return result
