"""Programs that functions of a CMakeLists.txt make, and what is told of them."""

from __future__ import annotations

from pathlib import Path

import pytest
from packages import CMAKE, CPP_NODE, PYTHON, Break, told_of

_LISTS = "rover/CMakeLists.txt"
_LAST = "ament_package()"
_FILE = "rover/launch/more.launch.xml"
_STARTS = '<launch>\n  <node pkg="rover" exec="{}"/>\n</launch>\n'
_LOADS = (
    '<launch>\n  <node_container pkg="rclcpp_components" exec="component_container" name="c" '
    'namespace="">\n    <composable_node pkg="rover" plugin="{}" name="x"/>\n'
    "  </node_container>\n</launch>\n"
)
_TOLD = f"RK506 {_FILE}:2"
_NODES = {"rover/src/walker.cpp": CPP_NODE, "rover/src/runner.cpp": CPP_NODE}
_ADD = (
    "function(add_node name)\n  add_executable(${name} src/${name}.cpp)\n"
    "  ament_target_dependencies(${name} rclcpp geometry_msgs)\n%sendfunction()\n"
)
_INSTALL = "  install(TARGETS ${name} DESTINATION lib/${PROJECT_NAME})\n"
_WHOLE = _ADD % _INSTALL
_REGISTER = (
    "macro(add_part class name)\n  add_library(${name}_part SHARED src/${name}.cpp)\n"
    "  rclcpp_components_register_node(${name}_part PLUGIN ${class} EXECUTABLE ${name})\n"
    "endmacro()\nadd_part(rover::Walker walker)\n"
)
_TESTS = "if(BUILD_TESTING)\n  macro(tests)\n    add_launch_test(a.py)\n  endmacro()\n%sendif()\n"


def _case(text: str, name: str, told: str = "", launch: str = _STARTS, **more: str) -> Break:
    files = {**_NODES, _FILE: launch.format(name), **more}
    return Break(_LISTS, _LAST, f"{text}{_LAST}", told, more=files)


_CALLS = "add_node(walker)\nadd_node(runner)\n"
_EACH = "foreach(x {})\n  add_node(${{x}})\nendforeach()\n"
_NOT_INSTALLED = "RK503 rover/CMakeLists.txt:"

_CASES = [
    # A program that a function makes, and one that none makes.
    _case(_WHOLE + _CALLS, "walker"),
    _case(_WHOLE + _CALLS, "walkers", _TOLD),
    # A folder or a source of the name makes no program.
    _case(_WHOLE + _EACH.format("walker runner"), "runner"),
    _case(_WHOLE + _EACH.format("walker"), "runner", _TOLD),
    # A function that does what is not known may make any program.
    _case(_WHOLE.replace("  install", "  return()\n  install") + _CALLS, "runner"),
    _case(_WHOLE + "add_node(${ANY})\n", "runner"),
    _case(_WHOLE + "add_nodes(walker)\n", "walker"),
    _case(_WHOLE + "add_node(runner)\nif(NOT BUILD_TESTING)\n  add_nodes(walker)\nendif()\n",
          "walker"),
    _case("cuda_add_executable(walker src/walker.cpp)\n", "walker"),
    # Names in one list within quotes.
    *(_case(_WHOLE + 'set(N "walker;runner")\n' + _EACH.format(names), "runner")
      for names in ("${N}", "IN LISTS N")),
    # It does not install them.
    _case(_ADD % "" + _CALLS, "mover", f"{_NOT_INSTALLED}25, {_NOT_INSTALLED}26"),
    _case(_ADD % "" + _CALLS + "install(TARGETS walker DESTINATION lib/rover)\n", "mover",
          f"{_NOT_INSTALLED}26"),
    _case(_ADD % "" + _CALLS + "install(TARGETS ${NODES} DESTINATION lib/rover)\n", "mover"),
    # Components, those of macros too, whatever tests define.
    _case(_REGISTER, "rover::Walker", launch=_LOADS),
    _case(_REGISTER, "rover::Walkr", "RK506 rover/launch/more.launch.xml:3", _LOADS),
    _case(_REGISTER, "walker"),
    _case(_TESTS % "  each(tests)\n", "rover::Walkr", "RK506 rover/launch/more.launch.xml:3",
          _LOADS),
    _case(_TESTS % "  each(tests)\n" + "tests()\n", "rover::Walkr", launch=_LOADS),
    # Files of the package that are included.
    _case("include(setup.cmake)\n", "walkers", _TOLD, **{"rover/setup.cmake": "set(A b)\n"}),
    _case("include(setup.cmake)\n", "walkers",
          **{"rover/setup.cmake": "add_executable(walkers a.cpp)\n"}),
    _case("include(setup.cmake)\n", "walkers_node", **{"rover/setup.cmake": "add_walkers()\n"}),
    # Another name for a program.
    _case("set_property(TARGET mover PROPERTY OUTPUT_NAME walkers)\n", "walkers"),
]  # fmt: skip


@pytest.mark.parametrize("case", _CASES)
def test_programs_of_functions(case: Break, tmp_path: Path) -> None:
    """A program that a function may make is not told, and one that it surely does not is."""
    assert told_of(tmp_path, case.files(PYTHON | CMAKE)) == case.found
