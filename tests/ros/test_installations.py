from __future__ import annotations

from importlib.machinery import EXTENSION_SUFFIXES
from pathlib import Path

import pytest

from plastron_tui.ros.installations import Installation, Origin, installed_in, present


def add_rclpy(packages: Path, version: str = "9.1.2", suffix: str = EXTENSION_SUFFIXES[0]) -> None:
    (packages / "rclpy").mkdir(parents=True)
    (packages / "rclpy" / f"_rclpy_pybind11{suffix}").touch()
    (packages / f"rclpy-{version}.dist-info").mkdir()


def add_middleware(prefix: Path, name: str = "rmw_fastrtps_cpp") -> None:
    folder = prefix / "share" / "ament_index" / "resource_index" / "rmw_typesupport"
    folder.mkdir(parents=True)
    (folder / name).touch()


def add_debian(root: Path) -> None:
    (root / "usr" / "lib" / "python3" / "dist-packages" / "rospy").mkdir(parents=True)


def add_opt(root: Path, *names: str) -> None:
    for name in names:
        (root / "opt" / "ros" / name).mkdir(parents=True)
        (root / "opt" / "ros" / name / "setup.bash").touch()


def found(root: Path) -> list[Installation]:
    return list(installed_in(root, ["", str(root / "none"), str(root / "site")], root / "prefix"))


def test_what_is_installed_is_found(tmp_path: Path) -> None:
    assert found(tmp_path) == []
    add_opt(tmp_path, "melodic", "kilted", "noetic", "lyrical", "humble", "one")
    (tmp_path / "opt" / "ros" / "jazzy").mkdir()  # what an uninstallation left
    add_debian(tmp_path)
    add_rclpy(tmp_path / "site")
    add_middleware(tmp_path / "prefix")
    there = found(tmp_path)
    assert there[:2] == [
        Installation(Origin.EXTRA, 2, "kilted"),
        Installation(Origin.DEBIAN, 1, "noetic"),
    ]
    assert {each.origin for each in there[2:]} == {Origin.UNSOURCED}
    assert [each.distribution for each in there[2:5]] == ["lyrical", "kilted", "humble"]
    assert {each.distribution for each in there[5:]} == {"noetic", "melodic", "one"}
    assert {each.ros_version for each in there[5:]} == {1}


@pytest.mark.parametrize(
    ("version", "distribution"),
    [
        ("3.3.1", "humble"),
        ("7.1.6", "jazzy"),
        ("9.0.0", "kilted"),
        ("10.0.10", "lyrical"),
        ("99.1", ""),
    ],
)
def test_the_version_of_rclpy_tells_the_distribution(
    tmp_path: Path, version: str, distribution: str
) -> None:
    add_rclpy(tmp_path / "site", version)
    add_middleware(tmp_path / "prefix")
    assert found(tmp_path) == [Installation(Origin.EXTRA, 2, distribution)]


def test_rclpy_that_nothing_can_run_with_does_not_count(tmp_path: Path) -> None:
    add_rclpy(tmp_path / "site")
    add_middleware(tmp_path / "prefix", "rmw_implementation")
    assert found(tmp_path) == []


def test_rclpy_of_another_python_does_not_count(tmp_path: Path) -> None:
    add_rclpy(tmp_path / "site", suffix=".cpython-36m-x86_64-linux-gnu.so")
    add_middleware(tmp_path / "prefix")
    assert found(tmp_path) == []


def test_what_is_sourced_goes_first(monkeypatch: pytest.MonkeyPatch) -> None:
    here = Installation(Origin.DEBIAN, 1, "noetic")
    monkeypatch.setattr("plastron_tui.ros.installations.installed", lambda: (here,))
    sourced = Installation(Origin.SOURCED, 2, "humble")
    assert list(present({"ROS_VERSION": "2", "ROS_DISTRO": " Humble "})) == [sourced, here]
    assert list(present({})) == [here]
