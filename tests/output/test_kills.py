"""Whatever call a command is killed at, or fails with, the next run is as if it never was."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest
from machine import mostly_long

DRIVER = Path(__file__).with_name("kill_driver.py")
SCENES = ("created", "fresh", "in place", "forced", "recovery", "save")
# EIO goes the way of ENOSPC; EPERM may also say that a disk has no links.
ERRORS = ("ENOSPC", "EPERM", "clean", "read")


def broken(folder: Path, scene: str, event: str, *calls: str) -> int:
    """Break each call of a scene's command; return how many there were."""
    only = [",".join(calls)] if calls else []
    done = subprocess.run(
        [sys.executable, DRIVER, scene, event, folder, *only], capture_output=True, text=True
    )
    assert done.returncode == 0, done.stderr
    result = json.loads(done.stdout)
    assert result["wrong"] == []
    return int(result["calls"])


@pytest.mark.long
def test_killed_at_each_call_of_saving(tmp_path: Path) -> None:
    assert broken(tmp_path, "save", "kill") == 15


@pytest.mark.long
def test_killed_at_each_rename(tmp_path: Path) -> None:
    """Three nodes, the manifest, the journal."""
    assert broken(tmp_path, "fresh", "kill", "replace", "rename") == 5


@pytest.mark.parametrize("event", mostly_long(["EIO", "clean", "read"], ["EIO"]))
def test_saving_reports_what_is_on_the_disk(tmp_path: Path, event: str) -> None:
    assert broken(tmp_path, "save", event) >= 15


@pytest.mark.long
@pytest.mark.parametrize("scene", [*SCENES, "pair"])
def test_killed_at_each_call(tmp_path: Path, scene: str) -> None:
    assert broken(tmp_path, scene, "kill") > 8


@pytest.mark.long
@pytest.mark.parametrize("event", ERRORS)
@pytest.mark.parametrize("scene", SCENES)
def test_an_error_at_each_call(tmp_path: Path, scene: str, event: str) -> None:
    calls = broken(tmp_path, scene, event)
    # A reader that finds a journal where there are no locks changes nothing.
    assert calls == 0 if (scene, event) == ("recovery", "read") else calls > 8
