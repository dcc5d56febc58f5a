"""An older ROS 2 than the one that the tests run on: Jazzy, as the extra `ros2-jazzy` brings it."""

from __future__ import annotations

import fcntl
import os
import subprocess
import sys
from importlib.metadata import requires
from pathlib import Path

import pytest
from machine import skip_or_fail
from packaging.requirements import Requirement

EXTRA = "ros2-jazzy"


def jazzy_wheels() -> list[str]:
    """Return what the extra requires on this machine; nothing where it has no wheels."""
    listed = map(Requirement, requires("plastron-tui") or ())
    found = [each for each in listed if each.marker is not None]
    return [
        f"{each.name}{each.specifier}"
        for each in found
        if each.marker is not None
        and each.marker.evaluate({"extra": EXTRA})
        and not each.marker.evaluate({"extra": ""})
    ]


def jazzy_python(factory: pytest.TempPathFactory) -> Path:
    """Return a Python that has Jazzy; its environment is made once for all workers."""
    base = factory.getbasetemp()
    folder = (base.parent if "PYTEST_XDIST_WORKER" in os.environ else base) / "jazzy"
    python, done = folder / "bin" / "python", folder / "installed"
    with folder.with_name("jazzy.lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not done.exists():
            _install(folder, python)
            done.touch()
    return python


def _install(folder: Path, python: Path) -> None:
    wheels = jazzy_wheels()
    if not wheels:
        skip_or_fail("Jazzy has no wheels for this Python, or this machine")
    # What the tests import is compiled then; all there is takes a minute of processor time.
    quietly = ("--quiet", "--disable-pip-version-check", "--no-compile")
    # An environment with a pip of its own takes four seconds of a processor more.
    pip = [sys.executable, "-m", "pip", "--python", python, "install", *quietly, *wheels]
    for command in ([sys.executable, "-m", "venv", "--without-pip", folder], pip):
        made = subprocess.run(command, capture_output=True, text=True, check=False, timeout=1200)
        if made.returncode != 0:
            skip_or_fail(f"Jazzy's wheels cannot be installed: {made.stderr[-500:]}")
