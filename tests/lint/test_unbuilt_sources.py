"""Which sources of C++ no build takes, and that nothing is told of what they say."""

from __future__ import annotations

from pathlib import Path

import pytest
from linted import NO_QUEUE, run_over, told, write_tree

from plastron_tui.lint.rules.package_examples import package_xml
from plastron_tui.project.linting import read_tree
from plastron_tui.project.linting.cache import FactCache
from plastron_tui.sources.packages.taken import unbuilt_sources

_SOURCES = ("src/a.cpp", "src/old/b.cpp", "lib/c.cc")


@pytest.mark.parametrize(
    ("cmake", "unbuilt"),
    [
        ("add_executable(a src/a.cpp)", "src/old/b.cpp lib/c.cc"),
        ("add_executable(a ./src/a.cpp ${PROJECT_SOURCE_DIR}/lib/c.cc)", "src/old/b.cpp"),
        ("# add_executable(a src/a.cpp)", "src/a.cpp src/old/b.cpp lib/c.cc"),
        ("add_executable(b src/a.cpp  # lib/c.cc\n)", "src/old/b.cpp lib/c.cc"),
        ("set(S\n  src/a.cpp\n  lib/c.cc)\nadd_library(a ${S})", "src/old/b.cpp"),
        ("project(a)\nadd_executable(x src/${PROJECT_NAME}.cpp)", "src/old/b.cpp lib/c.cc"),
        ("foreach(n a b)\nadd_executable(${n} src/${n}.cpp)\nendforeach()", "lib/c.cc"),
        ("file(GLOB S src/*.cpp)\nadd_library(a ${S})", "src/old/b.cpp lib/c.cc"),
        ("file(GLOB_RECURSE S src/*.cpp)\nadd_library(a ${S})", "lib/c.cc"),
        ("file(GLOB_RECURSE S *.cpp *.cc)\nadd_library(a ${S})", ""),
        ("aux_source_directory(src S)\nadd_library(a ${S})", "src/old/b.cpp lib/c.cc"),
        ("ament_auto_add_library(a SHARED DIRECTORY lib)", "src/a.cpp src/old/b.cpp"),
        ("add_executable(a src/a)", "src/old/b.cpp lib/c.cc"),
        ("build_program(b)", "src/a.cpp lib/c.cc"),
        ("build_programs()", ""),
        ("include(../all.cmake)", ""),
        ("add_executable(a src/a.cpp", ""),
        ("add_subdirectory(src)", "src/old/b.cpp lib/c.cc"),
        ("add_subdirectory(${WHERE})", "src/old/b.cpp lib/c.cc"),
    ],
)  # fmt: skip
def test_source_is_unbuilt_that_no_command_can_mean(cmake: str, unbuilt: str) -> None:
    texts = {"CMakeLists.txt": cmake.encode()}
    if "subdirectory" in cmake:
        texts["src/CMakeLists.txt"] = b"add_executable(a a.cpp)"
    assert unbuilt_sources(texts, _SOURCES) == frozenset(unbuilt.split())


def test_folder_that_no_list_names_is_not_built() -> None:
    texts = {
        "CMakeLists.txt": b"# add_subdirectory(src)\n",
        "src/CMakeLists.txt": b"add_executable(a a.cpp)",
    }
    assert unbuilt_sources(texts, ["src/a.cpp"]) == {"src/a.cpp"}
    assert unbuilt_sources({}, ["src/a.cpp"]) == frozenset()


_NODE = """\
#include <ros/ros.h>
int main(int argc, char **argv) {
  ros::init(argc, argv, "a");
  ros::NodeHandle nh;
  ros::spin();
}
"""
_SCRIPT = "import rospy\nrospy.init_node('a')\nrospy.spin()\n"
_LISTS = "project(arm)\nadd_executable(a src/a.cpp)\n"


def _units(folder: Path, files: dict[str, str]) -> list[str]:
    root = write_tree(folder, files)
    tree = read_tree([root], FactCache(root, folder / "cache"), workers=1)
    return [str(unit.path.relative_to(root)) for unit in tree.built]


def test_node_that_no_build_takes_is_no_part_of_the_workspace(tmp_path: Path) -> None:
    files = {
        "arm/package.xml": package_xml("arm", build_type="catkin"),
        "arm/CMakeLists.txt": _LISTS,
        "arm/src/a.cpp": _NODE,
        "arm/src/draft/a.cpp": _NODE,
        "arm/scripts/a.py": _SCRIPT,
        # A build tool looks for no package in a package.
        "arm/lib/inner/package.xml": package_xml("inner", build_type="catkin"),
        "arm/lib/inner/CMakeLists.txt": _LISTS,
        "arm/lib/inner/src/a.cpp": _NODE,
        "arm/lib/inner/scripts/a.py": _SCRIPT,
        # It lies where no package is, beside some that are there.
        "off/package_xml": package_xml("off", build_type="catkin"),
        "off/src/a.cpp": _NODE,
        "off/scripts/a.py": _SCRIPT,
    }
    found = ["arm/scripts/a.py", "arm/src/a.cpp", "off/scripts/a.py"]
    assert _units(tmp_path, files) == found
    alone = {name: text for name, text in files.items() if name.startswith("off/")}
    assert _units(tmp_path / "alone", alone) == ["off/scripts/a.py", "off/src/a.cpp"]


