"""The commands that install what is missing, and the extras that they name."""

from __future__ import annotations

from importlib.metadata import requires

from packaging.requirements import Requirement

from plastron_tui.ros.installations import rclpy_of_distribution
from plastron_tui.runtime import installing


def test_the_extra_brings_the_distribution_that_it_is_said_to_bring() -> None:
    listed = [Requirement(each) for each in requires("plastron-tui") or ()]
    for distribution, extra in installing._EXTRAS.items():
        rclpy = rclpy_of_distribution(distribution)
        [wanted] = [
            each.specifier
            for each in listed
            if each.name == "ros-rclpy" and f'"{extra}"' in str(each.marker)
        ]
        assert f"{rclpy}.99" in wanted
        assert f"{int(rclpy) + 1}.0" not in wanted
        assert installing.extra(distribution) == f"pip install 'plastron-tui[{extra}]'"
    assert installing.extra("") == installing.extra("lyrical") == installing.extra()


def test_a_wheel_is_that_of_the_distribution() -> None:
    assert installing.wheel("nav_msgs") == "pip install ros-nav-msgs"
    assert installing.wheel("nav_msgs", "kilted") == "pip install ros-nav-msgs"
    jazzy = installing.wheel("nav_msgs", "jazzy")
    assert jazzy == "pip install ros-nav-msgs 'ros-rclpy==7.*'"
    assert installing.wheel("example_interfaces", "jazzy") is None
