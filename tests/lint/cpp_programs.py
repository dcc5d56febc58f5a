"""Nodes in C++ with something in a callback, and what is known of their code."""

from __future__ import annotations

from pathlib import Path

from plastron_tui.model.code_facts import CodeFacts
from plastron_tui.model.source import FileSet
from plastron_tui.sources.cpp.facts import code_facts
from plastron_tui.sources.cpp.reader import read_cpp

ROS2 = """\
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"
#include "std_srvs/srv/trigger.hpp"
using namespace std::chrono_literals;
using std::placeholders::_1;
class Talker : public rclcpp::Node {{
public:
  Talker() : Node("talker") {{
    {setup}
  }}
private:
  void heard(const std_msgs::msg::String::SharedPtr msg) {{
    {callback}
  }}
  void ask() {{
    auto request = std::make_shared<std_srvs::srv::Trigger::Request>();
    auto future = client_->async_send_request(request);
    {ask}
  }}
  rclcpp::Client<std_srvs::srv::Trigger>::SharedPtr client_;
  rclcpp::Publisher<std_msgs::msg::String>::SharedPtr pub_;
  rclcpp::Subscription<std_msgs::msg::String>::SharedPtr sub_;
  rclcpp::TimerBase::SharedPtr timer_;
  {more}
}};
int main(int argc, char ** argv) {{
  rclcpp::init(argc, argv);
  {main}
}}
"""
SETUP = """client_ = create_client<std_srvs::srv::Trigger>("go");
    sub_ = create_subscription<std_msgs::msg::String>(
      "chatter", 10, std::bind(&Talker::heard, this, _1));"""
MAIN = "rclcpp::spin(std::make_shared<Talker>());"
SPUN = "rclcpp::spin_until_future_complete(shared_from_this(), future)"
SLEPT = "std::this_thread::sleep_for(1s)"
PUB = 'create_publisher<std_msgs::msg::String>("out", 10)'

ROS1 = """\
#include <ros/ros.h>
#include <std_msgs/String.h>
void heard(const std_msgs::String::ConstPtr & msg) {{
  {callback}
}}
int main(int argc, char ** argv) {{
  ros::init(argc, argv, "talker");
  ros::NodeHandle nh;
  {main}
}}
"""
SUB1 = 'ros::Subscriber sub = nh.subscribe("chatter", 10, heard);'


def facts(text: str) -> CodeFacts:
    path = Path("/ws/src/talker.cpp")
    source = read_cpp(path, FileSet.single(".cpp", text.encode())).source
    assert source is not None
    return code_facts(source)


def ros2(
    callback: str = "", ask: str = "", setup: str = SETUP, main: str = MAIN, more: str = ""
) -> str:
    return ROS2.format(callback=callback, ask=ask, setup=setup, main=main, more=more)


def ros1(callback: str = "", main: str = f"{SUB1} ros::spin();") -> str:
    return ROS1.format(callback=callback, main=main)


def at(text: str, found: tuple[object, ...]) -> list[str]:
    """Return the source of what facts are about."""
    return [text[each.span.start : each.span.end] for each in found]  # type: ignore[attr-defined]