_CLASS = """\
#include <ros/ros.h>
struct A {{
  A();
  ros::NodeHandle nh;
}};
{}"""


@pytest.mark.parametrize(
    ("header", "text", "cmake", "found"),
    [
        ("draft/a.h", _CLASS.format(""), "", []),
        ("include/a.h", _CLASS.format(""), "", []),
        ("include/arm/b/a.hpp", _CLASS.format(""), "", []),
        # Who includes it has all of it.
        ("draft/a.h", _CLASS.format('#include "a.cpp"\n'), "", ["draft/a.h"]),
        ("draft/a.h", _CLASS.format(""), "add_library(a draft/a.cpp)", ["draft/a.h"]),
        ("draft/other.h", _CLASS.format("A::A() {}\n"), "", ["draft/other.h"]),
    ],
)
def test_header_of_sources_that_no_build_takes_is_none_either(
    tmp_path: Path, header: str, text: str, cmake: str, found: list[str]
) -> None:
    source = "draft/a.cpp" if header.startswith("draft") else "src/a.cpp"
    files = {
        "arm/package.xml": package_xml("arm", build_type="catkin"),
        "arm/CMakeLists.txt": f"project(arm)\n{cmake}\n",
        f"arm/{header}": text,
        f"arm/{source}": 'A::A() { nh.advertise<std_msgs::String>("a", 1); }\n',
    }
    assert _units(tmp_path, files) == [f"arm/{each}" for each in found]


def test_header_is_no_build_of_its_source(tmp_path: Path) -> None:
    files = {
        "arm/package.xml": package_xml("arm", build_type="catkin"),
        "arm/CMakeLists.txt": _LISTS,
        "arm/include/a.h": _CLASS.format(""),
        "arm/src/a.cpp": f'#include "a.h"\n{_NODE}',
        # What lies beside it is left over as well: it means the header that is installed.
        "arm/draft/a.cpp": f'#include "../include/a.h"\n{_NODE}',
        "arm/draft/a.h": _CLASS.format(""),
    }
    assert _units(tmp_path, files) == ["arm/src/a.cpp"]


def test_package_in_one_that_nothing_builds_is_a_package(tmp_path: Path) -> None:
    files = {
        "package.xml": package_xml("all", build_type="catkin"),
        "arm/package.xml": package_xml("arm", build_type="catkin"),
        "arm/scripts/a.py": _SCRIPT,
    }
    assert _units(tmp_path, files) == ["arm/scripts/a.py"]


def test_firmware_of_rosserial_is_no_node(tmp_path: Path) -> None:
    files = {"a.cpp": _NODE.replace("<ros/ros.h>", "<ros.h>"), "b.cpp": _NODE}
    assert _units(tmp_path, files) == ["b.cpp"]


_ROS1 = (
    "#!/usr/bin/env python\n" + NO_QUEUE + "if __name__ == '__main__':\n    rospy.init_node('a')\n"
)
_DEPENDS = "<buildtool_depend>ament_cmake</buildtool_depend>"
_PORTED = "cmake_minimum_required(VERSION 3.8)\nproject(demo)\nfind_package(ament_cmake REQUIRED)\n"


@pytest.mark.parametrize(
    ("build_type", "depends", "codes"),
    [
        ("ament_cmake", _DEPENDS, []),
        ("ament_cmake", f"{_DEPENDS}<exec_depend>rospy</exec_depend>", ["RC407", "RK503"]),
        ("catkin", "<buildtool_depend>catkin</buildtool_depend>", ["RC407"]),
    ],
)
def test_script_of_ros1_in_a_package_of_ros2_is_left_of_a_port(
    tmp_path: Path, build_type: str, depends: str, codes: list[str]
) -> None:
    root = write_tree(
        tmp_path,
        {
            "demo/package.xml": package_xml("demo", depends, build_type=build_type),
            "demo/CMakeLists.txt": f"{_PORTED}ament_package()\n",
            "demo/scripts/talker.py": _ROS1,
        },
    )
    (root / "demo/scripts/talker.py").chmod(0o755)
    assert [code for code, _ in told(run_over(root, "RC407", "RK503"))] == codes
