"""Components, the classes that a package registers, and the sources that they are in."""

from __future__ import annotations

from pathlib import Path

import pytest
from linted import run_over, write_tree

_XML = """\
<package format="3"><name>demo</name><version>0.1.0</version><description>d</description>
<maintainer email="a@b.com">m</maintainer><license>MIT</license>
<buildtool_depend>ament_cmake_auto</buildtool_depend><depend>rclcpp</depend>
<depend>rclcpp_components</depend><depend>std_msgs</depend>
<export><build_type>ament_cmake</build_type></export></package>
"""
_CMAKE = """\
cmake_minimum_required(VERSION 3.8)
project(demo)
find_package(ament_cmake_auto REQUIRED)
ament_auto_find_build_dependencies()
{commands}
ament_auto_package(INSTALL_TO_SHARE launch)
"""
_CLASS = """\
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"
namespace demo {{
class {name} : public rclcpp::Node {{
public:
  explicit {name}(const rclcpp::NodeOptions & options) : Node("{name}", options) {{
    {member} = {create}("chatter", 10{callback});
  }}
private:
  rclcpp::{type}<std_msgs::msg::String>::SharedPtr {member};
}};
}}
"""
_TALKER = _CLASS.format(
    name="Talker",
    member="pub_",
    create="create_publisher<std_msgs::msg::String>",
    callback="",
    type="Publisher",
)
_LISTENER = _CLASS.format(
    name="Listener",
    member="sub_",
    create="create_subscription<std_msgs::msg::String>",
    callback=", [](std_msgs::msg::String::SharedPtr) {}",
    type="Subscription",
)
_REGISTERED = (
    '#include "rclcpp_components/register_node_macro.hpp"\n'
    "RCLCPP_COMPONENTS_REGISTER_NODE(demo::{})\n"
)
_MAIN = """\
#include "demo/talker.hpp"
#include "demo/listener.hpp"
int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  rclcpp::executors::SingleThreadedExecutor executor;
  auto talker = std::make_shared<demo::Talker>(rclcpp::NodeOptions());
  auto listener = std::make_shared<demo::Listener>(rclcpp::NodeOptions());
  executor.add_node(talker);
  executor.add_node(listener);
  executor.spin();
}
"""
_BOTH = "add_library(parts SHARED src/first.cpp src/second.cpp)\n"
_PLURAL = 'rclcpp_components_register_nodes(parts "demo::Talker" "demo::Listener")'
_SINGLE = (
    'rclcpp_components_register_node(parts PLUGIN "demo::Talker" EXECUTABLE talker)\n'
    'rclcpp_components_register_node(parts PLUGIN "demo::Listener" EXECUTABLE listener)'
)

_IN_PYTHON = """\
from launch import LaunchDescription
from launch_ros.actions import ComposableNodeContainer
from launch_ros.descriptions import ComposableNode
def generate_launch_description():
    return LaunchDescription([ComposableNodeContainer(
        name='box', namespace='', package='rclcpp_components', executable='component_container',
        composable_node_descriptions=[
            ComposableNode(package='demo', plugin='demo::Talker', name='talker'{talker}),
            ComposableNode(package='demo', plugin='demo::Listener', name='listener'{listener}),
        ])])
"""
_IN_XML = """\
<launch><node_container pkg="rclcpp_components" exec="component_container" name="box" namespace="">
<composable_node pkg="demo" plugin="demo::Talker" name="talker"{talker}
<composable_node pkg="demo" plugin="demo::Listener" name="listener"{listener}
</node_container></launch>
"""
_IN_YAML = """\
launch:
- node_container:
    pkg: rclcpp_components
    exec: component_container
    name: box
    namespace: ''
    composable_node:
    - pkg: demo
      plugin: demo::Talker
      name: talker{talker}
    - pkg: demo
      plugin: demo::Listener
      name: listener{listener}
"""
_LAUNCHES = {
    "py": (_IN_PYTHON, "", ", remappings=[('{}', 'words')]", ", namespace='robot'"),
    "xml": (
        _IN_XML,
        "/>",
        '><remap from="{}" to="words"/></composable_node>',
        ' namespace="robot"/>',
    ),
    "yaml": (
        _IN_YAML,
        "",
        "\n      remap:\n      - {{from: {}, to: words}}",
        "\n      namespace: robot",
    ),
}


def _files(commands: str, launch: str, kind: str, **more: str) -> dict[str, str | bytes]:
    return {
        "demo/package.xml": _XML,
        "demo/CMakeLists.txt": _CMAKE.format(commands=commands),
        "demo/src/first.cpp": _TALKER + _REGISTERED.format("Talker"),
        "demo/src/second.cpp": _LISTENER + _REGISTERED.format("Listener"),
        f"demo/launch/demo.launch.{kind}": launch,
        **{f"demo/{key.replace('__', '/').replace('_cpp', '.cpp').replace('_hpp', '.hpp')}": text
           for key, text in more.items()},
    }  # fmt: skip


def _told(
    folder: Path, commands: str, talker: str, listener: str, kind: str = "py", **more: str
) -> list[str]:
    launch, plain, remapped, moved = _LAUNCHES[kind]
    words = {"": plain, "moved": moved}
    texts = [words.get(each, remapped.format(each)) for each in (talker, listener)]
    text = launch.format(talker=texts[0], listener=texts[1])
    run = run_over(write_tree(folder, _files(commands, text, kind, **more)), "RG105", "RG106")
    return [str(each.rule.code) for each in run.told]


