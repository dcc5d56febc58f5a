"""The linters of ROS 2's packages, as they are without any configuration."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest


def findings(folder: Path) -> list[str]:
    """Return what ament_flake8 and ament_pep257 say of the files in a folder."""
    flake8: Any = pytest.importorskip("ament_flake8.main")
    pep257: Any = pytest.importorskip("ament_pep257.main")
    _, errors = flake8.main_with_errors(argv=[str(folder)])
    ignored = ",".join(pep257._ament_ignore)
    reports = pep257.generate_pep257_report([str(folder)], [], ignored, "", "ament", "", "")
    return [*errors, *(f"{name}: {each}" for name, found in reports for each in found)]
