"""C++ nodes that are changed in place: their packages build with what they come to need."""

from __future__ import annotations

import pytest
from loaded_packages import lay, run, texts
from machine import mostly_long

PACKAGE_XML = """\
<?xml version="1.0"?>
<package format="3">
  <name>demo</name>
  <version>0.1.0</version>
  <description>Talks.</description>
  <maintainer email="ada@example.com">Ada</maintainer>
  <license>MIT</license>
  <buildtool_depend>{build}</buildtool_depend>
  <depend>{library}</depend>
  <depend>std_msgs</depend>
  <export><build_type>{build}</build_type></export>
</package>
"""
TALKER = {
    "roscpp": """\
#include <ros/ros.h>
#include <std_msgs/String.h>

int main(int argc, char** argv)
{
  ros::init(argc, argv, "talker");
  ros::NodeHandle nh;
  ros::Publisher chatter_pub = nh.advertise<std_msgs::String>("chatter", 10);
  ros::spin();
}
""",
    "rclcpp": """\
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("talker");
  auto chatter_pub = node->create_publisher<std_msgs::msg::String>("chatter", 10);
  rclcpp::spin(node);
  rclcpp::shutdown();
}
""",
}
CATKIN = """\
cmake_minimum_required(VERSION 3.0.2)
project(demo)
find_package(catkin REQUIRED COMPONENTS roscpp std_msgs)  # to build
catkin_package()
include_directories(${catkin_INCLUDE_DIRS})
add_executable(talker src/talker.cpp)
target_link_libraries(talker ${catkin_LIBRARIES})
"""
AMENT = """\
cmake_minimum_required(VERSION 3.8)
project(demo)
find_package(ament_cmake REQUIRED)
find_package(rclcpp REQUIRED)  # the client library
find_package(std_msgs REQUIRED)

add_executable(talker src/talker.cpp)
LINKED
install(TARGETS talker DESTINATION lib/${PROJECT_NAME})
ament_package()
"""
LINKED = {
    "ament_target_dependencies(talker rclcpp std_msgs)": (
        "ament_target_dependencies(talker rclcpp sensor_msgs std_msgs)"
    ),
    "ament_target_dependencies(talker\n  rclcpp\n  std_msgs\n)": (
        "ament_target_dependencies(talker\n  rclcpp\n  sensor_msgs\n  std_msgs\n)"
    ),
    "target_link_libraries(talker rclcpp::rclcpp ${std_msgs_TARGETS})": (
        "target_link_libraries(talker rclcpp::rclcpp ${sensor_msgs_TARGETS} ${std_msgs_TARGETS})"
    ),
    "set(needed rclcpp std_msgs)\nament_target_dependencies(talker ${needed})": (
        "set(needed rclcpp sensor_msgs std_msgs)\nament_target_dependencies(talker ${needed})"
    ),
}
PROGRAM = "load 'demo/src/talker.cpp' as talker\n{}generate_node talker\n"
HEARS = PROGRAM.format("subscribe talker to 'imu' of message_type sensor_msgs/Imu\n")


def package(folder, library, lists):
    build = "catkin" if library == "roscpp" else "ament_cmake"
    xml = PACKAGE_XML.format(build=build, library=library)
    files = {"package.xml": xml, "CMakeLists.txt": lists, "src/talker.cpp": TALKER[library]}
    return lay(folder, files)


def changed(folder, program, library):
    """Return the lines that come and go in the package's files, without the node's."""
    before = texts(folder / "demo")
    assert not [x for x in run(program, folder, library, in_place=True) if x.severity == "error"]
    after = texts(folder / "demo")
    found = []
    for name in ("CMakeLists.txt", "package.xml"):
        old, new = before[name].decode().splitlines(), after[name].decode().splitlines()
        found += [f"+{x}" for x in new if x not in old] + [f"-{x}" for x in old if x not in new]
    return found


def test_catkin_gets_a_component(tmp_path):
    package(tmp_path, "roscpp", CATKIN)
    assert changed(tmp_path, HEARS, "roscpp") == [
        "+find_package(catkin REQUIRED COMPONENTS roscpp sensor_msgs std_msgs)  # to build",
        "-find_package(catkin REQUIRED COMPONENTS roscpp std_msgs)  # to build",
        "+  <depend>sensor_msgs</depend>",
    ]


@pytest.mark.parametrize("before", LINKED, ids=["words", "lines", "targets", "variable"])
def test_ament_finds_a_package_and_builds_with_it(tmp_path, before):
    package(tmp_path, "rclcpp", AMENT.replace("LINKED", before))
    changed(tmp_path, HEARS, "rclcpp")
    found = "find_package(sensor_msgs REQUIRED)\nfind_package(std_msgs REQUIRED)"
    wanted = AMENT.replace("find_package(std_msgs REQUIRED)", found)
    lists = texts(tmp_path / "demo")["CMakeLists.txt"].decode()
    assert lists == wanted.replace("LINKED", LINKED[before])


def test_what_is_found_already_stays(tmp_path):
    package(tmp_path, "roscpp", CATKIN)
    program = PROGRAM.format("subscribe talker to 'mode' of message_type String\n")
    assert changed(tmp_path, program, "roscpp") == []


def test_a_second_run_changes_nothing(tmp_path):
    package(tmp_path, "rclcpp", AMENT.replace("LINKED", next(iter(LINKED))))
    changed(tmp_path, HEARS, "rclcpp")
    once = texts(tmp_path / "demo")
    assert changed(tmp_path, HEARS, "rclcpp") == []
    assert texts(tmp_path / "demo") == once


