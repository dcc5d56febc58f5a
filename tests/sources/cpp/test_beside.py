"""What another source of a package says of a node that a file is read for."""

from __future__ import annotations

from pathlib import Path

import pytest
from reading import ROS1

from plastron_tui.project.loader import with_others
from plastron_tui.sources import find_language

HEADER = """#pragma once
#include <ros/ros.h>
class A {
 public:
  A(ros::NodeHandle nh, const std::string& topic);
  void setup();
  ros::NodeHandle nh_;
  std::string topic_, other_;
};
"""
SOURCE = f"""{ROS1}#include "a.hpp"
A::A(ros::NodeHandle nh, const std::string& topic) : nh_(nh), topic_(topic) {{
  nh_.advertise<std_msgs::String>(topic_, 1);
  nh_.advertise<std_msgs::String>(other_, 1);
}}
"""
SETUP = '#include "a.hpp"\nvoid A::setup() { other_ = "c"; nh_.subscribe(1); }\n'
MAIN = '#include "a.hpp"\nint main() { A a(ros::NodeHandle("n"), "b"); }\n'
STRANGER = 'const std::string topic = "z"; struct B { B(); void setup() { other_ = "d"; } };\n'


@pytest.mark.parametrize(
    ("files", "names", "beside"),
    [
        ({}, [None, None], []),
        ({"main.cpp": MAIN}, ["n/b", None], ["main.cpp"]),
        ({"main.cpp": MAIN, "setup.cpp": SETUP}, ["n/b", "n/c"], ["main.cpp", "setup.cpp"]),
        ({"main.cpp": MAIN, "other.cpp": STRANGER}, ["n/b", None], ["main.cpp"]),
    ],
)
def test_other_sources_say_what_members_are(
    tmp_path: Path, files: dict[str, str], names: list[str | None], beside: list[str]
) -> None:
    for name, text in {"a.hpp": HEADER, "a.cpp": SOURCE, **files}.items():
        (tmp_path / name).write_text(text)
    path = tmp_path / "a.cpp"
    result = find_language("cpp").read(path, with_others(path, path.read_bytes()))
    assert result.source is not None
    assert [each.name for each in result.source.endpoints] == names
    assert [each.name for each in result.beside] == beside


def test_what_another_node_of_the_package_makes_is_its_own(tmp_path: Path) -> None:
    made = 'struct {0} : Base {{ {0}() {{ add<std_msgs::{1}>("{2}"); }} }};\n'
    files = {
        "base.hpp": "class Base : public X { template <class T> void add(const char* t) {\n"
        "  ros::NodeHandle nh; nh.advertise<T>(t, 1); } void open(); };\n",
        "a.cpp": f'{ROS1}#include "base.hpp"\n' + made.format("A", "String", "a"),
        "b.cpp": f'{ROS1}#include "base.hpp"\n' + made.format("B", "Int8", "b"),
    }
    for name, text in files.items():
        (tmp_path / name).write_text(text)
    path = tmp_path / "a.cpp"
    source = find_language("cpp").read(path, with_others(path, path.read_bytes())).source
    assert source is not None
    assert [(each.name, str(each.type)) for each in source.endpoints] == [("a", "std_msgs/String")]


FOLDERS = [
    ("", [None]),
    ("target_include_directories(a PUBLIC src/tools/api)", ["near"]),
    (
        "include_directories(\n  include ${x_INCLUDE_DIRS}\n  ${PROJECT_SOURCE_DIR}/src/tools/api)",
        ["near"],
    ),
    (
        "target_include_directories(a PRIVATE $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/far>)",
        ["far"],
    ),
    ("include_directories(/etc ../.. far src/tools/api)", ["far"]),
]


@pytest.mark.parametrize(("commands", "names"), FOLDERS)
def test_a_header_is_in_a_folder_that_the_package_adds(
    tmp_path: Path, commands: str, names: list[str | None]
) -> None:
    files = {
        "package.xml": "<package/>",
        "CMakeLists.txt": commands,
        "src/tools/api/names.hpp": 'constexpr char NAME[] = "near";\n',
        "far/names.hpp": 'constexpr char NAME[] = "far";\n',
        "src/a.cpp": f'{ROS1}#include "names.hpp"\n'
        "int main() { ros::NodeHandle nh; nh.advertise<std_msgs::String>(NAME, 1); }\n",
    }
    for name, text in files.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)
    path = tmp_path / "src" / "a.cpp"
    source = find_language("cpp").read(path, with_others(path, path.read_bytes())).source
    assert source is not None
    assert [each.name for each in source.endpoints] == names


def test_the_header_of_a_template_says_what_its_other_header_uses(tmp_path: Path) -> None:
    (tmp_path / "a.h").write_text(
        "#include <actionlib/server/action_server.h>\n#include <std_msgs/String.h>\n"
        "template <class T> class A {\n  using S = actionlib::ActionServer<a_msgs::FooAction>;\n"
        "  void init(ros::NodeHandle& nh);\n  void hear(const std_msgs::StringConstPtr& m);\n"
        '  std::unique_ptr<S> server_;\n};\n#include "a_impl.h"\n'
    )
    path = tmp_path / "a_impl.h"
    path.write_text(
        f"{ROS1}template <class T> void A<T>::init(ros::NodeHandle& nh) {{\n"
        '  nh.subscribe("b", 1, &A::hear, this);\n  server_.reset(new S(nh, "c", false));\n}\n'
    )
    source = find_language("cpp").read(path, with_others(path, path.read_bytes())).source
    assert source is not None
    assert [(each.name, str(each.type)) for each in source.endpoints] == [
        ("b", "std_msgs/String"),
        ("c", "a_msgs/Foo"),
    ]
