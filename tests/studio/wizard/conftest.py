from __future__ import annotations

from pathlib import Path

import pytest

from plastron_tui.studio.wizard import screen


@pytest.fixture(autouse=True)
def no_ros(monkeypatch: pytest.MonkeyPatch) -> None:
    """Whatever is installed on this machine, the wizard sees no ROS."""
    monkeypatch.setattr(screen, "installed", lambda environ: ())


@pytest.fixture(autouse=True)
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A new program is in a folder of the test's own."""
    folder = tmp_path / "here"
    folder.mkdir()
    monkeypatch.chdir(folder)
    return folder
