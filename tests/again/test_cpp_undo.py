"""A removal that is taken back gives the bytes that were there, or says that it cannot."""

from __future__ import annotations

from pathlib import Path

import pytest

from plastron_tui.output.writer import write
from plastron_tui.session import Options, Session

NODE = """\
#include <ros/ros.h>
#include <std_msgs/String.h>

int count = 0;

void onIn(const std_msgs::String::ConstPtr& msg)
{
  ROS_WARN("heard %s", msg->data.c_str());
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "n");
  ros::NodeHandle nh;
  ros::Subscriber in = nh.subscribe("in", 10, &onIn);
  ros::spin();
}
"""
LOAD = "load 'n.cpp' as n\n"
OUT = f"{LOAD}unsubscribe n from 'in'\ngenerate_node n\n"
BACK = f"{LOAD}generate_node n\n"
MINE = "void mine()\n{\n  count++;\n}\n\n"
HANDWORK = {
    "none": ("", ""),
    "the line above": ("int count = 0;\n", "int count = 1;\n"),
    "the line below": ("int main(int argc, char** argv)", "int main(int argc, char ** argv)"),
    "a function above": ("int count = 0;\n", f"{MINE}int count = 0;\n"),
    "a line at the creation": ("  ros::spin();", "  ros::AsyncSpinner s(2);\n  ros::spin();"),
    "the line below the creation": ("  ros::spin();", "  ros::waitForShutdown();"),
    "the line above the creation": ("  ros::NodeHandle nh;", "  ros::NodeHandle nh;  // mine"),
}


def run(folder: Path, program: str) -> list[str]:
    options = Options("roscpp", folder / "output", in_place=True)
    session = Session(program.encode(), folder / "a.plastron", options, environ={})
    plan, told = session.plan()
    assert not plan.conflicts
    assert write(plan).diagnostics == ()
    return [each.message for each in (*session.diagnostics, *told)]


@pytest.mark.parametrize(("old", "new"), HANDWORK.values(), ids=HANDWORK)
def test_what_comes_back_is_as_it_was(tmp_path: Path, old: str, new: str) -> None:
    path = tmp_path / "n.cpp"
    path.write_text(NODE)
    run(tmp_path, OUT)
    assert "onIn" not in path.read_text()
    path.write_text(path.read_text().replace(old, new, 1))
    told = run(tmp_path, BACK)
    assert path.read_text() == NODE.replace(old, new, 1)
    assert [each for each in told if "is written anew" in each] == []


def test_what_cannot_come_back_as_it_was_is_told(tmp_path: Path) -> None:
    path = tmp_path / "n.cpp"
    path.write_text(NODE)
    run(tmp_path, OUT)
    old = "int count = 0;\n\nint main(int argc, char** argv)\n"
    text = path.read_text()
    assert old in text
    path.write_text(text.replace(old, "int count = 1;\nint more;\nint main(int c, char** argv)\n"))
    told = run(tmp_path, BACK)
    assert any("is written anew, not as it was" in each and "ROS_WARN" in each for each in told)
    text = path.read_text()
    assert "onIn" in text and "int more;" in text
