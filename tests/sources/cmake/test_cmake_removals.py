"""What a CMakeLists.txt says once a node is built by it no more."""

from __future__ import annotations

from pathlib import Path

import pytest

from plastron_tui.sources.cmake.removals import names_package, remove_target

PATH = Path("CMakeLists.txt")
START = "project(demo)\nfind_package(ament_cmake REQUIRED)\n"
END = "ament_package()\n"

CASES: dict[str, tuple[str, str]] = {
    "in paragraphs, and among others": (
        """\
add_executable(ears src/ears.cpp)
add_executable(talker src/talker.cpp)

ament_target_dependencies(ears rclcpp)
ament_target_dependencies(talker rclcpp)

set_target_properties(ears talker PROPERTIES CXX_STANDARD 17)
install(TARGETS
  ears
  talker
  DESTINATION lib/${PROJECT_NAME}
)
""",
        """\
add_executable(ears src/ears.cpp)

ament_target_dependencies(ears rclcpp)

set_target_properties(ears PROPERTIES CXX_STANDARD 17)
install(TARGETS
  ears
  DESTINATION lib/${PROJECT_NAME}
)
""",
    ),
    "with its branch": (
        """\
add_executable(talker src/talker.cpp)
if(UNIX)
  target_link_libraries(talker m)
endif()
message(STATUS talker)
""",
        "message(STATUS talker)\n",
    ),
    "a library that is told of": (
        """\
add_library(talker src/talker.cpp)
ament_export_libraries(ears talker)
""",
        "ament_export_libraries(ears)\n",
    ),
    "below a comment": (
        """\
# Talking
add_executable(talker src/talker.cpp)

# Hearing
add_executable(ears src/ears.cpp)
""",
        """\
# Talking

# Hearing
add_executable(ears src/ears.cpp)
""",
    ),
}


@pytest.mark.parametrize(("before", "after"), CASES.values(), ids=CASES)
def test_all_that_is_said_of_a_target_goes(before: str, after: str) -> None:
    edited = remove_target(f"{START}{before}{END}".encode(), PATH, "talker")
    assert edited.text is not None, edited.diagnostics
    assert edited.text.decode() == f"{START}{after}{END}"


_LOOP = "foreach(each talker ears)\n  add_executable(${each} src/${each}.cpp)\nendforeach()\n"
_TALKER = "add_library(talker src/talker.cpp)\n"


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (_LOOP, "line 4 of `CMakeLists.txt` builds `talker` in a branch or a loop"),
        (f"if(A)\n{_TALKER}endif()\n", "in a branch or a loop"),
        (f"{_TALKER}target_link_libraries(ears talker)\n", "line 4 of `CMakeLists.txt` names"),
        (f"{_TALKER}add_test(NAME a COMMAND $<TARGET_FILE:talker>)\n", "line 4"),
        (f"{_TALKER}install(TARGETS talker EXPORT all DESTINATION lib)\n", "exports `talker`"),
        (
            f"{_TALKER}rclcpp_components_register_node(talker PLUGIN A EXECUTABLE a)\n"
            "rclcpp_components_register_node(talker PLUGIN B EXECUTABLE b)\n",
            "line 5 of `CMakeLists.txt` makes more than one component",
        ),
    ],
)
def test_what_is_not_certain_is_refused(text: str, said: str) -> None:
    edited = remove_target(f"{START}{text}{END}".encode(), PATH, "talker")
    assert edited.text is None
    assert said in edited.diagnostics[0].message


@pytest.mark.parametrize(
    ("text", "is_named"),
    [
        ("ament_target_dependencies(a rclcpp)", True),
        ("target_link_libraries(a rclcpp::rclcpp)", True),
        ("target_link_libraries(a ${rclcpp_TARGETS})", True),
        ("  rclcpp_components_register_node(a)", True),
        ("find_package(rclcpp_components REQUIRED)", False),
        ("# rclcpp", False),
    ],
)
def test_a_package_is_named_by_what_it_brings(text: str, is_named: bool) -> None:
    assert names_package(text.encode(), "rclcpp") is is_named
