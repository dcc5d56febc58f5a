"""Parameters of nodes in C++: their types, names out of containers, and who defines a node."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import pytest
from parameter_packages import CONFIG, LAUNCH, cpp, driver, launch, marked, package, read, told

from plastron_tui.lint.made_nodes import facts_of
from plastron_tui.model.code_facts import ParameterAccess

CONSTANTS = """\
#define RATE 10.0
constexpr double RATE_C = 10.0;
constexpr auto FRAME = "map";
constexpr auto COUNT = 2;
namespace limits { constexpr double fastest = 1.0; }
enum Mode { SLOW, FAST };
double usual() { return 1.0; }
struct Config { double rate{1.0}; bool on{true}; };
"""
TYPES = {
    "1.0": "float",
    "-RATE_C": "float",
    "-COUNT": "int",
    "RATE": "float",
    "FRAME": "string",
    "limits::fastest": "float",
    "M_PI / 2": "float",
    "2 * COUNT": "int",
    "COUNT / 3.0": "float",
    "COUNT > 1": "bool",
    "!on_": "bool",
    "on_": "bool",
    "config_.rate": "float",
    "this->config_.on": "bool",
    "(COUNT)": "int",
    "(double)COUNT": "float",
    "static_cast<double>(COUNT)": "float",
    "std::numeric_limits<double>::max()": "float",
    "std::string(FRAME) + \"x\"": "string",
    "std::vector<double>{1, 2}": "float_list",
    "rclcpp::ParameterValue(COUNT)": "int",
    "rclcpp::ParameterValue{1.5}": "float",
    "usual()": "float",
    "letters_": "string",
    # What these are is not said here.
    "letter_": None,
    "FAST": None,
    "other.usual()": None,
    "unknown_": None,
    "COUNT * unknown_": None,
    "-on_": None,
}  # fmt: skip
MEMBERS = """
  Config config_;
  bool on_{true};
  char letter_ = 'a';
  const char * letters_ = "ab";
"""


@pytest.mark.parametrize(("default", "type_"), TYPES.items(), ids=TYPES)
def test_type_that_a_default_gives(tmp_path: Path, default: str, type_: str | None) -> None:
    text = CONSTANTS + cpp(f'declare_parameter("x", {default});', more=MEMBERS)
    (unit,) = read(tmp_path, {"driver.cpp": text}).units
    (use,) = facts_of(unit, unit.nodes[0]).uses
    assert (use.access, use.name, use.type) == (ParameterAccess.DECLARE, "x", type_)


ONE_OF = 'get_parameter("three");'
MAP = "  std::map<int, std::string> names_;\n"
LISTS = {
    "an element of a map": (
        'names_ = {{1, "one"}, {2, "two"}};\ndeclare_parameter(names_[turn_], 1.0);',
        MAP,
    ),
    "an element by its key": (
        "declare_parameter(names_.at(turn_), 1.0);",
        '  std::map<int, std::string> names_{{1, "one"}, {2, "two"}};\n',
    ),
    "each of a map": (
        "for (const auto & each : names_) {declare_parameter(each.second, 1.0);}",
        '  const std::map<int, std::string> names_{{1, "one"}, {2, "two"}};\n',
    ),
    "each of a map, in parts": (
        "for (const auto & [name, value] : names_) {declare_parameter(name, value);}",
        '  std::map<std::string, double> names_{{"one", 1.0}, {"two", 2.0}};\n',
    ),
    "a part of a name": (
        'declare_parameter("wheels." + names_[turn_], 1.0);',
        '  std::vector<std::string> names_{"one", "two"};\n',
    ),
}
OPEN_LISTS = {
    "a map that gets more": (f'{LISTS["an element of a map"][0]}\nnames_[3] = "three";', MAP),
    "a map that is filled": (f"{LISTS['an element of a map'][0]}\nfill(names_);", MAP),
    "a list that grows": (
        f"names_.emplace_back(other_);\n{LISTS['a part of a name'][0]}",
        LISTS["a part of a name"][1],
    ),
    "a list with what is not known": (
        LISTS["an element by its key"][0],
        '  std::map<int, std::string> names_{{1, "one"}, {2, other_}};\n',
    ),
    "a list that is changed in a loop": (
        f"for (auto & each : names_) {{each = other_;}}\n{LISTS['a part of a name'][0]}",
        LISTS["a part of a name"][1],
    ),
    "a list that has another name": (
        f"auto & all = names_;\nall[0] = other_;\n{LISTS['a part of a name'][0]}",
        LISTS["a part of a name"][1],
    ),
    "a function that more call than are looked at": (
        "\n".join(f'add("each_{number}");' for number in range(70)),
        "  void add(const std::string & name) {declare_parameter(name, 1.0);}\n",
    ),
    "a list that is longer than is looked at": (
        "for (const auto & each : std::vector<std::string>{"
        + ", ".join(f'"each_{number}"' for number in range(70))
        + "}) {declare_parameter(each, 1.0);}",
        "",
    ),
}


@pytest.mark.parametrize(
    ("made", "more", "is_told"),
    [(*each, True) for each in LISTS.values()] + [(*each, False) for each in OPEN_LISTS.values()],
    ids=[*LISTS, *OPEN_LISTS],
)
def test_names_out_of_a_container_are_declared(
    tmp_path: Path, made: str, more: str, is_told: bool
) -> None:
    files = {"driver.cpp": cpp(f"{made}\n{ONE_OF}  // wrong", more=more)}
    assert told(tmp_path, files, "RP304") == (marked(files) if is_told else [])


@pytest.mark.parametrize("name", ["one", "two"])
@pytest.mark.parametrize("made", [each for each in LISTS if each != "a part of a name"])
def test_name_out_of_a_container_is_not_told(tmp_path: Path, made: str, name: str) -> None:
    code, more = LISTS[made]
    files = {"driver.cpp": cpp(f'{code}\nget_parameter("{name}");', more=more)}
    assert told(tmp_path, files, "RP304") == []


SET = {
    "one": ('set_parameter(rclcpp::Parameter("{}", 1.0));', True),
    "one in braces": ('this->set_parameter({{"{}", 1.0}});', True),
    "several": ('set_parameters({{rclcpp::Parameter("{}", 1.0)}});', True),
    "several in a vector": (
        'set_parameters_atomically(std::vector<rclcpp::Parameter>{{{{"{}", 1.0}}}});', True
    ),
    "several that are asked for": ('get_parameters({{"{}"}});', True),
    "all with a prefix": ('get_parameters("{}", all_);', False),
    "of another node": ('client_->set_parameters({{rclcpp::Parameter("{}", 1.0)}});', False),
    "where it may fail": (
        'try {{set_parameter(rclcpp::Parameter("{}", 1.0));}} catch (...) {{}}', False
    ),
}  # fmt: skip


@pytest.mark.parametrize(("code", "is_told"), SET.values(), ids=SET)
def test_parameter_that_is_set_is_declared(tmp_path: Path, code: str, is_told: bool) -> None:
    right, wrong = code.format("rate"), code.format("speed")
    files = {"driver.cpp": cpp(f'declare_parameter("rate", 1.0);\n{right}\n{wrong}  // wrong')}
    assert told(tmp_path, files, "RP304") == (marked(files) if is_told else [])


HEADER = """\
#pragma once
#include <rclcpp/rclcpp.hpp>

