"""What a CMakeLists.txt says once a node is built by it."""

from __future__ import annotations

from pathlib import Path

import pytest

from plastron_tui.sources.cmake.targets import NewTarget, add_target

PATH = Path("CMakeLists.txt")
ROSCPP = NewTarget("talker", "src/talker.cpp", "", ("roscpp",), ())
NODELET = NewTarget(
    "ears", "src/ears.cpp", "include", ("nodelet",), (), "demo::Ears", False, "nodelet_plugins.xml"
)
RCLCPP = NewTarget("talker", "src/talker.cpp", "", ("rclcpp",), ("rclcpp::rclcpp",))
OWN_TYPES = RCLCPP._replace(has_own_types=True)
COMPONENT = NewTarget(
    "ears", "src/ears.cpp", "include", ("rclcpp",), ("rclcpp::rclcpp",), "demo::Ears"
)

BUILT = """\
cmake_minimum_required(VERSION 3.0.2)
project(demo)
find_package(catkin REQUIRED COMPONENTS roscpp)
catkin_package()
include_directories(${catkin_INCLUDE_DIRS})
add_executable(old src/old.cpp)
target_link_libraries(old ${catkin_LIBRARIES})

install(TARGETS old
  RUNTIME DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION}
)
"""
BARE = "project(demo)\nfind_package(catkin REQUIRED)\ncatkin_package()\n"
AMENT = """\
project(demo)
find_package(ament_cmake REQUIRED)

ament_package()
"""
UPPER = AMENT.replace("find_package", "FIND_PACKAGE").replace("project", "PROJECT")
UPPER = UPPER.replace("ament_package", "AMENT_PACKAGE")

CASES: dict[str, tuple[str, NewTarget, str]] = {
    "beside a target that is called plainly": (
        BUILT,
        ROSCPP,
        BUILT.replace(
            """
install(""",
            """
add_executable(talker src/talker.cpp)
add_dependencies(talker ${${PROJECT_NAME}_EXPORTED_TARGETS} ${catkin_EXPORTED_TARGETS})
target_link_libraries(talker ${catkin_LIBRARIES})

install(""",
        )
        + """
install(TARGETS talker
  RUNTIME DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION}
)
""",
    ),
    "the first of a package, a nodelet": (
        BARE,
        NODELET,
        """\
project(demo)
find_package(catkin REQUIRED COMPONENTS nodelet)
catkin_package()

include_directories(include ${catkin_INCLUDE_DIRS})

add_library(${PROJECT_NAME}_ears src/ears.cpp)
add_dependencies(${PROJECT_NAME}_ears ${${PROJECT_NAME}_EXPORTED_TARGETS} """
        """${catkin_EXPORTED_TARGETS})
target_link_libraries(${PROJECT_NAME}_ears ${catkin_LIBRARIES})

install(TARGETS ${PROJECT_NAME}_ears
  ARCHIVE DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION}
  LIBRARY DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION}
  RUNTIME DESTINATION ${CATKIN_GLOBAL_BIN_DESTINATION}
)

install(FILES
  nodelet_plugins.xml
  DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION}
)
""",
    ),
    "types of the package": (
        AMENT,
        OWN_TYPES,
        """\
project(demo)
find_package(ament_cmake REQUIRED)
find_package(rclcpp REQUIRED)

rosidl_get_typesupport_target(cpp_typesupport_target ${PROJECT_NAME} rosidl_typesupport_cpp)

add_executable(talker src/talker.cpp)
target_compile_features(talker PUBLIC cxx_std_17)
target_link_libraries(talker PUBLIC
  rclcpp::rclcpp
  ${cpp_typesupport_target}
)

install(TARGETS talker
  DESTINATION lib/${PROJECT_NAME}
)

ament_package()
""",
    ),
    "a component": (
        AMENT,
        COMPONENT,
        """\
project(demo)
find_package(ament_cmake REQUIRED)
find_package(rclcpp REQUIRED)

add_library(${PROJECT_NAME}_ears SHARED src/ears.cpp)
target_compile_features(${PROJECT_NAME}_ears PUBLIC cxx_std_17)
target_include_directories(${PROJECT_NAME}_ears PUBLIC
  $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>
  $<INSTALL_INTERFACE:include/${PROJECT_NAME}>
)
target_link_libraries(${PROJECT_NAME}_ears PUBLIC
  rclcpp::rclcpp
)
rclcpp_components_register_node(${PROJECT_NAME}_ears
  PLUGIN "demo::Ears"
  EXECUTABLE ears
)

install(TARGETS ${PROJECT_NAME}_ears
  ARCHIVE DESTINATION lib
  LIBRARY DESTINATION lib
  RUNTIME DESTINATION bin
)

ament_package()
""",
    ),
    "a project that compiles nothing, in capitals": (
        UPPER.replace("(demo)", "(demo NONE)"),
        RCLCPP,
        """\
PROJECT(demo NONE)
ENABLE_LANGUAGE(CXX)
FIND_PACKAGE(ament_cmake REQUIRED)
FIND_PACKAGE(rclcpp REQUIRED)

ADD_EXECUTABLE(talker src/talker.cpp)
TARGET_COMPILE_FEATURES(talker PUBLIC cxx_std_17)
TARGET_LINK_LIBRARIES(talker PUBLIC
  rclcpp::rclcpp
)

INSTALL(TARGETS talker
  DESTINATION lib/${PROJECT_NAME}
)

AMENT_PACKAGE()
""",
    ),
}


