"""A node of a source and a header is generated again and again as one of a single file is."""

from __future__ import annotations

from pathlib import Path

import pytest
from again_driver import Bench

HEADER = """\
#pragma once

#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/int32.hpp"
#include "std_msgs/msg/string.hpp"

class Robot : public rclcpp::Node
{
public:
  Robot();

private:
  void on_command(const std_msgs::msg::String::SharedPtr msg);
  void tick();

  rclcpp::Publisher<std_msgs::msg::Int32>::SharedPtr count_;
  rclcpp::Subscription<std_msgs::msg::String>::SharedPtr command_;
  rclcpp::TimerBase::SharedPtr timer_;
};
"""
SOURCE = """\
#include "robot.hpp"

using namespace std::chrono_literals;
using std::placeholders::_1;

Robot::Robot()
: Node("robot")
{
  count_ = create_publisher<std_msgs::msg::Int32>("count", 10);
  command_ = create_subscription<std_msgs::msg::String>(
    "command", 10, std::bind(&Robot::on_command, this, _1));
  timer_ = create_wall_timer(200ms, std::bind(&Robot::tick, this));
}

void Robot::on_command(const std_msgs::msg::String::SharedPtr msg)
{
  RCLCPP_INFO(get_logger(), "%s", msg->data.c_str());
}

void Robot::tick()
{
  RCLCPP_INFO(get_logger(), "tick");
}

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Robot>());
  rclcpp::shutdown();
}
"""
LOAD = "load 'nodes/robot.cpp' as n\n"
FEWER = "unsubscribe n from 'command'\n"
FEWEST = f"{FEWER}n stop_publishing to 'count'\n"
TICK, MORE = "  void tick();\n", "  void tick();\n  int n_;\n"
IN_OUTPUT = {True: "nodes", False: "output/src"}


def _texts(folder: Path) -> tuple[str, str]:
    return (folder / "robot.cpp").read_text(), (folder / "robot.hpp").read_text()


@pytest.mark.parametrize("in_place", [True, False])
def test_both_files_are_generated_again(tmp_path: Path, in_place: bool) -> None:
    bench = Bench(tmp_path, "rclcpp")
    bench.put("nodes/robot.cpp", SOURCE)
    bench.put("nodes/robot.hpp", HEADER)
    made = tmp_path / IN_OUTPUT[in_place]

    def generate(statements: str) -> tuple[list[str], list[str], list[str], list[str]]:
        return bench.generate(f"{LOAD}{statements}generate_node n\n", in_place=in_place)

    first = generate(FEWER)
    assert first[1:] == ([], [], [])
    source, header = _texts(made)
    assert "command" not in source + header
    before = bench.files()
    assert set(generate(FEWER)[0]) == {"identical"}
    assert bench.files() == before

    by_hand = source.replace('"tick"', '"tock"')
    (made / "robot.cpp").write_text(by_hand)
    (made / "robot.hpp").write_text(
        header.replace("  void tick();\n", "  void tick();\n  int n_;\n")
    )
    assert set(generate(FEWER)[0]) == {"identical"}
    assert _texts(made) == (by_hand, (made / "robot.hpp").read_text())

    assert generate(FEWEST)[2:] == ([], [])
    source, header = _texts(made)
    assert "count" not in source + header
    assert '"tock"' in source and "int n_;" in header

    assert generate("")[2:] == ([], [])
    assert _texts(made) == (
        SOURCE.replace('"tick"', '"tock"'),
        HEADER.replace(TICK, MORE),
    )
