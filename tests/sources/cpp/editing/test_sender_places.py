"""Where a file sends through a publisher that it has, and headers that go with the last use."""

from __future__ import annotations

import pytest
from additions import publish, subscribe
from patches import edit, sides

from plastron_tui.model.source import EndpointKind, Remove

NODE = """
 #include <rclcpp/rclcpp.hpp>
 #include <std_msgs/msg/string.hpp>
 class A : public rclcpp::Node {
  public:
   A() : Node("a") {
     pub_ = create_publisher<std_msgs::msg::String>("out", 1);
   }

  private:
   rclcpp::Publisher<std_msgs::msg::String>::SharedPtr pub_;
 };
"""


def test_a_header_goes_with_the_last_that_needs_it() -> None:
    start = sides(NODE)[0]
    added, told = edit(start, subscribe("imu"))
    assert added is not None, told
    assert b"#include <functional>\n" in added.main
    assert edit(added, Remove(EndpointKind.SUBSCRIPTION, "imu"))[0] == start


BASE = """
 #include <ros/ros.h>
 #include <std_msgs/String.h>
 class Base {
  public:
   Base() { pub_ = nh_.advertise<std_msgs::String>("out", 1); }
   ros::NodeHandle nh_;
  ACCESS:
   ros::Publisher pub_;
 };
 class A : public Base {
  public:
   A() { other_ = nh_.advertise<std_msgs::String>("b", 1); }
   ros::Publisher other_;
 };
 int main(int c, char ** v)
 {
   ros::init(c, v, "n");
   A a;
   ros::spin();
 }
"""


@pytest.mark.parametrize(("access", "is_derived"), [("private", False), ("protected", True)])
def test_a_private_publisher_is_sent_through_in_its_class(access: str, is_derived: bool) -> None:
    changed, told = edit(
        sides(BASE.replace("ACCESS", access))[0], publish("out", rate=2.0, data="x")
    )
    assert changed is not None, told
    assert (b"createTimer" in changed.main.partition(b"class A")[2]) is is_derived


LATER = """
 #include <ros/ros.h>
 #include <std_msgs/String.h>
 class A {
  public:
   A() { sub_ = nh_.subscribe("in", 1, &A::hear, this); }
   void hear(const std_msgs::String& msg) { PUB = nh_.advertise<std_msgs::String>("out", 1); }
   ros::NodeHandle nh_;
   ros::Subscriber sub_;
   ros::Publisher pub_;
 };
"""


def test_a_timer_is_not_made_where_a_callback_makes_the_publisher() -> None:
    changed, told = edit(sides(LATER.replace("PUB", "pub_"))[0], publish("out", rate=2.0, data="x"))
    assert changed is not None, told
    assert b"createTimer" in changed.main.partition(b"void hear")[0]
    local = LATER.replace("PUB", "ros::Publisher p")
    assert edit(sides(local)[0], publish("out", rate=2.0, data="x"))[0] is None


OTHER = """
 #include <ros/ros.h>
 #include <std_msgs/String.h>
 class Late {
  public:
   explicit Late(ros::NodeHandle nh) : nh_(nh) { sub_ = nh_.subscribe("in", 1, &Late::hear, this); }
   void hear(const std_msgs::String& msg) { pub_ = nh_.advertise<std_msgs::String>("out", 1); }
   ros::NodeHandle nh_;
   ros::Subscriber sub_;
   ros::Publisher pub_;
 };
 int main(int c, char ** v)
 {
   ros::init(c, v, "n");
   ros::NodeHandle nh;
   ros::Publisher b = nh.advertise<std_msgs::String>("b", 1);
   Late late(nh);
   ros::spin();
 }
"""


def test_no_timer_is_made_in_the_callback_of_another_class() -> None:
    changed, _ = edit(sides(OTHER)[0], publish("out", rate=2.0, data="x"))
    assert changed is None or b"createTimer" not in changed.main.partition(b"void hear")[2]