@pytest.mark.parametrize(("before", "new", "after"), CASES.values(), ids=CASES)
def test_a_node_is_built(before: str, new: NewTarget, after: str) -> None:
    edited = add_target(before.encode(), PATH, new)
    assert edited.text is not None, edited.diagnostics
    assert edited.text.decode() == after
    assert add_target(edited.text, PATH, new).text == edited.text


def test_a_node_keeps_the_line_ends_of_its_file() -> None:
    before = AMENT.replace("\n", "\r\n").encode()
    edited = add_target(before, PATH, RCLCPP)
    assert edited.text is not None
    assert edited.text.replace(b"\r\n", b"").count(b"\n") == 0


@pytest.mark.parametrize(
    ("text", "what"),
    [
        (BUILT.replace("old", "talker").replace("talker.cpp", "other.cpp"), "another target"),
        (BARE.replace("catkin_package", "catkin_metapackage"), "metapackage"),
        ("project(demo)\n", "neither catkin nor ament_cmake"),
    ],
)
def test_what_cannot_be_built_is_refused(text: str, what: str) -> None:
    edited = add_target(text.encode(), PATH, ROSCPP)
    assert edited.text is None
    assert what in edited.diagnostics[0].message


def test_a_node_that_is_built_already_is_left_as_it_is() -> None:
    new = ROSCPP._replace(executable="old", source="src/old.cpp")
    assert add_target(BUILT.encode(), PATH, new).text == BUILT.encode()


_FIRST = "project(demo)\nfind_package(ament_cmake REQUIRED)\n"
_SRC = "${PROJECT_SOURCE_DIR}/src"
PATTERNS = {
    "all": ("file(GLOB all src/*.cpp)\nadd_executable(old ${all})\n", 4),
    "all below": (f"file(GLOB_RECURSE all {_SRC}/*.cpp)\nadd_library(old ${{all}})\n", 4),
    "a folder": ("aux_source_directory(src all)\nadd_executable(old ${all})\n", 4),
    "by another name": (
        "file(GLOB all src/*.cpp)\nset(more ${all} x.cpp)\nadd_executable(old ${more})\n",
        5,
    ),
    "each": (
        f"file(GLOB all RELATIVE {_SRC} src/*.cpp)\nforeach(x ${{all}})\n"
        "  add_executable(n${x} src/${x})\nendforeach()\n",
        5,
    ),
    "other files": ("file(GLOB all lib/*.cpp src/*.h)\nadd_executable(old ${all} src/a.cpp)\n", 0),
    "for something else": ("file(GLOB all src/*.cpp)\ninstall(FILES ${all} DESTINATION x)\n", 0),
}


@pytest.mark.parametrize(("text", "line"), PATTERNS.values(), ids=PATTERNS)
def test_no_source_is_put_where_another_target_takes_it(text: str, line: int) -> None:
    edited = add_target(f"{_FIRST}{text}ament_package()\n".encode(), PATH, RCLCPP)
    assert (edited.text is None) == bool(line)
    for told in edited.diagnostics:
        assert told.message == (
            f"line {line} of `CMakeLists.txt` builds all files that are like `src/talker.cpp`"
        )
