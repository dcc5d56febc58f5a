"""What builds nodes in C++, in packages that are written new."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest
from cpp_packages import plain_package, ros1_package, ros2_package

from plastron_tui.targets.packages import PackageSpec, render_package

Make = Callable[[Path], PackageSpec]

# Parts of the files of each package that say how its nodes are built, started and loaded.
SAID: dict[Make, dict[str, list[str]]] = {
    ros1_package: {
        "CMakeLists.txt": [
            "    message_generation\n    nodelet\n    pluginlib\n    roscpp\n    std_msgs\n)",
            "include_directories(include ${catkin_INCLUDE_DIRS})",
            "add_executable(${PROJECT_NAME}_talker src/talker.cpp)",
            'PROPERTIES OUTPUT_NAME talker PREFIX "")',
            "add_library(${PROJECT_NAME}_relay src/relay.cpp)",
            "  ${${PROJECT_NAME}_EXPORTED_TARGETS}\n  ${catkin_EXPORTED_TARGETS}\n)",
            "    scripts/echo.py\n",
            "  FILES nodelet_plugins.xml\n",
        ],
        "nodelet_plugins.xml": [
            '<library path="lib/libdemo_relay">',
            'name="demo/Relay"',
            'type="demo::Relay"',
        ],
        "package.xml": [
            "<depend>nodelet</depend>\n  <depend>pluginlib</depend>\n  <depend>roscpp</depend>",
            "<exec_depend>rospy</exec_depend>",
            '<nodelet plugin="${prefix}/nodelet_plugins.xml"/>',
        ],
        "README.md": ["rosrun demo talker", "rosrun nodelet nodelet standalone demo/Relay"],
    },
    ros2_package: {
        "CMakeLists.txt": [
            "add_compile_options(-Wall -Wextra -Wpedantic)",
            "find_package(rclcpp REQUIRED)\nfind_package(rclcpp_components REQUIRED)\n",
            "rosidl_get_typesupport_target(cpp_typesupport_target ${PROJECT_NAME} ",
            "add_executable(talker src/talker.cpp)",
            "  talker PUBLIC\n  rclcpp::rclcpp\n  ${cpp_typesupport_target}\n)",
            "add_library(${PROJECT_NAME}_relay SHARED src/relay.cpp)",
            "  rclcpp_components::component\n  ${std_msgs_TARGETS}\n",
            '  PLUGIN "demo::Relay"\n  EXECUTABLE relay\n)',
            "  PROGRAMS scripts/echo.py\n",
            "ament_export_targets(export_${PROJECT_NAME} HAS_LIBRARY_TARGET)",
        ],
        "package.xml": [
            "<depend>rclcpp_components</depend>",
            "<test_depend>ament_cmake_cpplint</test_depend>",
            "<build_type>ament_cmake</build_type>",
        ],
    },
    plain_package: {
        "CMakeLists.txt": ["  rclcpp::rclcpp\n  ${std_msgs_TARGETS}\n)"],
    },
}


@pytest.mark.parametrize("make", SAID, ids=lambda each: each.__name__)
def test_a_package_says_how_its_nodes_are_built(make: Make, tmp_path: Path) -> None:
    found = render_package(make(tmp_path))
    assert found.files is not None
    assert found.diagnostics == ()
    for name, parts in SAID[make].items():
        text = found.files[name].text.decode()
        for part in parts:
            assert part in text
    assert {"src/talker.cpp", "include/demo/talker.hpp", "scripts/echo.py"} <= set(found.files)
    assert not found.files["src/talker.cpp"].is_executable
    assert found.files["scripts/echo.py"].is_executable


@pytest.mark.parametrize("make", SAID, ids=lambda each: each.__name__)
def test_a_bare_package_has_what_builds_its_nodes_alone(make: Make, tmp_path: Path) -> None:
    spec = replace(
        make(tmp_path), is_bare=True, maintainer=None, license=None, definitions=(),
        builds_types=False,
    )  # fmt: skip
    found = render_package(spec)
    assert found.files is not None
    assert found.diagnostics == ()
    beside = {path for path in found.files if "/" not in path}
    assert beside <= {"CMakeLists.txt", "package.xml", "nodelet_plugins.xml"}
    assert b"test" not in found.files["CMakeLists.txt"].text.lower()
    assert b"test_depend" not in found.files["package.xml"].text


def test_a_header_that_nobody_knows_is_told(tmp_path: Path) -> None:
    spec = plain_package(tmp_path)
    first, *others = spec.nodes
    text = b'#include "robots/arm.hpp"\n#include <sys/time.h>\n#include <Eigen/Core>\n' + first.text
    found = render_package(replace(spec, nodes=(first._replace(text=text), *others)))
    assert found.files is not None
    assert [each.code for each in found.diagnostics] == ["unknown-import"]
    assert "includes `robots/arm.hpp`" in found.diagnostics[0].message
    assert b"<depend>eigen</depend>" in found.files["package.xml"].text
    assert b"find_package(eigen" not in found.files["CMakeLists.txt"].text


def test_a_header_that_comes_along_is_none_of_others(tmp_path: Path) -> None:
    spec = plain_package(tmp_path)
    first, *others = spec.nodes
    text = b'#include "robots/arm.hpp"\n' + first.text
    beside = (*first.others, ("../include/robots/arm.hpp", b""))
    node = first._replace(text=text, others=beside)
    assert render_package(replace(spec, nodes=(node, *others))).diagnostics == ()


@pytest.mark.parametrize(
    ("header", "folder", "is_installed"),
    [
        ("../include/demo/talker.hpp", "include_directories(include $", True),
        ("../include/robots/talker.hpp", "include_directories(include $", False),
        ("talker.hpp", "include_directories($", False),
    ],
)
def test_only_headers_that_are_there_are_installed(
    header: str, folder: str, is_installed: bool, tmp_path: Path
) -> None:
    spec = ros1_package(tmp_path)
    nodes = tuple(each._replace(others=((header, b""),)) for each in spec.nodes if each.is_built)
    found = render_package(replace(spec, nodes=nodes))
    assert found.files is not None
    text = found.files["CMakeLists.txt"].text.decode()
    assert ("DIRECTORY include/${PROJECT_NAME}/" in text) == is_installed
    assert folder in text


@pytest.mark.parametrize("name", ["test", "install", "demo"])
def test_no_target_has_the_name_of_another(name: str, tmp_path: Path) -> None:
    spec = replace(ros2_package(tmp_path))
    first, *others = spec.nodes
    named = first._replace(module=name, executable=name, others=())
    found = render_package(replace(spec, nodes=(named, *others)))
    assert found.files is not None
    text = found.files["CMakeLists.txt"].text.decode()
    assert f"add_executable(${{PROJECT_NAME}}_{name} src/{name}.cpp)" in text
    assert f"OUTPUT_NAME {name})" in text
