"""Programs of roscpp in several sources: a class that creates endpoints, and a `main` beside it."""

from __future__ import annotations

from pathlib import Path

import pytest
from linted import run_over, write_tree

_XML = """\
<package format="2"><name>{name}</name><version>0.1.0</version><description>d</description>
<maintainer email="a@b.com">m</maintainer><license>MIT</license>
<depend>roscpp</depend></package>
"""
_CMAKE = """\
cmake_minimum_required(VERSION 3.0.2)
project(sonar)
find_package(catkin REQUIRED COMPONENTS roscpp)
add_executable(sonar {sources})
target_link_libraries(sonar ${{catkin_LIBRARIES}})
install(TARGETS sonar RUNTIME DESTINATION ${{CATKIN_PACKAGE_BIN_DESTINATION}})
"""
_HEADER = """\
#include <ros/ros.h>
#include <std_msgs/String.h>
class Sonar {
public:
  explicit Sonar(ros::NodeHandle nh);
private:
  void heard(const std_msgs::String::ConstPtr & msg);
  ros::Publisher pub_;
  ros::Subscriber sub_;
};
"""
_CLASS = """\
#include "sonar.h"
Sonar::Sonar(ros::NodeHandle nh) {
  pub_ = nh.advertise<std_msgs::String>("range", 1);
  sub_ = nh.subscribe("echo", 1, &Sonar::heard, this);
}
void Sonar::heard(const std_msgs::String::ConstPtr & msg) { pub_.publish(*msg); }
"""
_MAIN = """\
#include "sonar.h"
int main(int argc, char ** argv) {{
  ros::init(argc, argv, "sonar");
  ros::NodeHandle nh{handle};
  Sonar sonar(nh);
  ros::spin();
}}
"""
_LAUNCH = """\
<launch>
  <node pkg="sonar" type="sonar" name="bow" ns="left">
    <remap from="{remapped}" to="distance"/>
  </node>
</launch>
"""


def _told(
    folder: Path, remapped: str, sources: str, handle: str = "", **more: str
) -> list[tuple[str, str]]:
    files = {
        "sonar/package.xml": _XML.format(name="sonar"),
        "sonar/CMakeLists.txt": _CMAKE.format(sources=sources),
        "sonar/src/sonar.h": _HEADER,
        "sonar/src/sonar.cpp": _CLASS,
        "sonar/src/main.cpp": _MAIN.format(handle=handle),
        "sonar/launch/sonar.launch": _LAUNCH.format(remapped=remapped),
        **{name.replace("__", "/").replace("_cpp", ".cpp"): text for name, text in more.items()},
    }
    run = run_over(write_tree(folder, files), "RG")
    return [(str(each.rule.code), each.diagnostic.message) for each in run.told]


_TWO = "src/sonar.cpp src/main.cpp"
_NO_NAME = "`/left/bow` has no name `{}` that could be remapped"


@pytest.mark.parametrize(
    ("remapped", "sources", "is_wrong"),
    [
        ("range", _TWO, False),
        ("ranges", _TWO, True),
        ("depth", _TWO, True),
        # What is not read may have the name.
        ("depth", f"{_TWO} src/filter.cpp", False),
        ("depth", "src/main.cpp", False),
    ],
)
def test_a_class_beside_main_creates_for_its_node(
    tmp_path: Path, remapped: str, sources: str, is_wrong: bool
) -> None:
    more = {"sonar__src__filter_cpp": "int filter() { return 0; }\n"}
    found = [each for each in _told(tmp_path, remapped, sources, **more) if each[0] == "RG105"]
    assert found == ([("RG105", _NO_NAME.format(remapped))] if is_wrong else [])


def test_names_are_below_the_handle_that_main_hands_over(tmp_path: Path) -> None:
    found = [each for each in _told(tmp_path, "range", _TWO, '("bow_sonar")') if each[0] == "RG105"]
    assert found != []
    assert _told(tmp_path / "other", "bow_sonar/range", _TWO, '("bow_sonar")') == []


def test_two_mains_are_not_one_program(tmp_path: Path) -> None:
    other = _MAIN.format(handle="").replace('"sonar")', '"other")')
    found = _told(tmp_path, "ranges", f"{_TWO} src/other.cpp", sonar__src__other_cpp=other)
    assert [each for each in found if each[0] == "RG105"] == []


def test_who_meets_the_class_is_told_the_name_of_the_node(tmp_path: Path) -> None:
    talker = (
        "import rospy\nfrom std_msgs.msg import Int32\nrospy.init_node('talker')\n"
        "pub = rospy.Publisher('/left/echo', Int32, queue_size=1)\n"
    )
    launch = _LAUNCH.format(remapped="range").replace(
        "</launch>", '<node pkg="sonar" type="talker.py" name="talker"/></launch>'
    )
    more = {"sonar__scripts__talker.py": talker, "sonar__launch__sonar.launch": launch}
    ((code, message),) = _told(tmp_path, "range", _TWO, **more)
    assert code == "RG101"
    assert "`/left/bow`" in message or "`/talker`" in message
