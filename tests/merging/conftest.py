from __future__ import annotations

from pathlib import Path

import pytest
from merging_driver import LIBRARIES, Folder


@pytest.fixture(params=LIBRARIES)
def folder(request: pytest.FixtureRequest, tmp_path: Path) -> Folder:
    return Folder(tmp_path, request.param)
