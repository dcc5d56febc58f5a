"""All programs of the tests and the examples, built for C++ without a warning.

Left out are those that load a file, of which there are none in C++, and what the stand-in of
rclcpp has not: actions, components; what is managed is compiled as if it were not.
"""

from __future__ import annotations

import os
from pathlib import Path
from xml.etree import ElementTree

import pytest
from cpp_builds import describe_rclcpp, find_rclcpp
from cpp_corpus import PACKAGE, Built, build_with_catkin, build_with_colcon

pytestmark = [pytest.mark.live, pytest.mark.long(2)]


def nodes_of(built: Built) -> tuple[int, int]:
    """Return how many nodes the program has that are programs, and that are plugins."""
    lines = built.package.with_suffix(".plastron").read_text(encoding="utf-8").splitlines()
    plugins = sum(line.endswith((" nodelet", " component")) for line in lines)
    return sum(line.startswith("generate_node ") for line in lines) - plugins, plugins


def programs_of(built: Built) -> list[Path]:
    folder = built.prefix / "lib" / PACKAGE
    return [each for each in folder.iterdir() if os.access(each, os.X_OK)]


def test_catkin_builds_every_program(shared_cache: Path) -> None:
    built = build_with_catkin(shared_cache)
    programs, plugins = nodes_of(built)
    assert len(programs_of(built)) == programs > 15
    libraries = ElementTree.parse(built.package / "nodelet_plugins.xml").getroot().iter("library")
    made = [built.prefix / f"{each.attrib['path']}.so" for each in libraries]
    assert all(map(Path.is_file, made))
    assert len(made) == plugins > 15


@pytest.mark.parametrize("_", [describe_rclcpp()])
def test_colcon_builds_every_program(
    ros2_services_env: dict[str, str],
    shared_cache: Path,
    tmp_path_factory: pytest.TempPathFactory,
    _: str,
) -> None:
    built = build_with_colcon(shared_cache, find_rclcpp(tmp_path_factory), ros2_services_env)
    # A component is a program of its own as well.
    assert len(programs_of(built)) == sum(nodes_of(built)) > 30
