"""Interface packages around a launch file: which are built before its nodes run."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import pytest

from plastron_tui.ros.installations import Origin
from plastron_tui.runtime import source_interfaces
from plastron_tui.runtime.builds import BuiltPackage
from plastron_tui.runtime.environment import Environment
from plastron_tui.runtime.launch_packages import find_packages
from plastron_tui.sources.launch.around import packages_root

ENVIRONMENT = Environment(Origin.EXTRA, 2, "kilted", Path("/python"))


def _package(folder: Path, *depends: str, message: str | None = None) -> None:
    folder.mkdir(parents=True)
    words = "".join(f"<depend>{each}</depend>" for each in depends)
    (folder / "package.xml").write_text(f"<package><name>{folder.name}</name>{words}</package>")
    if message is not None:
        (folder / "msg").mkdir()
        (folder / f"msg/{message}.msg").write_text("float64 x\n")


def _built(
    monkeypatch: pytest.MonkeyPatch, root: Path, started: Sequence[str], *installed: str
) -> list[BuiltPackage]:
    """Return the packages that are built for nodes of some packages."""
    built: list[BuiltPackage] = []

    def overlay(
        environment: Environment, packages: Sequence[BuiltPackage], *_: object
    ) -> tuple[Environment, list[object]]:
        built.extend(packages)
        return replace(environment, overlays=(root,)), []

    def missing(_: Environment, names: Sequence[str], __: object) -> list[str]:
        return [each for each in names if each not in installed]

    monkeypatch.setattr(source_interfaces, "overlay", overlay)
    monkeypatch.setattr(source_interfaces, "missing_packages", missing)
    sources = find_packages(root / "rover/launch/a.launch.xml", ENVIRONMENT, {}).sources
    source_interfaces.with_built(ENVIRONMENT, sources, started, lambda _: None, {})
    return built


@pytest.fixture
def root(tmp_path: Path) -> Path:
    _package(tmp_path / "rover", "rover_interfaces", "rclpy")
    _package(tmp_path / "rover_interfaces", "base_msgs", message="Speed")
    _package(tmp_path / "base_msgs", "rover_interfaces", message="Base")
    _package(tmp_path / "other_msgs", message="Other")
    (tmp_path / "rover_interfaces/.git").mkdir()
    (tmp_path / "rover_interfaces/.git/config").write_text("x")
    (tmp_path / "rover_interfaces/msg/Link.msg").symlink_to("/etc/passwd")
    return tmp_path


def test_what_nodes_need_is_built_behind_what_that_needs(
    root: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    built = _built(monkeypatch, root, ["rover", "rover", "gone"])
    assert [each.name for each in built] == ["base_msgs", "rover_interfaces"]
    assert set(built[1].files) == {"package.xml", "msg/Speed.msg"}


def test_what_is_installed_or_needed_by_none_is_not_built(
    root: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    installed = _built(monkeypatch, root, ["rover"], "base_msgs", "rover_interfaces")
    assert installed == []
    assert _built(monkeypatch, root, ["gone"]) == []


@pytest.mark.parametrize(
    ("made", "launch", "root"),
    [
        ((), "out/rover/launch/a.launch", "out"),
        (("ws/src",), "ws/src/group/rover/launch/a.launch", "ws/src"),
        (("repo/.git",), "repo/group/rover/launch/a.launch", "repo"),
        (("ws/.git", "ws/src"), "ws/src/rover/launch/a.launch", "ws/src"),
        (("far/.git",), "far/1/2/3/4/rover/launch/a.launch", "far/1/2/3/4"),
    ],
)
def test_packages_are_looked_for_around(
    tmp_path: Path, made: Sequence[str], launch: str, root: str
) -> None:
    file = tmp_path / launch
    file.parent.mkdir(parents=True)
    (file.parent.parent / "package.xml").write_text("<package/>")
    for each in made:
        (tmp_path / each).mkdir(exist_ok=True)
    assert packages_root(file) == tmp_path / root


def test_a_home_folder_is_no_workspace(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("HOME", str(tmp_path))
    (tmp_path / ".git").mkdir()
    _package(tmp_path / "group/rover")
    assert packages_root(tmp_path / "group/rover/launch/a.launch") == tmp_path / "group"
