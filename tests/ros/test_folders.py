from __future__ import annotations

import re
from pathlib import Path

import pytest

from plastron_tui.ros.catalog import Catalog, installed_folders
from plastron_tui.ros.interfaces import InterfaceKind, InterfaceName

MESSAGE, SERVICE = InterfaceKind.MESSAGE, InterfaceKind.SERVICE


def write(root: Path, files: dict[str, str]) -> Path:
    for name, text in files.items():
        file = root / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
    return root


def own(catalog: Catalog, kind: InterfaceKind = MESSAGE) -> list[str]:
    builtin = set(Catalog(catalog.distribution).names(kind))
    return [str(name) for name in catalog.names(kind) if name not in builtin]


# (files, the folder that is given, the messages that are found)
LAYOUTS = [
    ({"pkg/msg/A.msg": "int8 x"}, ".", ["pkg/A"]),
    ({"pkg/msg/A.msg": "int8 x"}, "pkg", ["pkg/A"]),
    ({"pkg/msg/A.msg": "int8 x"}, "pkg/msg", ["pkg/A"]),
    ({"src/repo/pkg/msg/A.msg": "int8 x"}, ".", ["pkg/A"]),
    (
        {
            "dir/msg/A.msg": "",
            "dir/package.xml": "<p><!-- <name>no</name> --><name> pkg </name></p>",
        },
        ".",
        ["pkg/A"],
    ),
    ({"dir/msg/A.msg": "", "dir/package.xml": "not xml"}, "dir", ["dir/A"]),
    ({"share/pkg/msg/A.msg": "", "share/pkg/deep/er/msg/B.msg": ""}, "share", ["pkg/A"]),
    ({"pkg/msg/not a type.msg": "", "pkg/msg/B.txt": "", "pkg/msg/C.msg": ""}, ".", ["pkg/C"]),
    ({"old/COLCON_IGNORE": "", "old/pkg/msg/A.msg": "", "b/msg/B.msg": ""}, ".", ["b/B"]),
    ({".git/pkg/msg/A.msg": ""}, ".", []),
    ({"pkg/package.xml": "<name>pkg</name>", "pkg/test/inner/msg/A.msg": ""}, ".", []),
    ({"My Robot-2/A.msg": "", "My Robot-2/deeper/B.msg": ""}, "My Robot-2", ["my_robot_2/A"]),
    ({"7/A.msg": ""}, "7", ["package_7/A"]),
    ({"dir/A.msg": "", "dir/package.xml": "<name>pkg</name>"}, "dir", ["pkg/A"]),
    ({"dir/A.msg": "", "dir/msg/B.msg": ""}, "dir", ["dir/A", "dir/B"]),
    ({"share/A.msg": ""}, "share", []),
    ({"README": ""}, ".", []),
    ({"README": ""}, "missing", []),
    ({"README": ""}, "README", []),
]


@pytest.mark.parametrize(("files", "folder", "found"), LAYOUTS)
def test_a_layout(tmp_path: Path, files: dict[str, str], folder: str, found: list[str]) -> None:
    write(tmp_path, files)
    assert own(Catalog("noetic", [tmp_path / folder])) == found


def test_definitions_beside_the_program(tmp_path: Path) -> None:
    root = write(
        tmp_path / "rover", {"Wheel.msg": "int8 x", "Park.srv": "---", "Dig.action": "---\n---"}
    )
    catalog = Catalog("noetic", [root])
    assert catalog.candidates("Wheel", MESSAGE) == (InterfaceName("rover", "Wheel"),)
    assert catalog.find(InterfaceName("rover", "Park"), SERVICE) is not None
    assert catalog.find(InterfaceName("rover", "Dig"), InterfaceKind.ACTION) is not None
    assert catalog.problems == []


def test_a_circle_of_symbolic_links_ends(tmp_path: Path) -> None:
    write(tmp_path, {"a/pkg/msg/A.msg": "int8 x"})
    (tmp_path / "a/again").symlink_to(tmp_path)
    assert own(Catalog("noetic", [tmp_path])) == ["pkg/A"]


def test_own_types_are_found_and_may_nest_others(tmp_path: Path) -> None:
    write(
        tmp_path,
        {
            "pkg/msg/A.msg": "Header header\nB[] parts\n",
            "pkg/msg/B.msg": "geometry_msgs/Pose pose\n",
            "pkg/srv/Ask.srv": "A what\n---\nbool yes\n",
        },
    )
    catalog = Catalog("noetic", [tmp_path])
    ask = catalog.find(InterfaceName("pkg", "Ask"), SERVICE)
    assert ask is not None
    assert str(ask.fields[0].type) == "pkg/A"
    assert catalog.problems == []
    assert catalog.candidates("A", MESSAGE) == (InterfaceName("pkg", "A"),)


