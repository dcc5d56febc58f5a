"""Which files of a workspace are read, and with which others."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import pytest
from linted import NO_QUEUE, run_over, told, write_tree

from plastron_tui.lint.tree import SourceTree
from plastron_tui.project.linting import read_tree, units
from plastron_tui.project.linting.cache import FactCache
from plastron_tui.project.linting.fingerprints import Reads

PACKAGE = """\
<package format="3"><name>arm</name><version>0.1.0</version><description>d</description>
<maintainer email="a@b.cd">m</maintainer><license>MIT</license>
<export><build_type>ament_cmake</build_type></export></package>
"""
HEADER = """\
#pragma once
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/string.hpp>
class Arm : public rclcpp::Node {
 public:
  Arm();
  rclcpp::Publisher<std_msgs::msg::String>::SharedPtr pub_;
};
"""
SOURCE = """\
#include "arm/arm.hpp"
Arm::Arm() : rclcpp::Node("arm") { pub_ = create_publisher<std_msgs::msg::String>("out", 1); }
"""


def _read(folder: Path, files: Mapping[str, str]) -> SourceTree:
    root = folder / "src"
    for name, text in files.items():
        (root / name).parent.mkdir(parents=True, exist_ok=True)
        (root / name).write_text(text)
    return read_tree([root], FactCache(root, folder / "cache"), workers=1)


def _names(tree: SourceTree) -> list[str]:
    return [unit.path.name for unit in tree.units]


def test_source_that_its_header_is_read_with_is_a_unit_and_the_header_is_none(
    tmp_path: Path,
) -> None:
    files = {
        "arm/package.xml": PACKAGE,
        "arm/CMakeLists.txt": "project(arm)\nadd_library(arm src/arm.cpp)\n",
        "arm/include/arm/arm.hpp": HEADER,
        "arm/src/arm.cpp": SOURCE,
    }
    tree = _read(tmp_path, files)
    assert _names(tree) == ["arm.cpp"]
    assert [each.name for node in tree.units[0].nodes for each in node.endpoints] == ["out"]


def test_header_that_no_source_has_is_a_unit_of_its_own(tmp_path: Path) -> None:
    node = HEADER.replace("Arm();", 'Arm() : rclcpp::Node("arm") {}')
    files = {"arm/package.xml": PACKAGE, "arm/include/arm/arm.hpp": node}
    assert _names(_read(tmp_path, files)) == ["arm.hpp"]


@pytest.mark.parametrize(
    ("error", "why"),
    [
        (RecursionError(), "it is nested too deep"),
        (MemoryError(), "it takes too much memory"),
        (KeyError("x"), "plastron fails at it (KeyError: 'x')"),
    ],
)
def test_file_that_breaks_its_reader_is_told_of_and_the_others_are_read(
    error: Exception, why: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def read(path: Path, reads: Reads) -> units.UnitRead | None:
        if path.name == "bad.py":
            raise error
        return usual(path, reads)

    usual = units._read
    monkeypatch.setattr(units, "_read", read)
    node = "import rclpy\nnode = rclpy.create_node('a')\n"
    tree = _read(tmp_path, {"bad.py": node, "good.py": node})
    assert _names(tree) == ["good.py"]
    assert [(path.name, said) for path, said in tree.problems] == [("bad.py", why)]
    # What nobody provides may be provided in there.
    assert not tree.is_whole
    monkeypatch.undo()
    assert _names(_read(tmp_path, {})) == ["bad.py", "good.py"]


def test_what_is_not_read_is_told_by_each_run(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def read(path: Path, reads: Reads) -> units.UnitRead | None:
        raise RecursionError

    monkeypatch.setattr(units, "_read", read)
    root = write_tree(tmp_path, {"bad.py": NO_QUEUE})
    for _ in ("first", "again"):
        run = run_over(root)
        assert told(run) == []
        assert [each.code for each in run.diagnostics] == ["unreadable-file"]
    monkeypatch.undo()
    assert told(run_over(root)) == [("RC407", 3)]


@pytest.mark.parametrize(
    ("place", "is_test"),
    [("test/a.py", True), ("a/tests/b.py", True), ("test_a.py", True), ("a.py", False)],
)
def test_test_is_told_by_where_it_is_below_the_workspace(
    place: str, tmp_path: Path, *, is_test: bool
) -> None:
    folder = tmp_path / "test"
    (folder / "src").mkdir(parents=True)
    (unit,) = _read(folder, {place: "import rclpy\nrclpy.create_node('a')\n"}).units
    assert unit.is_test == is_test


LISTS = """\
cmake_minimum_required(VERSION 3.8)
project(arm)
find_package(ament_cmake REQUIRED)
install(PROGRAMS src/b.py DESTINATION lib/arm)
ament_package()
"""


@pytest.mark.parametrize(
    ("package", "place", "is_test"),
    [
        # People start the nodes of a package that is called by what it tries out.
        ("arm_system_tests", "src/a.py", False),
        ("arm_system_tests", "other/a.py", True),
        ("arm_system_tests", "src/test/a.py", True),
        ("arm_system_tests", "src/test_a.py", True),
        ("arm_tests/arm", "src/a.py", True),
        ("tests", "src/a.py", True),
        ("arm/test", "src/a.py", True),
    ],
)
def test_package_may_be_called_as_tests_are(
    package: str, place: str, tmp_path: Path, *, is_test: bool
) -> None:
    files = {
        f"{package}/package.xml": PACKAGE,
        f"{package}/CMakeLists.txt": LISTS,
        f"{package}/src/b.py": "print()\n",
        f"{package}/{place}": "import rclpy\nrclpy.create_node('a')\n",
    }
    (unit,) = _read(tmp_path, files).units
    assert unit.is_test == is_test


@pytest.mark.parametrize("workers", [1, 2])
def test_how_far_reading_is_told(tmp_path: Path, workers: int) -> None:
    root = write_tree(tmp_path, {f"{at}.py": "import rospy\n" for at in range(30)})
    told: list[tuple[int, int]] = []
    cache = FactCache(root, tmp_path / "cache")
    for _ in range(2):
        read_tree([root], cache, workers, progress=lambda *each: told.append(each))
    # The second time nothing has to be read.
    assert told == [(done, 30) for done in range(1, 31)]
