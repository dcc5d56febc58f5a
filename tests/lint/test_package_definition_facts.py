"""What keeps the definitions of a package from being built."""

from __future__ import annotations

import pytest
from read_packages import Change, facts_of

from plastron_tui.model.package_facts import Place


def _place(place: Place | None) -> str:
    return "" if place is None else place.file


_REMARK = '  "srv/Reset.srv"\n'
_DEFINITIONS = [
    ("rover", {}, ""),
    ("wheels", {"msg/A.msg": "\n# a\n  int8 a\n"}, "`ament_python` builds no types, so `A` is not there|msg/A.msg|||move the definitions to a package of `ament_cmake`"),
    ("rover", {"CMakeLists.txt": "msg/Speed.msg -> msg/Sped.msg", "msg/Speed.msg": "int8 a\n"},
     'there is no `msg/Sped.msg`|CMakeLists.txt|"msg/Speed.msg"||did you mean `msg/Speed.msg`?; '
     "no command of `CMakeLists.txt` builds `Speed`|msg/Speed.msg||CMakeLists.txt|add it to `rosidl_generate_interfaces`"),
    ("rover", {"srv/Reset.srv": None}, "there is no `srv/Reset.srv`|CMakeLists.txt|||take it out, or write the definition"),
    ("rover", {"CMakeLists.txt": "srv/Reset.srv -> ${X}/Reset.srv", "srv/Reset.srv": None}, ""),
    ("rover", {"CMakeLists.txt": "srv/Reset.srv -> /abs/Reset.srv", "srv/Reset.srv": None}, ""),
    ("rover", {"CMakeLists.txt": "srv/Reset.srv -> ../Reset.srv", "srv/Reset.srv": None}, ""),
    ("rover", {"CMakeLists.txt": "srv/Reset.srv -> x:srv/Reset.srv", "srv/Reset.srv": None}, ""),
    ("rover", {"CMakeLists.txt": "srv/Reset.srv -> srv/Reset.idl", "srv/Reset.srv": None}, ""),
    ("rover", {"msg/A.msg": "int8 a\n"}, "no command of `CMakeLists.txt` builds `A`|msg/A.msg||CMakeLists.txt|add it to `rosidl_generate_interfaces`"),
    ("rover", {"msg/not-a-name.msg": "int8 a\n", "sub/msg/A.msg": "int8 a\n", "msg/A.txt": ""}, ""),
    ("rover", {"msg/A.msg": "int8 a\n", "CMakeLists.txt": f"{_REMARK} -> {_REMARK}  ${{more}}\n"}, ""),
    ("rover", {"msg/A.msg": "int8 a\n", "CMakeLists.txt": "rosidl_generate_interfaces -> if(X)\nendif()\nrosidl_generate_interfaces"},
     "no command of `CMakeLists.txt` builds `A`|msg/A.msg||CMakeLists.txt|add it to `rosidl_generate_interfaces`"),
    ("rover", {"msg/Speed.msg": "std_msgs/String a\n"},
     "`rosidl_generate_interfaces` is not told of `std_msgs`, whose types this is made of|msg/Speed.msg||CMakeLists.txt|write `std_msgs` behind `DEPENDENCIES`"),
    ("rover", {"msg/Speed.msg": "std_msgs/String a\n", "CMakeLists.txt": "DEPENDENCIES geometry_msgs -> DEPENDENCIES ${all}"}, ""),
    ("rover", {"package.xml": "  <member_of_group>rosidl_interface_packages</member_of_group>\n -> "},
     "a package that builds types is a member of the group `rosidl_interface_packages`|package.xml||CMakeLists.txt|write `<member_of_group>rosidl_interface_packages</member_of_group>`"),
    ("rover", {"package.xml": "  <member_of_group>rosidl_interface_packages</member_of_group>\n -> ",
               "CMakeLists.txt": "  DEPENDENCIES -> SKIP_GROUP_MEMBERSHIP_CHECK DEPENDENCIES"}, ""),
    ("rover", {"CMakeLists.txt": "find_package(rosidl_default_generators REQUIRED)\n -> "},
     "`rosidl_generate_interfaces` is a command of `rosidl_default_generators`, which is not found|CMakeLists.txt|||write `find_package(rosidl_default_generators REQUIRED)` before"),
    ("rover", {"CMakeLists.txt": "find_package(rosidl_default_generators REQUIRED) -> find_package(rosidl_cmake REQUIRED)"}, ""),
    ("rover", {"CMakeLists.txt": "find_package(rosidl_default_generators REQUIRED) -> find_package(ament_cmake_auto REQUIRED)"}, ""),
    ("rover", {"CMakeLists.txt": "find_package(rosidl_default_generators REQUIRED) -> find_package(${X} REQUIRED)"}, ""),
    ("rover", {"CMakeLists.txt": "find_package(rosidl_default_generators REQUIRED) -> include(tools.cmake)"}, ""),
    ("old", {}, ""),
    ("old", {"srv/A.srv": "---\n"}, "no command of `CMakeLists.txt` builds `A`|srv/A.srv|||add it to `add_service_files`"),
    ("old", {"msg/A.msg": "int8 a\n"}, "no command of `CMakeLists.txt` builds `A`|msg/A.msg||CMakeLists.txt|add it to `add_message_files`"),
    ("old", {"msg/A.msg": "int8 a\n", "CMakeLists.txt": "  FILES\n  Speed.msg\n -> "}, ""),
    ("old", {"CMakeLists.txt": "  Speed.msg -> Sped.msg", "msg/Speed.msg": "int8 a\n"},
     "there is no `msg/Sped.msg`|CMakeLists.txt|Speed.msg||did you mean `msg/Speed.msg`?; "
     "no command of `CMakeLists.txt` builds `Speed`|msg/Speed.msg||CMakeLists.txt|add it to `add_message_files`"),
    ("old", {"CMakeLists.txt": "generate_messages(DEPENDENCIES geometry_msgs)\n -> "}, "no `generate_messages` builds the types|CMakeLists.txt|||write `generate_messages` behind"),
    ("old", {"CMakeLists.txt": " message_generation -> "}, "`add_message_files` is a command of `message_generation`, which is not found|CMakeLists.txt|||write `find_package(catkin REQUIRED COMPONENTS message_generation)` before"),
    ("old", {"CMakeLists.txt": " message_generation ->  genmsg"}, ""),
    ("old", {"CMakeLists.txt": "COMPONENTS rospy -> COMPONENTS catkin_simple rospy"}, ""),
]  # fmt: skip