class Driver : public rclcpp::Node
{
public:
  Driver();
  void tick();
};
"""
SOURCE = """\
#include "driver.hpp"

Driver::Driver() : rclcpp::Node("driver")
{
  declare_parameter("max_speed", 1.0);
}

void Driver::tick() {}
"""
MAIN = """\
#include "driver.hpp"

int main(int argc, char ** argv)
{{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<Driver>();
  {}
  rclcpp::spin(node);
}}
"""
TOGETHER = "add_executable(driver src/main.cpp src/driver.cpp)"
APART = "add_library(core src/driver.cpp)\nadd_executable(driver src/main.cpp)"
WHEELS = "auto wheels = rclcpp::Node::make_shared(\"wheels\");"  # fmt: skip


def _files(built: str, config: str, made: str = "") -> Mapping[str, str]:
    keys = "".join(f"    {line}\n" for line in config.splitlines())
    files = package({CONFIG: f"driver:\n  ros__parameters:\n{keys}"})
    files = {name: text for name, text in files.items() if not name.endswith((".py", "setup.py"))}
    files["rover/package.xml"] = files["rover/package.xml"].replace("ament_python", "ament_cmake")
    cmake = (
        "cmake_minimum_required(VERSION 3.8)\nproject(rover)\n"
        "find_package(ament_cmake REQUIRED)\nfind_package(rclcpp REQUIRED)\n"
        f"{built}\ninstall(TARGETS driver DESTINATION lib/rover)\nament_package()\n"
    )
    return {
        **files,
        LAUNCH: launch(driver("CONFIG").replace(", name='driver'", "")),
        "rover/CMakeLists.txt": cmake,
        "rover/src/driver.hpp": HEADER,
        "rover/src/driver.cpp": SOURCE,
        "rover/src/main.cpp": MAIN.format(made),
    }


CONFIGS = {
    "RP301": "max_speed: 1.0\nreverse: true  # wrong",
    "RP303": "max_speed: 1  # wrong",
}


@pytest.mark.parametrize("made", ["", WHEELS])
@pytest.mark.parametrize("built", [TOGETHER, APART])
@pytest.mark.parametrize("code", CONFIGS)
def test_node_is_known_by_the_source_that_defines_it(
    tmp_path: Path, code: str, built: str, made: str
) -> None:
    files = _files(built, CONFIGS[code], made)
    assert told(tmp_path, files, "RP301", "RP302", "RP303") == marked(files)


@pytest.mark.parametrize(
    "made", ["tools::more(node);", 'node->declare_parameter("reverse", true);']
)
@pytest.mark.parametrize("built", [TOGETHER, APART])
def test_who_makes_a_node_may_declare_more(tmp_path: Path, built: str, made: str) -> None:
    files = _files(built, CONFIGS["RP301"], made)
    assert told(tmp_path, files, "RP301", "RP302", "RP303") == []


def test_class_that_two_sources_define_is_not_sure(tmp_path: Path) -> None:
    built = f"{APART}\nadd_library(old src/old_driver.cpp)"
    files = {**_files(built, CONFIGS["RP303"]), "rover/src/old_driver.cpp": SOURCE}
    assert told(tmp_path, files, "RP301", "RP302", "RP303") == []
