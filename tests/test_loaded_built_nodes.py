"""Nodes that a package builds: what programs put into it, and take out again."""

from __future__ import annotations

from pathlib import Path

import pytest
from loaded_packages import lay, run, texts
from machine import mostly_long

XML = """\
<?xml version="1.0"?>
<package format="3">
  <name>demo</name>
  <version>0.1.0</version>
  <description>Says hello.</description>
  <maintainer email="ada@example.com">Ada</maintainer>
  <license>MIT</license>
  <buildtool_depend>{tool}</buildtool_depend>
  <depend>{client}</depend>{more}
</package>
"""
AMENT_EXPORT = """

  <export>
    <build_type>ament_cmake</build_type>
  </export>"""
CATKIN_BARE = "project(demo)\nfind_package(catkin REQUIRED)\ncatkin_package()\n"
CATKIN_FULL = """\
cmake_minimum_required(VERSION 3.0.2)
project(demo)

find_package(catkin REQUIRED COMPONENTS
  roscpp
)

catkin_package(
  CATKIN_DEPENDS roscpp
)

include_directories(${catkin_INCLUDE_DIRS})

## Nodes
add_executable(listener src/listener.cpp)
target_link_libraries(listener ${catkin_LIBRARIES})

install(TARGETS listener
  RUNTIME DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION}
)
"""
AMENT_BARE = "project(demo)\nfind_package(ament_cmake REQUIRED)\n\nament_package()\n"
AMENT_FULL = """\
cmake_minimum_required(VERSION 3.8)
project(demo)

find_package(ament_cmake REQUIRED)
find_package(rclcpp REQUIRED)

add_executable(listener src/listener.cpp)
ament_target_dependencies(listener rclcpp)

install(TARGETS
  listener
  DESTINATION lib/${PROJECT_NAME}
)

if(BUILD_TESTING)
  find_package(ament_lint_auto REQUIRED)
endif()

ament_package()
"""
KINDS = {
    "catkin, bare": ("catkin", "roscpp", CATKIN_BARE),
    "catkin, full": ("catkin", "roscpp", CATKIN_FULL),
    "ament, bare": ("ament_cmake", "rclcpp", AMENT_BARE),
    "ament, full": ("ament_cmake", "rclcpp", AMENT_FULL),
}
LIBRARIES = {"catkin": ("roscpp", "nodelet"), "ament_cmake": ("rclcpp", "component")}
CASES = [(kind, library) for kind, (tool, _, _) in KINDS.items() for library in LIBRARIES[tool]]
ENDS = ("\n", "\r\n") * (len(CASES) // 2)


def package(kind: str) -> dict[str, str]:
    tool, client, lists = KINDS[kind]
    header = "ros/ros.h" if client == "roscpp" else "rclcpp/rclcpp.hpp"
    more = AMENT_EXPORT if tool == "ament_cmake" else ""
    files = {
        "package.xml": XML.format(tool=tool, client=client, more=more),
        "CMakeLists.txt": lists,
    }
    if "listener" in lists:
        files["src/listener.cpp"] = f"#include <{header}>\n\nint main() {{}}\n"
    return files


def program(library: str) -> str:
    return (
        f"create_node 'talker' as talker using {library}\n"
        'create_message greeting of message_type String and input "hello"\n'
        "talker publish greeting to 'chatter' of message_type String at 2 hz\n"
        "load_package 'demo' as demo\ndemo contains talker\ngenerate_package demo\n"
    )


OUT = "load_package 'demo' as demo\ndemo no_longer_contains 'talker'\ngenerate_package demo\n"


@pytest.mark.parametrize(
    ("kind", "library", "end"), [(*case, end) for case, end in zip(CASES, ENDS, strict=True)]
)
def test_what_is_put_in_place_is_taken_out_to_the_byte(
    kind: str, library: str, end: str, tmp_path: Path
) -> None:
    files = {name: text.replace("\n", end).encode() for name, text in package(kind).items()}
    folder = lay(tmp_path, files)
    before = texts(folder)
    assert run(program(library), tmp_path, library, in_place=True) == ()
    after = texts(folder)
    new = set(after) - set(before)
    assert all(after[name] != before[name] for name in ("CMakeLists.txt", "package.xml"))
    told = run(OUT, tmp_path, library, in_place=True)
    assert {each.code for each in told} == {"file-stays"}
    assert {each.message.split("`")[1] for each in told} == new
    assert texts(folder) == {**before, **{name: after[name] for name in new}}
    # And in again, as it was.
    run(program(library), tmp_path, library, in_place=True)
    assert texts(folder) == after


def test_what_another_node_needs_by_now_stays(tmp_path: Path) -> None:
    folder = lay(tmp_path, package("ament, full"))
    run(program("rclcpp"), tmp_path, "rclcpp", in_place=True)
    lay(tmp_path, {"src/listener.cpp": "#include <std_msgs/msg/string.hpp>\n"})
    run(OUT, tmp_path, "rclcpp", in_place=True)
    now = texts(folder)
    assert b"find_package(std_msgs REQUIRED)" in now["CMakeLists.txt"]
    assert b"<depend>std_msgs</depend>" in now["package.xml"]
    assert b"talker" not in now["CMakeLists.txt"]


LAUNCHED = {
    "roscpp": '<node pkg="demo" type="{name}" name="talker"/>',
    "nodelet": '<node pkg="nodelet" type="nodelet" name="t" args="load {name} /all"/>',
    "rclcpp": '<node pkg="demo" exec="{name}"/>',
    "component": (
        '<node_container pkg="rclcpp_components" exec="component_container" name="all" '
        'namespace=""><composable_node pkg="demo" plugin="{name}"/></node_container>'
    ),
}


@pytest.mark.parametrize(
    ("library", "name", "verb"),
    [
        ("roscpp", "talker", "starts"),
        ("nodelet", "demo/TalkerNode", "loads"),
        ("rclcpp", "talker", "starts"),
        ("component", "demo::TalkerNode", "starts"),
    ],
)
def test_a_launch_file_that_starts_or_loads_what_is_taken_out_is_told(
    library: str, name: str, verb: str, tmp_path: Path
) -> None:
    kind = "catkin, full" if library in LIBRARIES["catkin"] else "ament, full"
    lay(tmp_path, package(kind))
    run(program(library), tmp_path, library, in_place=True)
    lines = (name, f"{name}s")
    nodes = "\n".join(LAUNCHED[library].format(name=each) for each in lines)
    file = "a.launch" if kind.startswith("catkin") else "a.launch.xml"
    lay(tmp_path, {f"launch/{file}": f"<launch>\n{nodes}\n</launch>\n"})
    told = run(OUT, tmp_path, library, in_place=True)
    [still] = [each.message for each in told if each.code == "still-started"]
    assert still.startswith(f"line 2 of `launch/{file}` {verb} `")


DECLARED = {
    "<build_depend>std_msgs</build_depend>": "<exec_depend>std_msgs</exec_depend>",
    "<exec_depend>std_msgs</exec_depend>": "<build_depend>std_msgs</build_depend>",
    "<build_depend>std_msgs</build_depend>\n  <exec_depend>std_msgs</exec_depend>": None,
    "<depend>std_msgs</depend>": None,
    "<test_depend>std_msgs</test_depend>": "<depend>std_msgs</depend>",
}


TAGS = [(declared, library) for declared in DECLARED for library in ("roscpp", "rclcpp")]


@pytest.mark.parametrize("way", mostly_long(TAGS, TAGS[:2]))
def test_elements_that_were_there_before_stay(tmp_path: Path, way: tuple[str, str]) -> None:
    declared, library = way
    kind = "catkin, full" if library == "roscpp" else "ament, full"
    files = package(kind)
    tag = f"<depend>{library}</depend>"
    files["package.xml"] = files["package.xml"].replace(tag, f"{tag}\n  {declared}")
    folder = lay(tmp_path, files)
    before = texts(folder)
    run(program(library), tmp_path, library, in_place=True)
    after = texts(folder)["package.xml"].decode()
    new = DECLARED[declared]
    assert after.count("std_msgs") == declared.count("std_msgs") + (new is not None)
    assert new is None or new in after
    run(OUT, tmp_path, library, in_place=True)
    assert texts(folder)["package.xml"] == before["package.xml"]
    assert texts(folder)["CMakeLists.txt"] == before["CMakeLists.txt"]


@pytest.mark.parametrize("case", mostly_long(CASES, CASES[-1:]))
def test_a_node_with_another_name_is_built_in_place_of_the_old_one(
    tmp_path: Path, case: tuple[str, str]
) -> None:
    kind, library = case
    folder = lay(tmp_path, package(kind))
    first = program(library)
    second = first.replace("create_node 'talker'", "create_node 'speaker'")
    run(first, tmp_path, library, in_place=True)
    before = texts(folder)
    told = run(second, tmp_path, library, in_place=True)
    assert {each.code for each in told} == {"file-stays"}
    assert "src/talker.cpp" in {each.message.split("`")[1] for each in told}
    after = texts(folder)
    lists = after["CMakeLists.txt"].decode()
    assert "talker" not in lists and "speaker" in lists
    assert after["src/talker.cpp"] == before["src/talker.cpp"]
    assert after["package.xml"].count(b"<depend>") == before["package.xml"].count(b"<depend>")
    assert run(second, tmp_path, library, in_place=True) == ()
    assert texts(folder) == after
    # And back.
    run(first, tmp_path, library, in_place=True)
    assert b"speaker" not in texts(folder)["CMakeLists.txt"]


def test_a_second_node_takes_nobodys_place(tmp_path: Path) -> None:
    folder = lay(tmp_path, package("ament, full"))
    run(program("rclcpp"), tmp_path, "rclcpp", in_place=True)
    both = program("rclcpp") + (
        "create_node 'other' as other using rclcpp\n"
        "subscribe other to 'chatter' of message_type String\n"
        "demo contains other\ngenerate_package demo\n"
    )
    run(both, tmp_path, "rclcpp", in_place=True)
    lists = texts(folder)["CMakeLists.txt"]
    assert b"add_executable(talker " in lists and b"add_executable(other " in lists
    # What the program no longer puts there stays.
    run(program("rclcpp"), tmp_path, "rclcpp", in_place=True)
    assert texts(folder)["CMakeLists.txt"] == lists