@pytest.mark.parametrize(
    ("package", "change", "told"), _DEFINITIONS, ids=lambda each: str(each)[:60]
)
def test_what_keeps_types_from_being_built(package: str, change: Change, told: str) -> None:
    found = [
        f"{x.message}|{_place(x.place)}|{x.remedy}|{_place(x.other)}|{x.help}"
        for x in facts_of(package, change).definitions
    ]
    assert "; ".join(found) == told


_ALONE = {
    "CMakeLists.txt": "project(rover)\nfind_package(ament_cmake REQUIRED)\n",
    "srv/Reset.srv": None,
}


@pytest.mark.parametrize(
    ("change", "told"),
    [
        ({}, "no command of `CMakeLists.txt` builds `Speed`"),
        ({"msg/A.msg": "int8 a\n"}, "no command of `CMakeLists.txt` builds `A`, nor 1 more definitions"),
        ({"CMakeLists.txt": _ALONE["CMakeLists.txt"] + "# rosidl\n"}, "no command of `CMakeLists.txt` builds `Speed`"),
        ({"CMakeLists.txt": _ALONE["CMakeLists.txt"] + "set(A rosidl_x)\n"}, ""),
        ({"CMakeLists.txt": _ALONE["CMakeLists.txt"] + "set(A genmsg)\n"}, ""),
        ({"CMakeLists.txt": _ALONE["CMakeLists.txt"] + "acme()\n"}, ""),
    ],
)  # fmt: skip
def test_package_that_builds_no_types(change: Change, told: str) -> None:
    facts = facts_of("rover", {**_ALONE, **change})
    assert "; ".join(each.message for each in facts.definitions) == told
    for each in facts.definitions:
        assert each.help == "call `rosidl_generate_interfaces` with it, or take the file out"


_COMMENTS = [("# A.msg", True), ("# was: msg/A.msg", True), ('# "A.msg"', True), ("# B.msg", False)]


@pytest.mark.parametrize(("comment", "is_taken_out"), _COMMENTS)
def test_definition_in_a_comment_is_taken_out(comment: str, is_taken_out: bool) -> None:
    for inner, outer in ((comment, ""), ("", comment)):
        change = {"msg/A.msg": "int8 a\n", "CMakeLists.txt": f"{_REMARK} -> {_REMARK}  {inner}\n"}
        if outer:
            change["CMakeLists.txt"] = f"cmake_minimum_required -> {outer}\ncmake_minimum_required"
        (found,) = facts_of("rover", change).definitions
        assert found.is_taken_out == (is_taken_out and bool(inner))


def test_definition_is_told_at_its_first_line() -> None:
    text = "\n# a\n  int8 a\n"
    (found,) = facts_of("rover", {"msg/A.msg": text}).definitions
    assert text[found.place.span.start : found.place.span.end] == "int8 a"
    (found,) = facts_of("rover", {"msg/A.msg": "# a\n"}).definitions
    assert (found.place.span.start, found.place.span.end) == (0, 0)
