"""What is told of lines that a change leaves behind."""

from __future__ import annotations

import pytest
from patches import edit, sides

from plastron_tui.model.source import EndpointKind, Remove, Rename

K = EndpointKind

SAID = [
    ("// publishes on the topic speed", ["line 10 still says `speed`"]),
    ("// the speed is high", []),
    ("// publishes /speed", ["line 10 still says `speed`"]),
    ('// pub_ = f("/speed");', []),
    ('RCLCPP_INFO(get_logger(), "sent to /speed");', ["line 10 still says `speed`"]),
    ('RCLCPP_INFO(get_logger(), "speed is %f", 1.0);', []),
    ('f("speed");', ["line 10 still says `speed`"]),
    ('frame_id = "speed";', []),
    ('f("speed_limit");', []),
]


@pytest.mark.parametrize(("line", "expected"), SAID)
def test_lines_that_still_say_a_name_are_told(line: str, expected: list[str]) -> None:
    text = f"""
 #include <rclcpp/rclcpp.hpp>
 #include <std_msgs/msg/string.hpp>
 class A : public rclcpp::Node {{
  public:
   A() : Node("a") {{
     pub_ = create_publisher<std_msgs::msg::String>("speed", 1);
   }}

   void f() {{
     {line}
   }}
   rclcpp::Publisher<std_msgs::msg::String>::SharedPtr pub_;
 }};
"""
    before, _ = sides(text)
    files, told = edit(before, Rename(K.PUBLISHER, "speed", "pace"))
    assert files is not None
    assert [each.message for each in told] == expected


def test_functions_that_nothing_calls_any_more_are_told() -> None:
    text = """
 #include <ros/ros.h>
 #include <std_msgs/String.h>
 int count = 0;
 void add() { count++; }
 void heard(const std_msgs::String& msg) { add(); }
 void unused() { count = 0; }
 int main(int c, char** v) {
   ros::init(c, v, "n");
   ros::NodeHandle nh;
   auto sub = nh.subscribe("in", 1, heard);
 }
"""
    before, _ = sides(text)
    files, told = edit(before, Remove(K.SUBSCRIPTION, "in"))
    assert files is not None
    assert [each.message for each in told] == [
        "nothing in the file calls `heard` (line 5) any more"
    ]