def test_the_packages_of_the_distribution_stay_and_borrowed_ones_give_way(tmp_path: Path) -> None:
    write(
        tmp_path,
        {
            "std_msgs/msg/String.msg": "int8 not_a_string\n",
            "std_msgs/msg/Extra.msg": "int8 x\n",
            "basics/srv/WordCount.srv": "string text\n---\nuint32 count\n",
        },
    )
    catalog = Catalog("noetic", [tmp_path])
    string = catalog.find(InterfaceName("std_msgs", "String"), MESSAGE)
    count = catalog.find(InterfaceName("basics", "WordCount"), SERVICE)
    assert string is not None
    assert count is not None
    assert string.fields[0].name == "data"
    assert count.fields[0].name == "text"
    assert catalog.find(InterfaceName("std_msgs", "Extra"), MESSAGE) is not None


def test_an_own_type_makes_a_bare_name_ambiguous(tmp_path: Path) -> None:
    catalog = Catalog("jazzy", [write(tmp_path, {"pkg/msg/Imu.msg": "int8 x"})])
    meanings = [str(name) for name in catalog.candidates("Imu", MESSAGE)]
    assert meanings == ["pkg/Imu", "sensor_msgs/Imu"]


def test_the_first_folder_wins(tmp_path: Path) -> None:
    write(tmp_path, {"one/pkg/msg/A.msg": "int8 first", "two/pkg/msg/A.msg": "int8 second"})
    catalog = Catalog("noetic", [tmp_path / "one", tmp_path / "two"])
    found = catalog.find(InterfaceName("pkg", "A"), MESSAGE)
    assert found is not None
    assert found.fields[0].name == "first"


# (definitions, messages of the problems that looking for pkg/A gives)
BROKEN = [
    ({"A": "int8"}, ["this line is neither a field, a constant, nor a comment"]),
    ({"A": "B b", "B": "int8 X y"}, ["a field of ROS 1 has no default value"]),
    ({"A": "A a"}, ["`pkg/A` contains itself, in field `a`"]),
    ({"A": "B b", "B": "A[] a"}, ["`pkg/B` contains itself, in field `a`"]),
    ({"A": "Strin s"}, ["field `s` is of type `pkg/Strin`, which does not exist"]),
    ({"A": "Pose p"}, ["field `p` is of type `pkg/Pose`, which does not exist"]),
    (
        {f"A{i}" if i else "A": f"A{i + 1} a" for i in range(400)} | {"A400": "int8 x"},
        ["`pkg/A50` is a message within too many others"],
    ),
]


@pytest.mark.parametrize(("definitions", "messages"), BROKEN)
def test_a_broken_type_is_reported_once_and_not_found(
    tmp_path: Path, definitions: dict[str, str], messages: list[str]
) -> None:
    write(tmp_path, {f"pkg/msg/{name}.msg": text for name, text in definitions.items()})
    catalog = Catalog("noetic", [tmp_path])
    for _ in range(2):
        assert catalog.find(InterfaceName("pkg", "A"), MESSAGE) is None
    assert [problem.message for problem in catalog.problems] == messages
    assert all(problem.file is not None for problem in catalog.problems)
    assert catalog.find(InterfaceName("std_msgs", "String"), MESSAGE) is not None


def test_help_for_a_message_of_another_package(tmp_path: Path) -> None:
    catalog = Catalog("noetic", [write(tmp_path, {"pkg/msg/A.msg": "Pose p"})])
    catalog.find(InterfaceName("pkg", "A"), MESSAGE)
    assert catalog.problems[0].help == "write `geometry_msgs/Pose`"


def test_a_folder_that_is_named_like_a_file(tmp_path: Path) -> None:
    (tmp_path / "pkg/msg/A.msg").mkdir(parents=True)
    catalog = Catalog("noetic", [tmp_path])
    assert catalog.find(InterfaceName("pkg", "A"), MESSAGE) is None
    assert "cannot be read" in catalog.problems[0].message


def test_installed_folders(tmp_path: Path) -> None:
    for name in ("ros1/share", "ws/src", "ros2/share"):
        (tmp_path / name).mkdir(parents=True)
    environ = {
        "ROS_PACKAGE_PATH": f"{tmp_path}/ws/src:{tmp_path}/ros1/share::{tmp_path}/gone",
        "AMENT_PREFIX_PATH": f"{tmp_path}/ros2:{tmp_path}/ros2",
    }
    ros1 = (tmp_path / "ws/src", tmp_path / "ros1/share")
    ros2 = (tmp_path / "ros2/share",)
    assert installed_folders(environ, 1) == ros1
    assert installed_folders(environ, 2) == ros2
    assert installed_folders(environ) == ros1 + ros2
    assert installed_folders({}) == ()


@pytest.mark.parametrize("folder", ["my ws-1", "x\nprint('no')\nfrom y", "class", "größe", "1st"])
def test_a_package_is_named_as_a_package_can_be(tmp_path: Path, folder: str) -> None:
    root = tmp_path / folder / "msg"
    root.mkdir(parents=True)
    (root / "Own.msg").write_text("int8 x\n")
    catalog = Catalog("noetic", [tmp_path / folder])
    (name,) = catalog.candidates("Own", InterfaceKind.MESSAGE)
    assert re.fullmatch("[a-z][a-z0-9_]*", name.package)
