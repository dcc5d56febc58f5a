"""What RG101 tells of types that their package does not have."""

from __future__ import annotations

from pathlib import Path

import pytest
from graph_packages import LISTENER, TALKER, alone, code_of, in_python, node_of, package_of
from linted import run_over, write_tree
from packages import CATKIN, CATKIN_LISTS

from plastron_tui.lint.rules.package_examples import TYPES_PACKAGE

IMPORTED = "std_msgs.msg import Int32, String"


def _with(code: str, imported: str) -> str:
    return code.replace(IMPORTED, imported)


def _typed(template: str, type_: str, package: str = "std_msgs", kind: str = "msg") -> str:
    return _with(code_of(template, type=type_), f"{package}.{kind} import {type_}")


def _told(folder: Path, files: dict[str, str | bytes]) -> list[tuple[str, str, str | None, int]]:
    found = [each.diagnostic for each in run_over(write_tree(folder, files), "RG101").told]
    assert all(each.file is not None for each in found)
    return [
        (each.file.name, each.message, each.help, len(each.labels)) for each in found if each.file
    ]


def _finding(file: str, package: str, name: str, meant: str) -> tuple[str, str, str, int]:
    return file, f"`{package}` has no type `{name}`", f"did you mean `{meant}`?", 0


LAUNCHED = {"some_py": in_python(node_of("talker"), node_of("listener"))}
RIGHT = _typed(LISTENER, "Float32")
SIDES = {
    "the_publisher": (_typed(TALKER, "Flot32"), RIGHT, "talker.py"),
    "the_subscription": (_typed(TALKER, "Float32"), _typed(LISTENER, "Flot32"), "listener.py"),
    "one_that_has_nobody": (_typed(TALKER, "Flot32"), code_of(LISTENER, topic="x"), "talker.py"),
    # What else is wrong is told when the type is one.
    "one_of_another_type": (_typed(TALKER, "Flot32"), "", "talker.py"),
}


@pytest.mark.parametrize(("talker", "listener", "file"), SIDES.values(), ids=SIDES)
@pytest.mark.parametrize("launches", [{}, LAUNCHED], ids=["by_hand", "launched"])
def test_a_type_that_is_none_is_told_where_it_is_used(
    tmp_path: Path, talker: str, listener: str, file: str, launches: dict[str, str]
) -> None:
    found = _told(tmp_path, package_of(talker, listener, **launches))
    assert found == [_finding(file, "std_msgs", "Flot32", "Float32")]


def test_a_service_of_a_type_that_is_none(tmp_path: Path) -> None:
    calls = "self.cli = self.create_client(Triger, 'reset')"
    serves = "self.srv = self.create_service(Trigger, 'reset', print)"
    talker = _with(code_of(TALKER, more=calls), f"{IMPORTED}\nfrom std_srvs.srv import Triger")
    listener = _with(
        code_of(LISTENER, before=serves), f"{IMPORTED}\nfrom std_srvs.srv import Trigger"
    )
    found = _told(tmp_path, package_of(talker, listener))
    assert found == [_finding("talker.py", "std_srvs", "Triger", "Trigger")]


def test_one_that_is_meant_is_the_partner_of_others(tmp_path: Path) -> None:
    files = {
        **alone("talks", "rclpy", _typed(TALKER, "Flot32")),
        **alone("hears", "talks", RIGHT),
        **alone("speaks", "hears", code_of(TALKER, type="Int32")),
        **alone("counts", "hears", code_of(LISTENER, type="Int32")),
    }
    assert _told(tmp_path, files) == [_finding("node.py", "std_msgs", "Flot32", "Float32")]


