"""What is read of the files of a package, case by case: a change of them, and a fact of it."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from packages import CPP_LISTS
from read_packages import Change, facts_of

from plastron_tui.model.package_facts import BuildFacts

_END = "install(DIRECTORY launch"


def _scripts(facts: BuildFacts) -> str:
    return " ".join(f"{each.file.rpartition('/')[2]}:{each.how.name}" for each in facts.scripts)


def _targets(facts: BuildFacts) -> str:
    words = {True: "there", False: "elsewhere", None: "unknown"}
    return " ".join(
        f"{each.name}:{words[each.is_installed]}{':' + each.where.file if each.where else ''}"
        for each in facts.targets
    )


def _last(lines: str) -> Change:
    """Return a change that has further commands at the end of a CMakeLists.txt."""
    return {"CMakeLists.txt": f"{_END} -> {lines}\n{_END}"}


_INSTALL = "install(PROGRAMS\n  scripts/mover.py\n  DESTINATION lib/${PROJECT_NAME})"
_TARGETS = "install(TARGETS mover DESTINATION lib/${PROJECT_NAME})"
_HERE = "DESTINATION lib/${PROJECT_NAME}"

_HOW = [
    ("", "PROGRAM"),
    (_INSTALL, "NOT"),
    ("install(PROGRAMS ${CMAKE_CURRENT_SOURCE_DIR}/scripts/mover.py DESTINATION lib/rover)", "PROGRAM"),
    (f"install(FILES scripts/mover.py {_HERE})", "PLAIN"),
    (f"install(FILES scripts/mover.py {_HERE} PERMISSIONS OWNER_READ OWNER_EXECUTE)", "PROGRAM"),
    (f"install(FILES scripts/mover.py {_HERE} PERMISSIONS WORLD_EXECUTE)", "PROGRAM"),
    (f"install(FILES scripts/mover.py {_HERE} PERMISSIONS OWNER_READ)", "PLAIN"),
    (f"install(PROGRAMS scripts/mover.py {_HERE} CONFIGURATIONS Debug)", "UNKNOWN"),
    (f"if(WITH)\ninstall(PROGRAMS scripts/mover.py {_HERE})\nendif()", "UNKNOWN"),
    ("install(PROGRAMS scripts/mover.py DESTINATION ${SOMEWHERE})", "UNKNOWN"),
    ("install(PROGRAMS scripts/mover.py DESTINATION bin)", "ELSEWHERE"),
    ("install(PROGRAMS scripts/mover.py DESTINATION share/rover)", "ELSEWHERE"),
    ("install(FILES scripts/mover.py DESTINATION share/rover)", "UNKNOWN"),
    ("install(PROGRAMS scripts/mover.py TYPE BIN)", "ELSEWHERE"),
    (f"install(DIRECTORY scripts/ {_HERE})", "PLAIN"),
    (f"install(DIRECTORY scripts {_HERE})", "NOT"),
    (f"install(DIRECTORY scripts/ {_HERE} USE_SOURCE_PERMISSIONS)", "KEPT"),
    (f"install(DIRECTORY scripts/ {_HERE} FILE_PERMISSIONS OWNER_EXECUTE)", "PROGRAM"),
    (f"install(DIRECTORY scripts/ {_HERE} FILE_PERMISSIONS OWNER_READ)", "PLAIN"),
    (f"install(DIRECTORY other/ {_HERE})", "NOT"),
    ("install(DIRECTORY ${X}/scripts/ DESTINATION lib/rover)", "UNKNOWN"),
    ("install(DIRECTORY scripts DESTINATION share/rover)", "UNKNOWN"),
    ("install(DIRECTORY scripts/ DESTINATION ${SOMEWHERE})", "UNKNOWN"),
    (f"file(GLOB all scripts/*.py)\ninstall(PROGRAMS ${{all}} {_HERE})", "PROGRAM"),
    (f"set(all scripts/mover.py)\ninstall(PROGRAMS ${{all}} {_HERE})", "PROGRAM"),
    (f"foreach(one mover other)\ninstall(PROGRAMS scripts/${{one}}.py {_HERE})\nendforeach()", "PROGRAM"),
    ("install(CODE \"message(a)\")", "UNKNOWN"),
    ("install(SCRIPT a.cmake)", "UNKNOWN"),
    ("install(${all})", "UNKNOWN"),
    ("ament_python_install_package(rover SCRIPTS_DESTINATION lib/rover)", "UNKNOWN"),
    ("ament_python_install_package(rover)", "NOT"),
    ("acme_install(scripts/mover.py)", "UNKNOWN"),
    ("if(BUILD_TESTING)\nacme_install(scripts/mover.py)\nendif()", "NOT"),
    ("add_subdirectory(tools)", "UNKNOWN"),
    ("include(CTest)", "NOT"),
    ("include(tools.cmake)", "UNKNOWN"),
    ("include(CheckTools.cmake)", "UNKNOWN"),
    ("include()", "UNKNOWN"),
    ("install()", "NOT"),
    (f"set(more a.py)\ninstall(PROGRAMS ${{more}} {_HERE})", "NOT"),
    (f"install(PROGRAMS ${{X}}/mover.py {_HERE})", "PROGRAM"),
    (f"install(PROGRAMS scripts/${{X}}.py {_HERE})", "PROGRAM"),
    (f"install(PROGRAMS ${{X}}/other.py {_HERE})", "NOT"),
    (f"file(GLOB all other/*.py)\ninstall(PROGRAMS ${{all}} {_HERE})", "NOT"),
    (f"install(DIRECTORY scripts/ {_HERE} PERMISSIONS WORLD_EXECUTE)", "PROGRAM"),
    (f"install(DIRECTORY ./ {_HERE})", "NOT"),
    ("install(DIRECTORY . DESTINATION share/rover)", "UNKNOWN"),
    (f"if(WITH)\ninstall(DIRECTORY scripts/ {_HERE})\nendif()", "UNKNOWN"),
    (f"catkin_install_python(PROGRAMS scripts/mover.py {_HERE})", "PYTHON"),
    ("function(acme)\nreturn()\nendfunction()", "NOT"),
    ("function(acme)\nreturn()\nendfunction()\nacme()", "UNKNOWN"),
    (f"function(acme x)\ninstall(PROGRAMS ${{x}} {_HERE})\nendfunction()\nacme(scripts/mover.py)",
     "PROGRAM"),
    ("if(WITH)\nmacro(acme)\nendmacro()\nendif()", "UNKNOWN"),
]  # fmt: skip


@pytest.mark.parametrize(("lines", "how"), _HOW, ids=lambda each: str(each)[:60])
def test_how_a_script_is_installed(lines: str, how: str) -> None:
    change: Change = {}
    if lines:
        change = {"CMakeLists.txt": f"{_INSTALL} -> {'' if lines == _INSTALL else lines}"}
    assert _scripts(facts_of("rover", change)) == f"mover.py:{how}"


_MADE = [
    (_TARGETS, "there"),
    ("", "elsewhere"),
    (f"install(TARGETS mover other {_HERE})", "there"),
    (f"install(TARGETS mover RUNTIME {_HERE})", "there"),
    (f"install(TARGETS mover {_HERE} ARCHIVE DESTINATION lib)", "there"),
    (f"install(TARGETS mover LIBRARY DESTINATION lib RUNTIME {_HERE} INCLUDES DESTINATION include)", "there"),
    (f"install(TARGETS mover LIBRARY {_HERE})", "elsewhere:CMakeLists.txt"),
    ("install(TARGETS mover DESTINATION bin)", "elsewhere:CMakeLists.txt"),
    ("install(TARGETS mover)", "elsewhere:CMakeLists.txt"),
    ("install(TARGETS mover DESTINATION ${SOMEWHERE})", "unknown"),
    (f"install(TARGETS ${{all}} {_HERE})", "unknown"),
    (f"install(TARGETS ${{PROJECT_NAME}}_node {_HERE})", "elsewhere"),
    ("add_subdirectory(tools)", "unknown"),
    (f"install(TARGETS other {_HERE})", "elsewhere"),
    (f"install(TARGETS mover DESTINATION bin)\n{_TARGETS}", "there"),
    ("install(FILES ${all} DESTINATION bin)", "elsewhere"),
    ('install(TARGETS mover "RUNTIME" DESTINATION bin)', "elsewhere:CMakeLists.txt"),
    ("install(TARGETS mover RUNTIME DESTINATION)", "elsewhere:CMakeLists.txt"),
    (f"set(all mover)\ninstall(TARGETS ${{all}} {_HERE})", "there"),
]  # fmt: skip


@pytest.mark.parametrize(("lines", "where"), _MADE, ids=lambda each: str(each)[:60])
def test_where_a_program_is_installed(lines: str, where: str) -> None:
    facts = facts_of("rover", {"CMakeLists.txt": f"{_TARGETS} -> {lines}"})
    assert _targets(facts) == f"mover:{where}"
    assert facts.targets[0].sources == ("src/mover.cpp",)
    place = facts.targets[0].place
    assert CPP_LISTS.encode()[place.span.start : place.span.end] == b"mover"


_ADD = "add_executable(mover src/mover.cpp)"
_BUILT = [
    ("", ""),
    (f"if(WITH)\n{_ADD}\nendif()", ""),
    (_ADD.replace("add", "ament_auto_add"), "mover:unknown"),
    ("foreach(x a b)\nadd_executable(${x}_node src/${x}.cpp)\nendforeach()", "a_node:elsewhere b_node:elsewhere"),
    ("add_executable(${X}_node a.cpp)", "${X}_node:unknown"),
    ("set(name mover)\nadd_executable(${name} src/mover.cpp)", "mover:there"),
]  # fmt: skip


@pytest.mark.parametrize(("lines", "made"), _BUILT)
def test_which_programs_are_built(lines: str, made: str) -> None:
    change = {"CMakeLists.txt": f"{_ADD} -> {lines}"}
    if "auto" in lines:
        change |= {"CMakeLists.txt": CPP_LISTS.replace(_ADD, lines).replace(_TARGETS, "")}
        assert _targets(facts_of("rover", change)) == "mover:elsewhere"
        packed = change["CMakeLists.txt"].replace("ament_package", "ament_auto_package")
        assert _targets(facts_of("rover", {"CMakeLists.txt": packed})) == "mover:there"
        return
    assert _targets(facts_of("rover", change)) == made


def test_words_of_all_files_of_cmake_may_be_programs() -> None:
    files = {"tools/CMakeLists.txt": "tool(fast)", "a.cmake": "tool(slow)", "a.txt": "none"}
    words = facts_of("rover", _last("acme(speed)") | files).words
    assert words is not None
    assert {"speed", "fast", "slow", "mover", "Speed"} <= words
    assert "none" not in words


_XML = '  <exec_depend condition="{}">std_srvs</exec_depend>\n'
_DECLARED = [
    ("  <depend>std_srvs</depend>\n", "depend (1, 2) True True"),
    ("  <depend>std_srvs</depend> <depend>std_msgs</depend>\n", "depend (1, 2) True False"),
    ("  <depend>\n    std_srvs\n  </depend>\n", "depend (1, 2) True False"),
    ("<!-- a --><depend>std_srvs</depend>\n", "depend (1, 2) True False"),
    (_XML.format("$ROS_VERSION == 1"), "exec_depend (1,) False True"),
    (_XML.format("$ROS_VERSION == 2"), "exec_depend (2,) False True"),
    (_XML.format("$ROS_VERSION == 3"), ""),
    (_XML.format("$ROS_DISTRO == jazzy"), "exec_depend (1, 2) False True"),
    ("  <!-- <depend>std_srvs</depend> -->\n", ""),
]


@pytest.mark.parametrize(("line", "said"), _DECLARED)
def test_what_a_package_declares(line: str, said: str) -> None:
    before = "  <export>"
    facts = facts_of("rover", {"package.xml": f"{before} -> {line}{before}"})
    found = [each for each in facts.dependencies if each.name == "std_srvs"]
    assert [f"{x.tag} {x.versions} {x.is_plain} {x.line is not None}" for x in found] == (
        [said] if said else []
    )


def _one(name: str) -> Callable[[BuildFacts], Any]:
    def fact(facts: BuildFacts) -> Any:
        found = getattr(facts, name)
        return set(found) if isinstance(found, frozenset) else found

    return fact


_mentioned, _linked, _exported = (_one(name) for name in ("mentioned", "linked", "exported"))
_placed, _words, _modules = (_one(name) for name in ("placed", "words", "modules"))
_settled, _nodes, _code = (_one(name) for name in ("is_settled", "installs_nodes", "has_code"))
_headers, _folders, _components = (_one(name) for name in ("has_headers", "folders", "components"))


def _found(facts: BuildFacts) -> set[str]:
    return set(facts.found)


_EXPORTS = "ament_export_dependencies(rclcpp std_msgs)"
_FACTS = [
    # What CMake looks for, names and hands on.
    ("rover", {}, _found, {"ament_cmake", "rclcpp", "geometry_msgs", "rosidl_default_generators", "REQUIRED"}),
    ("old", {}, _found, {"catkin", "REQUIRED", "COMPONENTS", "rospy", "geometry_msgs", "message_generation"}),
    ("rover", {}, _linked, {"rclcpp", "geometry_msgs"}),
    ("rover", {"CMakeLists.txt": "ament_target_dependencies -> set"}, _linked, {"geometry_msgs"}),
    ("rover", {"CMakeLists.txt": "ament_target_dependencies(mover rclcpp geometry_msgs) -> target_link_libraries(mover rclcpp::rclcpp ${rclpy_LIBRARIES})"},
     _linked, {"rclcpp", "rclpy", "geometry_msgs"}),
    ("rover", {}, _exported, set()),
    ("rover", _last(_EXPORTS), _exported, {"rclcpp", "std_msgs"}),
    ("rover", _last("ament_export_targets(rclcpp)"), _exported, {"rclcpp"}),
    ("rover", {"CMakeLists.txt": "ament_package -> ament_auto_package"}, _exported, {"*"}),
    ("old", {"CMakeLists.txt": "CATKIN_DEPENDS message_runtime -> CATKIN_DEPENDS rospy"}, _exported, {"rospy"}),
    # What is installed where nodes are looked for.
    ("rover", {}, _placed, {"mover.py"}),
    ("rover", {"CMakeLists.txt": "mover.py\n  DESTINATION lib -> mover.py\n  DESTINATION share"}, _placed, set()),
    ("rover", {"CMakeLists.txt": "mover.py\n  DESTINATION lib/${PROJECT_NAME} -> mover.py\n  DESTINATION ${X}"}, _placed, {"mover.py"}),
    ("rover", {}, _nodes, True),
    ("rover", {"CMakeLists.txt": f"{_INSTALL} -> "}, _nodes, True),
    ("rover", {"CMakeLists.txt": f"{_TARGETS} -> "}, _nodes, True),
    ("rover", {"CMakeLists.txt": "DESTINATION lib -> DESTINATION share"}, _nodes, False),
    ("wheels", {}, _nodes, False),
    ("wheels", {"scripts/a": "", "setup.py":
                "    entry_points -> scripts=['scripts/a'],\n    entry_points"}, _nodes, True),
    # Whether all programs are known, and which words may be one.
    ("rover", {}, _settled, True),
    ("rover", _last("acme(a b)"), _settled, False),
    ("rover", _last("macro(acme)\nreturn()\nendmacro()"), _settled, True),
    ("rover", _last("macro(acme)\nreturn()\nendmacro()\nacme()"), _settled, False),
    ("rover", _last("add_executable(${X}_node a.cpp)"), _settled, False),
    ("rover", {"CMakeLists.txt": f"{_INSTALL} -> install(PROGRAMS ${{all}} {_HERE})"}, _settled, False),
    ("rover", {"CMakeLists.txt": f"{_INSTALL} -> install(PROGRAMS ${{CATKIN_X}}/a.py {_HERE})"}, _settled, False),
    ("rover", {"CMakeLists.txt": f"{_INSTALL} -> file(GLOB all scripts/*.py)\ninstall(PROGRAMS ${{all}} {_HERE})"}, _settled, True),
    ("rover", {"CMakeLists.txt": f"{_INSTALL} -> set(all scripts/mover.py)\ninstall(PROGRAMS ${{all}} {_HERE})"}, _settled, True),
    ("rover", {"CMakeLists.txt": f"{_INSTALL} -> set(all scripts/mover.py ${{X}})\ninstall(PROGRAMS ${{all}} {_HERE})"}, _settled, False),
    ("rover", {"CMakeLists.txt": f"{_INSTALL} -> install(PROGRAMS a.py DESTINATION ${{CATKIN_PACKAGE_BIN_DESTINATION}})"}, _settled, True),
    ("rover", {"CMakeLists.txt": f"{_INSTALL} -> install(FILES ${{all}} {_HERE})"}, _settled, True),
    ("wheels", {}, _settled, True),
    ("wheels", {"setup.py": "['mover = wheels.mover:main'] -> find_scripts()"}, _settled, False),
    ("wheels", {"setup.py": "    entry_points={'console_scripts': ['mover = wheels.mover:main']}, -> **more"}, _settled, False),
    ("rover", {}, _words, set()),
    ("wheels", {}, _words, None),
    ("rover", _last("add_executable(${X}_node a.cpp)"), _words, None),
    # What the package is made of.
    ("rover", {}, _code, True),
    ("wheels", {"wheels/mover.py": "# nothing\n\n"}, _code, False),
    ("wheels", {"wheels/mover.py": None, "setup.py": "mover -> other", "test/test_a.py": "import a\n"}, _code, False),
    ("wheels", {"wheels/mover.py": None, "conftest.py": "import a\n", "x_test.py": "import a\n"}, _code, False),
    ("wheels", {"wheels/mover.py": None, "wheels/tester.py": "import a\n"}, _code, True),
    ("rover", {}, _headers, False),
    ("rover", {"include/rover/a.hpp": ""}, _headers, True),
    ("rover", {"include/other/a.hpp": "", "sub/include/third/in/a.hpp": "", "include/a.hpp": ""},
     _folders, {"other", "third"}),
    ("wheels", {}, _modules, {"wheels"}),
    ("wheels", {"setup.py": "packages=['wheels'] -> packages=['wheels', 'wheels.inner', 'tools']"}, _modules, {"wheels", "tools"}),
    ("rover", _last("ament_python_install_package(tools)"), _modules, {"tools"}),
    ("rover", _last("ament_python_install_package(tools PACKAGE_DIR python/kit/)"), _modules, {"kit"}),
    ("rover", _last("ament_python_install_package()"), _modules, set()),
    # What containers find.
    ("rover", {}, _components, {"rover::Mover"}),
    ("rover", _last("rclcpp_components_register_node(part PLUGIN a::B EXECUTABLE b)"), _components, {"rover::Mover", "a::B"}),
    ("rover", _last("rclcpp_components_register_nodes(part a::B ${MORE})"), _components, None),
    ("rover", _last("acme()"), _components, None),
    # Names in files, but for those that build the package and those for people.
    ("rover", {}, _mentioned, {"rclcpp", "rclpy", "geometry_msgs"}),
    ("rover", {"src/mover.cpp": "", "scripts/mover.py": ""}, _mentioned, {"geometry_msgs"}),
    ("rover", {"msg/Speed.msg": "float64 a\n", "src/mover.cpp": "geometry_msgs_x my_rclcpp\n", "scripts/mover.py": ""}, _mentioned, set()),
    ("rover", {"msg/Speed.msg": "float64 a\n", "src/mover.cpp": "", "scripts/mover.py": "", "README.md": "rclcpp", "LICENSE": "rclcpp", "doc/a.rst": "rclcpp"}, _mentioned, set()),
    ("rover", {"msg/Speed.msg": "Header header\n"}, _mentioned, {"std_msgs", "rclcpp", "rclpy", "geometry_msgs"}),
    ("rover", {"action/Go.action": "---\n---\n"}, _mentioned, {"rclcpp", "rclpy", "geometry_msgs"}),
    ("old", {"action/Go.action": "---\n---\n"}, _mentioned, {"std_msgs", "rospy", "geometry_msgs"}),
    ("rover", {"scripts/mover.py": "", "a.png": "rclpy"}, _mentioned, {"rclcpp", "geometry_msgs"}),
]  # fmt: skip


@pytest.mark.parametrize(
    ("package", "change", "fact", "value"),
    _FACTS,
    # A set has no order, and a function is where it is: no names for those who run side by side.
    ids=lambda each: str(each)[:40] if isinstance(each, str | dict) else "",
)
def test_fact_of_a_package(
    package: str, change: Change, fact: Callable[[BuildFacts], Any], value: Any
) -> None:
    assert fact(facts_of(package, change)) == value
