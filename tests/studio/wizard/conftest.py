from __future__ import annotations

from pathlib import Path

import pytest
from wizard_courses import TWO_NODES


@pytest.fixture(autouse=True)
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A new program is in a folder of the test's own."""
    folder = tmp_path / "here"
    folder.mkdir()
    monkeypatch.chdir(folder)
    return folder


@pytest.fixture
def two(here: Path) -> Path:
    """A program with two nodes that speak with each other."""
    path = here / "two.plastron"
    path.write_text(TWO_NODES)
    return path
