"""Every screen of the studio says the same of the ROS that a program is for, from the start."""

from __future__ import annotations

from pathlib import Path

import pytest
from machine import mostly_long
from one_ros import CASES, UNKNOWN_TYPE, unknown_type
from studio_driver import studio

from plastron_tui.session import Options
from plastron_tui.studio.wizard.context import Scene
from plastron_tui.studio.wizard.libraries import ros_of


@pytest.mark.parametrize("name", mostly_long(CASES, list(CASES)[::3]))
async def test_the_studio_is_for_the_same_ros(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    case = CASES[name]
    case.set_up(tmp_path, monkeypatch)
    file = tmp_path / "a.plastron"
    file.write_text(UNKNOWN_TYPE)
    ros = f"{case.ros[0]} (ROS {case.ros_version} {case.ros[1]})"
    async with studio(file, options=Options(case.target)) as driver:
        assert driver.main.query_one("#title").text.endswith(ros)
        await driver.settle()
        assert driver.main.query_one("#title").text.endswith(ros)
        assert driver.shown("nodes")[0].startswith(f"● arm {case.ros[0]} ")
        analysis = driver.main.open.analysis
        assert unknown_type(case) in [found.message for found in analysis.diagnostics]
        assert ros_of(Scene(analysis.session), "") == f"ROS {case.ros_version} {case.ros[1]}"
