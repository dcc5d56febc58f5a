"""Names that a function that a statement asks for cannot have in a file."""

from __future__ import annotations

import pytest
from patches import refusal

from plastron_tui.diagnostics import Span
from plastron_tui.model.kinds import Subscription, Timer
from plastron_tui.model.source import Add
from plastron_tui.ros.interfaces import InterfaceName

TYPE = InterfaceName("std_msgs", "String")
TEXT = """
 #include <rclcpp/rclcpp.hpp>
 #include <std_msgs/msg/string.hpp>
 class A : public rclcpp::Node {
  public:
   A() : Node("a") {
     pub_ = create_publisher<std_msgs::msg::String>("out", 1);
     begun_ = now();
   }

  private:
   rclcpp::Publisher<std_msgs::msg::String>::SharedPtr pub_;
   rclcpp::Time begun_;
 };
"""


@pytest.mark.parametrize(
    "name", ["pub_", "now", "create_publisher", "get_logger", "M_PI", "SIGINT", "RCLCPP_INFO"]
)
def test_names_that_are_something_else_in_the_file_are_refused(name: str) -> None:
    heard = Add(Subscription("b", TYPE, callback=name, span=Span(0, 0)))
    ticks = Add(Timer(name, rate=1.0, span=Span(0, 0)))
    assert refusal(TEXT, heard).startswith("invalid-function: ")
    assert refusal(TEXT, ticks).startswith("invalid-function: ")
