"""RM205 of types that are not of the common ones: somebody has to read the stamp."""

from __future__ import annotations

import pytest
from message_programs import told

_PYTHON = """\
import rclpy
from actionlib_msgs.msg import GoalStatusArray
from builtin_interfaces.msg import Time
from rclpy.node import Node


class Worker(Node):
    def __init__(self):
        super().__init__('worker')
        self.states = self.create_publisher(GoalStatusArray, 'states', 10)
        self.create_subscription(GoalStatusArray, 'others', self.on_states, 10)
        self.create_timer(1.0, self.tick)

    def tick(self):
        msg = GoalStatusArray()
        self.states.publish(msg)

    def on_states(self, msg: GoalStatusArray):
        {}


def main():
    rclpy.init()
    rclpy.spin(Worker())
"""
_CPP = """\
#include <actionlib_msgs/msg/goal_status_array.hpp>
#include <rclcpp/rclcpp.hpp>

class Worker : public rclcpp::Node
{{
public:
  Worker() : Node("worker")
  {{
    states_ = create_publisher<actionlib_msgs::msg::GoalStatusArray>("states", 10);
    timer_ = create_wall_timer(std::chrono::seconds(1), [this]() {{ tick(); }});
  }}

private:
  void tick()
  {{
    actionlib_msgs::msg::GoalStatusArray msg;
    states_->publish(msg);
  }}

  void on_states(actionlib_msgs::msg::GoalStatusArray & msg)
  {{
    {}
  }}

  rclcpp::TimerBase::SharedPtr timer_;
  rclcpp::Publisher<actionlib_msgs::msg::GoalStatusArray>::SharedPtr states_;
}};

int main(int argc, char ** argv)
{{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Worker>());
}}
"""
_SET = [
    (_PYTHON, ".py", "pass"),
    (_PYTHON, ".py", "msg.header.stamp = Time()"),
    (_PYTHON, ".py", "msg.header.stamp, self.last = Time(), msg"),
    (_PYTHON, ".py", "self.tell(msg.header.frame_id)"),
    (_CPP, ".cpp", ""),
    (_CPP, ".cpp", "msg.header.stamp = now();"),
    (_CPP, ".cpp", "tell(msg.header.frame_id);"),
]
_READ = [
    (_PYTHON, ".py", "self.tell(msg.header.stamp)"),
    (_PYTHON, ".py", "self.last = msg.header"),
    (_PYTHON, ".py", "msg.header.stamp.sec += 1"),
    (_CPP, ".cpp", "tell(msg.header.stamp);"),
    (_CPP, ".cpp", "last_ = msg.header;"),
    (_CPP, ".cpp", "msg.header.stamp.sec += 1;"),
]


@pytest.mark.parametrize(("text", "suffix", "use"), _SET)
def test_a_stamp_that_nobody_reads_is_not_told(text: str, suffix: str, use: str) -> None:
    assert told(text.format(use), "RM205", suffix) == []


@pytest.mark.parametrize(("text", "suffix", "use"), _READ)
def test_a_stamp_that_somebody_reads_is_told(text: str, suffix: str, use: str) -> None:
    publish = "self.states.publish(msg)" if suffix == ".py" else "states_->publish(msg);"
    assert told(text.format(use), "RM205", suffix) == [publish]
