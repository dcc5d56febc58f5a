"""Definitions that a package needs and the ROS that is here does not have."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

from plastron_tui.ros.installations import Origin
from plastron_tui.runtime import build_tools
from plastron_tui.runtime.builds import BuiltPackage, overlay
from plastron_tui.runtime.environment import Environment


def test_definitions_that_debian_has_in_another_package(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(build_tools, "DEBIAN_SHARE", tmp_path)
    environment = Environment(Origin.DEBIAN, 1, "noetic", Path(sys.executable))
    package = BuiltPackage("rover", {"msg/A.msg": b"# a/b\nstereo_msgs/DisparityImage x\n"})
    environ = {"XDG_CACHE_HOME": str(tmp_path / "cache"), "PATH": "/usr/bin:/bin"}
    _, [found] = overlay(environment, [package], pytest.fail, environ)
    assert found.message == (
        "`rover` has to be built, and the definitions of `stereo_msgs` are not installed"
    )
    assert found.help == "install them with `sudo apt install ros-stereo-msgs`"
    assert not (tmp_path / "cache").exists()
