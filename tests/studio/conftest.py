from __future__ import annotations

from pathlib import Path

import pytest
from studio_driver import PROGRAM


@pytest.fixture(autouse=True)
def home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Keep the configuration and what is remembered in a folder of the test's own."""
    folder = tmp_path / "home"
    folder.mkdir()
    monkeypatch.setenv("XDG_CONFIG_HOME", str(folder / "config"))
    monkeypatch.setenv("XDG_STATE_HOME", str(folder / "state"))
    for name in ("NO_COLOR", "ROS_VERSION", "ROS_DISTRO", "VISUAL", "EDITOR"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setenv("TERM", "xterm-256color")
    return folder


@pytest.fixture
def program(tmp_path: Path) -> Path:
    file = tmp_path / "work" / "talk.plastron"
    file.parent.mkdir()
    file.write_text(PROGRAM)
    return file


@pytest.fixture
def loaded(program: Path, request: pytest.FixtureRequest) -> Path:
    """A program that loads a node file: the test module's `LOADED`, and its `FILE`."""
    program.write_text(request.module.LOADED)
    program.with_name("old.py").write_text(request.module.FILE)
    return program