OWN = {
    name.replace("demo/", "shapes/"): text.replace(">demo<", ">shapes<").replace(
        "(demo)", "(shapes)"
    )
    for name, text in TYPES_PACKAGE.items()
}
SILENT = {
    "no_near_name": ("std_msgs", "Elephant", {}),
    "a_package_that_is_not_known": ("old_msgs", "Flot32", {}),
    "a_package_that_is_known_in_part": ("mavros_msgs", "ExtendedStat", {}),
    "a_definition_with_a_mistake": ("shapes", "Speeds", {"shapes/msg/Speeds.msg": "nothing x\n"}),
    "a_definition_elsewhere": ("shapes", "Speeds", {"shapes/more/Speeds.msg": "int8 x\n"}),
    "a_definition_that_is_made": ("shapes", "Speeds", {"shapes/msg/Speeds.msg.in": "int8 x\n"}),
    "a_definition_that_cmake_names": (
        "shapes",
        "Speeds",
        {
            "shapes/CMakeLists.txt": OWN["shapes/CMakeLists.txt"].replace(
                '"msg/Speed.msg"', '"msg/Speed.msg" "msg/Speeds.msg"'
            )
        },
    ),
    "a_package_that_two_have": (
        "shapes",
        "Speeds",
        {f"again/{name}": text for name, text in OWN.items()},
    ),
}


@pytest.mark.parametrize(("package", "type_", "more"), SILENT.values(), ids=SILENT)
def test_a_type_that_may_be_one(
    tmp_path: Path, package: str, type_: str, more: dict[str, str]
) -> None:
    files = package_of(_typed(TALKER, type_, package), code_of(LISTENER, topic="x"))
    assert _told(tmp_path, files | OWN | more) == []


@pytest.mark.parametrize(
    ("type_", "told"),
    [("WaypointPul", []), ("Triger", [("std_srvs", "Triger", "Trigger")])],
    ids=["known_in_part", "known_wholly"],
)
def test_a_service_of_a_package(
    tmp_path: Path, type_: str, told: list[tuple[str, str, str]]
) -> None:
    package = "std_srvs" if told else "mavros_msgs"
    calls = f"self.cli = self.create_client({type_}, 'reset')"
    talker = _with(code_of(TALKER, more=calls), f"{IMPORTED}\nfrom {package}.srv import {type_}")
    assert _told(tmp_path, package_of(talker)) == [_finding("talker.py", *each) for each in told]


@pytest.mark.parametrize(
    ("imported", "is_told"), [("Flot32", True), ("*\nfrom helpers import *", False)]
)
def test_a_type_is_a_guess_where_modules_are_imported_whole(
    tmp_path: Path, imported: str, is_told: bool
) -> None:
    talker = _with(code_of(TALKER, type="Flot32"), f"std_msgs.msg import {imported}")
    found = _told(tmp_path, package_of(talker, code_of(LISTENER, topic="x")))
    assert found == [_finding("talker.py", "std_msgs", "Flot32", "Float32")] * is_told


@pytest.mark.parametrize(("type_", "is_told"), [("PlanGoal", False), ("Route", True)])
def test_a_part_of_an_action_is_a_type_of_ros_1(tmp_path: Path, type_: str, is_told: bool) -> None:
    node = (
        f"#!/usr/bin/env python3\nimport rospy\nfrom old.msg import {type_}\n"
        f"rospy.init_node('mover')\npub = rospy.Publisher('goals', {type_}, queue_size=1)\n"
        "rospy.spin()\n"
    )
    defined = "add_action_files(\n  FILES\n  Plan.action\n)\nadd_message_files(\n  FILES\n"
    files = {
        **CATKIN,
        "old/CMakeLists.txt": CATKIN_LISTS.replace(
            "add_message_files(\n  FILES\n", f"{defined}  PlanGoals.msg\n  Routes.msg\n"
        ),
        "old/action/Plan.action": "int8 x\n---\n---\n",
        "old/msg/PlanGoals.msg": "int8 x\n",
        "old/msg/Routes.msg": "int8 x\n",
        "old/scripts/mover.py": node,
    }
    assert _told(tmp_path, files) == [_finding("mover.py", "old", type_, f"{type_}s")] * is_told


def test_a_type_of_a_package_of_the_workspace(tmp_path: Path) -> None:
    files = package_of(_typed(TALKER, "Speeds", "shapes"), code_of(LISTENER, topic="x"))
    assert _told(tmp_path, files | OWN) == [_finding("talker.py", "shapes", "Speeds", "Speed")]


def test_a_type_that_a_test_makes_itself(tmp_path: Path) -> None:
    files = {"demo/test/talker.py": _typed(TALKER, "Flot32")}
    assert _told(tmp_path, package_of() | files) == []
