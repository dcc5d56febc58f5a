"""Hand-written C++ nodes of a source and a header, changed and generated again and again."""

from __future__ import annotations

from pathlib import Path

import pytest
from again_driver import Bench
from machine import mostly_long
from test_pairs import HEADER, SOURCE

ROS_HEADER = """\
#pragma once
#include <ros/ros.h>
#include <std_msgs/Int32.h>
#include <std_msgs/String.h>

class Robot
{
public:
  Robot();

private:
  void on_command(const std_msgs::String::ConstPtr & msg);

  ros::NodeHandle nh_;
  ros::Publisher count_;
  ros::Subscriber command_;
};
"""
ROS_SOURCE = """\
#include "robot.hpp"

Robot::Robot()
{
  count_ = nh_.advertise<std_msgs::Int32>("count", 10);
  command_ = nh_.subscribe("command", 1, &Robot::on_command, this);
}

void Robot::on_command(const std_msgs::String::ConstPtr & msg)
{
  ROS_INFO("%s", msg->data.c_str());
}

int main(int argc, char ** argv)
{
  ros::init(argc, argv, "robot");
  Robot robot;
  ros::spin();
  return 0;
}
"""
PAIRS = {"roscpp": (ROS_SOURCE, ROS_HEADER), "rclcpp": (SOURCE, HEADER)}

# How a pair is loaded: the statement, where it is, where it is written, whether in place.
WAYS = {
    "beside": ("load robot as n\n", ".", "output/src", False),
    "in the output": ("load robot as n\n", "output", "output/src", False),
    "by its path": ("load 'nodes/robot.cpp' as n\n", "nodes", "output/src", False),
    "in place": ("load 'nodes/robot.cpp' as n\n", "nodes", "nodes", True),
}
CHANGES = {
    "publish": "n publish hello to 'chatter' of message_type String\n",
    "subscribe": "subscribe n to 'numbers' of message_type Int32\n",
    "unsubscribe": "unsubscribe n from 'command'\n",
    "parameter": "n has_parameter 'speed' of parameter_type float with default 1.5\n",
    "service": "n provides_service 'reset' of service_type Trigger\n",
    "client": "n client_requests 'zero' of service_type Empty with input none\n",
}
CASES = [f"{x}-{y}-{z}" for x in PAIRS for y in WAYS for z in CHANGES]
QUICK = ["roscpp-in place-subscribe", "rclcpp-by its path-service"]


@pytest.mark.parametrize("case", mostly_long(CASES, QUICK))
def test_changes_come_and_go_under_handwork(tmp_path: Path, case: str) -> None:
    library, way, change = case.split("-")
    load, origin, written, in_place = WAYS[way]
    bench = Bench(tmp_path, library)
    texts = dict(zip(("robot.cpp", "robot.hpp"), PAIRS[library], strict=True))
    for name, text in texts.items():
        bench.put(f"{origin}/{name}", text)

    def generate(statements: str) -> list[str]:
        outcome = bench.generate(f"{load}{statements}generate_node n\n", in_place=in_place)
        assert outcome[2:] == ([], [])
        return outcome.states

    def now() -> dict[str, str]:
        return {name: (tmp_path / written / name).read_text() for name in texts}

    generate(CHANGES[change])
    before = bench.files()
    assert set(generate(CHANGES[change])) == {"identical"}
    assert bench.files() == before
    generate("")
    assert now() == texts

    generate(CHANGES[change])
    bench.edit(f"{written}/robot.cpp", "int main(", "// mine\nint main(")
    bench.edit(f"{written}/robot.hpp", "class Robot", "/// Mine.\nclass Robot")
    mine = now()
    assert set(generate(CHANGES[change])) == {"identical"}
    assert now() == mine
    generate("")
    texts["robot.cpp"] = texts["robot.cpp"].replace("int main(", "// mine\nint main(")
    texts["robot.hpp"] = texts["robot.hpp"].replace("class Robot", "/// Mine.\nclass Robot")
    assert now() == texts
    if written != origin and way != "in the output":
        generate(CHANGES[change])
        bench.edit(f"{origin}/robot.hpp", "public:", "public:  // theirs")
        generate(CHANGES[change])
        assert "public:  // theirs" in now()["robot.hpp"]
        assert "/// Mine.\n" in now()["robot.hpp"] and "// mine\n" in now()["robot.cpp"]
