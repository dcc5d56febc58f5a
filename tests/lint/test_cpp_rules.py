"""What rules say of workspaces in C++, from the files to the words."""

from __future__ import annotations

from pathlib import Path

import pytest
from linted import write_tree

from plastron_tui.lint import lint
from plastron_tui.lint.rules import RULES
from plastron_tui.project.linting import read_tree
from plastron_tui.project.linting.cache import FactCache

NODE = """\
#include "rclcpp/rclcpp.hpp"
#include "geometry_msgs/msg/pose_stamped.hpp"
#include "std_msgs/msg/string.hpp"
class N : public rclcpp::Node {{
public:
  N() : Node("n") {{
    pub_ = create_publisher<geometry_msgs::msg::PoseStamped>("pose", 10);
    timer_ = create_wall_timer(std::chrono::seconds(1), [this]() {{ tick(); }});
    {more}
  }}
  void tick() {{
    geometry_msgs::msg::PoseStamped pose;
    std_msgs::msg::String text;
    {body}
    {header}
    pub_->publish(pose);
  }}
  rclcpp::Publisher<geometry_msgs::msg::PoseStamped>::SharedPtr pub_;
  rclcpp::TimerBase::SharedPtr timer_;
}};
int main(int argc, char ** argv) {{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<N>());
}}
"""
LOG = 'RCLCPP_INFO(get_logger(), "slept");'
OTHER = "other_ = create_wall_timer(std::chrono::seconds(2), []() {});"
HEADER = 'pose.header.stamp = now(); pose.header.frame_id = "map";'


def told(folder: Path, body: str, header: str = HEADER, more: str = OTHER) -> list[tuple[str, str]]:
    """Return the codes and the source of what is told."""
    root = folder / "src"
    root.mkdir()
    text = NODE.format(body=body, header=header, more=more)
    (root / "n.cpp").write_text(text)
    tree = read_tree([root], FactCache(root, folder / "cache"), workers=1)
    rules = [each for each in RULES.values() if not each.is_opt_in]
    spans = [(each.rule.code, each.diagnostic.span) for each in lint(tree, rules)]
    return [(code, text[span.start : span.end] if span else "") for code, span in spans]


@pytest.mark.parametrize(
    ("body", "found"),
    [
        ("pose.pose.position.w = 1.0;", [("RM201", "w")]),
        ("pose.pose.position.x = 1;", []),
        ("pose.pose.position.x = true;", []),
        ('pose.pose.position.x = "1.0";', [("RM202", '"1.0"')]),
        ("text.data = 5;", [("RM202", "5")]),
        ("pose.pose = text;", [("RM202", "text")]),
        ("pose.pose.position = pose.pose.orientation;", [("RM202", "pose.pose.orientation")]),
        ("text.data = pose.header.frame_id;", []),
        ("std::this_thread::sleep_for(std::chrono::seconds(2));",
         [("RC402", "std::this_thread::sleep_for(std::chrono::seconds(2))")]),
    ],
)  # fmt: skip
def test_rules_look_at_cpp(tmp_path: Path, body: str, found: list[tuple[str, str]]) -> None:
    assert told(tmp_path, body) == found


_PACKAGE = """\
<package format="3"><name>arm</name><version>0.1.0</version><description>d</description>
<maintainer email="a@b.com">m</maintainer><license>MIT</license>
<export><build_type>ament_cmake</build_type></export></package>
"""
_LISTS = "project(arm)\nfind_package(ament_cmake REQUIRED)\n"


@pytest.mark.parametrize(
    ("file", "lists", "is_built"),
    [
        ("src/n.cpp", "add_executable(n src/n.cpp)", True),
        ("src/n.cpp", "set(S ${CMAKE_CURRENT_SOURCE_DIR}/src/n.cpp)\nadd_library(n ${S})", True),
        ("src/n.cpp", "foreach(x n m)\nadd_executable(${x} src/${x}.cpp)\nendforeach()", True),
        ("src/n.cpp", "file(GLOB_RECURSE SRC src/*.cpp)\nadd_library(n ${SRC})", True),
        ("src/n.cpp", "my_own_node(n)", True),
        ("src/n.cpp", "aux_source_directory(src SRC)\nadd_library(m ${SRC})", True),
        ("src/n.cpp", "ament_auto_add_library(m DIRECTORY src)", True),
        ("../n.cpp", "add_executable(n n.cpp)", False),
        ("draft/n.cpp", "add_executable(m src/n.cpp)", False),
        ("src/n.cpp", "add_executable(m src/m.cpp)\n# add_executable(n src/n.cpp)", False),
        ("src/n.cpp", "add_executable(m src/m.cpp)\n#[[add_executable(n\n src/n.cpp)]]", False),
        ("old/n.cpp", "file(GLOB SRC src/*.cpp)\nadd_library(m ${SRC})", False),
    ],
)  # fmt: skip
def test_code_that_no_command_builds_is_left_alone(
    tmp_path: Path, file: str, lists: str, *, is_built: bool
) -> None:
    text = NODE.format(body="text.data = 5;", header=HEADER, more=OTHER)
    files = {"p/package.xml": _PACKAGE, "p/CMakeLists.txt": _LISTS + lists, f"p/{file}": text}
    root = write_tree(tmp_path, files)
    tree = read_tree([root], FactCache(root, tmp_path / "cache"), workers=1)
    assert any(True for _ in RULES["RM202"].check(tree)) is is_built


def test_messages_without_a_header_are_told(tmp_path: Path) -> None:
    sent = "pub_->publish(pose)"
    assert told(tmp_path, "", header="") == [("RM205", sent)]


@pytest.mark.parametrize(
    ("after", "more", "found"),
    [
        ("", "", []),
        ("rclcpp::shutdown();", OTHER, []),
        ("sleep(2);", OTHER, ["RC402"]),
        ("", f"{OTHER} third_ = create_wall_timer(1s, []() {{ sleep(1); {LOG} }});", ["RC402"]),
    ],
)
def test_sleep_that_holds_up_nothing_is_not_told(
    tmp_path: Path, after: str, more: str, found: list[str]
) -> None:
    body = f"if (count_++ > 3) {{ sleep(1); {after} }}"
    assert [code for code, _ in told(tmp_path, body, more=more)] == found


def test_rosserial_is_not_roscpp(tmp_path: Path) -> None:
    text = """\
#include <ros.h>
#include <std_msgs/String.h>
ros::NodeHandle nh;
void heard(const std_msgs::String& msg) { sleep(2); }
int main() {
  nh.subscribe("a", 1, heard);
  nh.subscribe<std_msgs::String>("b", 1, heard);
  ros::spin();
}
"""
    for at, (include, count) in enumerate([("ros.h", 0), ("ros/ros.h", 2)]):
        root = write_tree(tmp_path / str(at), {"a.cpp": text.replace("ros.h", include, 1)})
        tree = read_tree([root], FactCache(root, tmp_path / f"cache{at}"), workers=1)
        assert len(list(RULES["RC406"].check(tree))) == count