@pytest.mark.parametrize("kind", list(_LAUNCHES))
@pytest.mark.parametrize(
    ("talker", "listener", "expected"),
    [
        ("", "", []),
        ("chatter", "chatter", []),
        ("sound", "", ["RG105"]),
        ("", "sound", ["RG105"]),
        ("moved", "", ["RG106"]),
        ("", "moved", ["RG106"]),
        ("moved", "moved", []),
    ],
)
def test_a_launch_file_starts_components(
    tmp_path: Path, kind: str, talker: str, listener: str, expected: list[str]
) -> None:
    assert _told(tmp_path, _BOTH + _PLURAL, talker, listener, kind) == expected


@pytest.mark.parametrize(
    "commands",
    [
        _BOTH + _SINGLE,
        _BOTH + _SINGLE.replace(" EXECUTABLE talker", ""),
        f"set(SOURCES src/first.cpp src/second.cpp)\nadd_library(parts ${{SOURCES}})\n{_PLURAL}",
        f"file(GLOB SOURCES src/*.cpp)\nadd_library(parts ${{SOURCES}})\n{_PLURAL}",
        f"ament_auto_add_library(parts SHARED src/first.cpp src/second.cpp)\n{_PLURAL}",
        f"ament_auto_add_library(parts SHARED DIRECTORY src)\n{_PLURAL}",
        "add_library(parts SHARED)\n"
        f"target_sources(parts PRIVATE src/first.cpp src/second.cpp)\n{_PLURAL}",
        "add_library(one SHARED src/first.cpp)\nadd_library(two SHARED src/second.cpp)\n"
        'rclcpp_components_register_nodes(one "demo::Talker")\n'
        'rclcpp_components_register_nodes(two "demo::Listener")',
    ],
)
def test_ways_to_build_components(tmp_path: Path, commands: str) -> None:
    assert _told(tmp_path / "sound", commands, "sound", "") == ["RG105"]
    assert _told(tmp_path / "moved", commands, "", "moved") == ["RG106"]
    assert _told(tmp_path / "plain", commands, "", "chatter") == []


@pytest.mark.parametrize(
    ("commands", "more", "expected"),
    [
        # Who makes the node without a container has its class from a header.
        (_BOTH + _PLURAL + "\nadd_executable(both src/main.cpp)", {"src__main_cpp": _MAIN}, 1),
        # Which of two libraries is loaded is not known.
        (
            f"{_BOTH}add_library(more src/third.cpp)\n{_PLURAL}\n"
            'rclcpp_components_register_nodes(more "demo::Talker")',
            {"src__third_cpp": _TALKER + _REGISTERED.format("Talker")},
            0,
        ),
        # The class is in a source that is not read as one of a node.
        (
            "add_library(parts src/second.cpp src/third.cpp)\n" + _PLURAL,
            {"src__third_cpp": "#include <demo/made.hpp>\nDEMO_MAKE(Talker)\n"},
            0,
        ),
        # What gets the node may use the name.
        (
            _BOTH + _PLURAL,
            {
                "src__first_cpp": _TALKER.replace("10);", "10); helper_.start(this);")
                + _REGISTERED.format("Talker")
            },
            0,
        ),
    ],
)
def test_which_source_has_the_class(
    tmp_path: Path, commands: str, more: dict[str, str], expected: int
) -> None:
    found = _told(tmp_path, commands, "sound", "", **more)
    assert found == ["RG105"] * expected


def test_one_source_of_two_classes(tmp_path: Path) -> None:
    both = _TALKER + _LISTENER + _REGISTERED.format("Talker") + _REGISTERED.format("Listener")
    commands = "add_library(parts SHARED src/first.cpp)\n" + _PLURAL
    more = {"src__first_cpp": both, "src__second_cpp": "int nothing;\n"}
    assert _told(tmp_path / "one", commands, "sound", "", **more) == ["RG105"]
    assert _told(tmp_path / "two", commands, "", "moved", **more) == ["RG106"]
    assert _told(tmp_path / "none", commands, "chatter", "chatter", **more) == []


_PROGRAM = """\
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"
int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("talker");
  auto pub = node->create_publisher<std_msgs::msg::String>("chatter", 10);
  rclcpp::spin(node);
}
"""
_STARTED = """\
<launch><node pkg="demo" exec="talker"><remap from="{}" to="words"/></node></launch>
"""


@pytest.mark.parametrize(
    "commands",
    [
        "add_executable(talker src/talk/main.cpp)",
        "file(GLOB SOURCES src/talk/*.cpp)\nadd_executable(talker ${SOURCES})",
        "ament_auto_add_executable(talker DIRECTORY src/talk)",
        "add_executable(talker)\ntarget_sources(talker PRIVATE src/talk/main.cpp)",
    ],
)
def test_ways_to_build_a_program(tmp_path: Path, commands: str) -> None:
    for name, expected in (("sound", ["RG105"]), ("chatter", [])):
        more = {"src__talk__main_cpp": _PROGRAM}
        files = _files(commands, _STARTED.format(name), "xml", **more)
        run = run_over(write_tree(tmp_path / name, files), "RG105")
        assert [str(each.rule.code) for each in run.told] == expected