def test_the_output_folder_leaves_the_package_alone(tmp_path):
    package(tmp_path, "roscpp", CATKIN)
    before = texts(tmp_path / "demo")
    run(HEARS, tmp_path, "roscpp")
    assert texts(tmp_path / "demo") == before


def test_a_package_that_cannot_be_read_is_told(tmp_path):
    folder = package(tmp_path, "roscpp", CATKIN)
    text = (folder / "package.xml").read_text().replace("<version>0.1.0</version>", "")
    (folder / "package.xml").write_text(text)
    before = texts(folder)
    told = run(HEARS, tmp_path, "roscpp", in_place=True)
    assert [(x.severity, x.file) for x in told] == [("warning", folder / "package.xml")]
    after = texts(folder)
    assert {name for name in after if after[name] != before[name]} == {"src/talker.cpp"}


NOTHING = PROGRAM.format("")
LISTS = [("roscpp", CATKIN), *(("rclcpp", AMENT.replace("LINKED", each)) for each in LINKED)]


HAD = "<build_depend>sensor_msgs</build_depend>\n  "
WAYS = [(*each, *way) for each in LISTS for way in (("", "\n"), (HAD, "\n"), (HAD, "\r\n"))]


@pytest.mark.parametrize("way", mostly_long(WAYS, [WAYS[2], WAYS[3]]))
def test_what_came_with_an_endpoint_goes_with_it(tmp_path, way):
    library, lists, declared, end = way
    folder = package(tmp_path, library, lists)
    tag = "<depend>std_msgs</depend>"
    xml = (folder / "package.xml").read_text().replace(tag, f"{declared}{tag}")
    for path, text in (("package.xml", xml), ("CMakeLists.txt", lists)):
        (folder / path).write_bytes(text.replace("\n", end).encode())
    before = texts(folder)
    for _ in range(2):
        run(HEARS, tmp_path, library, in_place=True)
        after = texts(folder)
        assert all(after[name] != before[name] for name in before)
        run(NOTHING, tmp_path, library, in_place=True)
        assert texts(folder) == before


def test_what_another_node_includes_stays(tmp_path):
    folder = package(tmp_path, "rclcpp", AMENT.replace("LINKED", next(iter(LINKED))))
    run(HEARS, tmp_path, "rclcpp", in_place=True)
    (folder / "src/other.cpp").write_text("#include <sensor_msgs/msg/image.hpp>\n")
    lists = texts(folder)["CMakeLists.txt"]
    assert changed(tmp_path, NOTHING, "rclcpp") == []
    assert texts(folder)["CMakeLists.txt"] == lists
    # Once that is gone too, so is what came.
    (folder / "src/other.cpp").unlink()
    assert changed(tmp_path, NOTHING, "rclcpp") == [
        "+ament_target_dependencies(talker rclcpp std_msgs)",
        "-find_package(sensor_msgs REQUIRED)",
        "-ament_target_dependencies(talker rclcpp sensor_msgs std_msgs)",
        "-  <depend>sensor_msgs</depend>",
    ]


BESIDE = f"load_package 'demo' as demo\n{HEARS}generate_package demo\n"
BESIDE_NOTHING = f"load_package 'demo' as demo\n{NOTHING}generate_package demo\n"


@pytest.mark.parametrize("library", ["roscpp", "rclcpp"])
def test_a_package_that_is_loaded_too_gets_what_its_nodes_need(tmp_path, library):
    lists = CATKIN if library == "roscpp" else AMENT.replace("LINKED", next(iter(LINKED)))
    folder = package(tmp_path, library, lists)
    before = texts(folder)
    found = changed(tmp_path, BESIDE, library)
    assert "+  <depend>sensor_msgs</depend>" in found
    assert any("sensor_msgs" in each and "CMake" not in each for each in found[:2])
    after = texts(folder)
    assert changed(tmp_path, BESIDE, library) == []
    assert texts(folder) == after
    changed(tmp_path, BESIDE_NOTHING, library)
    assert texts(folder) == before


@pytest.mark.parametrize("library", ["roscpp", "rclcpp"])
def test_the_copy_of_a_loaded_package_gets_it_too(tmp_path, library):
    lists = CATKIN if library == "roscpp" else AMENT.replace("LINKED", next(iter(LINKED)))
    before = texts(package(tmp_path, library, lists))
    run(BESIDE, tmp_path, library)
    assert texts(tmp_path / "demo") == before
    copy = texts(tmp_path / "output/demo")
    assert b"<depend>sensor_msgs</depend>" in copy["package.xml"]
    assert b"sensor_msgs" in copy["CMakeLists.txt"] and b"sensor_msgs" in copy["src/talker.cpp"]
    run(BESIDE_NOTHING, tmp_path, library)
    assert {**texts(tmp_path / "output/demo"), **before} == texts(tmp_path / "output/demo")


def test_what_was_there_before_stays(tmp_path):
    lists = AMENT.replace("LINKED", next(iter(LINKED)))
    found = "find_package(sensor_msgs REQUIRED)\nfind_package(std_msgs"
    folder = package(tmp_path, "rclcpp", lists.replace("find_package(std_msgs", found))
    before = texts(folder)
    run(HEARS, tmp_path, "rclcpp", in_place=True)
    run(NOTHING, tmp_path, "rclcpp", in_place=True)
    assert texts(folder) == before
