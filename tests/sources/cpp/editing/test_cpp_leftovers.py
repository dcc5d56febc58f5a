"""Which statements a removal from a node of roscpp takes, and what stays as it is."""

from __future__ import annotations

import pytest
from patches import check, edit, refusal, sides

from plastron_tui.model.source import EndpointKind, Remove

K = EndpointKind


def test_a_broadcaster_goes_with_what_it_sends() -> None:
    text = """
 #include <ros/ros.h>
 #include <tf/transform_broadcaster.h>
 int main(int c, char ** v)
 {
   ros::init(c, v, "n");
   ros::NodeHandle nh;
-  tf::TransformBroadcaster br;
   tf::Transform t;
-  br.sendTransform(tf::StampedTransform(t, ros::Time::now(), "a", "b"));
   ros::spin();
 }
"""
    check(text, Remove(K.PUBLISHER, "/tf"))


def test_a_macro_before_a_function_goes_with_it() -> None:
    text = """
 #include <ros/ros.h>
-#include <std_msgs/Int32.h>
 class ROBOT_PUBLIC A {
  public:
-  ROBOT_PUBLIC A() {
-    sub_ = nh_.subscribe("a", 1, &A::heard, this);
-  }
+  ROBOT_PUBLIC A() {}
-  ROBOT_LOCAL void heard(const std_msgs::Int32& msg);
   ROBOT_LOCAL void other();
   ros::NodeHandle nh_;
-  ros::Subscriber sub_;
 };

-ROBOT_LOCAL
-void A::heard(const std_msgs::Int32& msg) {
-  ROS_INFO("heard");
-}
-
 ROBOT_LOCAL
 void A::other() {}
"""
    check(text, Remove(K.SUBSCRIPTION, "a"))


RULED = [
    ("if (on_)\n       {};", ""),
    ("if (on_) {};", ""),
    ("if (on_) {{\n       {};\n     }}", ""),
    ("if (check())\n       {};", "if (check())\n       {}"),
    ("for (;;) {};", "for (;;) {}"),
    ("if (on_) other();\n     else {};", "if (on_) other();\n     else {}"),
    ("if (on_) {{ {}; }} else {{ other(); }}", "if (on_) {} else { other(); }"),
]


@pytest.mark.parametrize(("before", "after"), RULED)
def test_the_next_statement_comes_under_no_condition(before: str, after: str) -> None:
    text = """
 #include <ros/ros.h>
 #include <std_msgs/Int32.h>
 class A {{
   void f() {{
     first();
{}
     other();
   }}
   void init() {{ pub_ = nh_.advertise<std_msgs::Int32>("a", 1); }}
   ros::NodeHandle nh_;
   ros::Publisher pub_;
   std_msgs::Int32 last_;
 }};
"""
    given, _ = sides(text.format("     " + before.format("pub_.publish(last_)")))
    files, told = edit(given, Remove(K.PUBLISHER, "a"))
    assert files is not None, told
    body = files.main.decode().partition("first();\n")[2].partition("    other();\n  }\n")[0]
    lines = [line.strip() for line in body.splitlines()]
    assert "\n".join(lines) == "\n".join(line.strip() for line in after.splitlines())


def test_an_endpoint_that_is_handed_on_stays() -> None:
    text = """
 #include <ros/ros.h>
 #include <std_msgs/String.h>
 void use(ros::Publisher & pub);
 int main(int c, char ** v)
 {
   ros::init(c, v, "n");
   ros::NodeHandle nh;
   ros::Publisher pub = nh.advertise<std_msgs::String>("a", 1);
   use(pub);
 }
"""
    assert refusal(text, Remove(K.PUBLISHER, "a")) == (
        "endpoint-in-use: the publisher `a` is used in line 9"
    )


def test_a_lambda_that_only_a_variable_holds_goes() -> None:
    text = """
 #include "rclcpp/rclcpp.hpp"
-#include "std_msgs/msg/string.hpp"

 class Ear : public rclcpp::Node
 {
 public:
   Ear()
   : Node("ear")
   {
-    auto words_callback = [this](std_msgs::msg::String::UniquePtr msg) -> void {
-      RCLCPP_INFO(this->get_logger(), "%s", msg->data.c_str());
-    };
-    words_ = this->create_subscription<std_msgs::msg::String>("words", 10, words_callback);
   }
-
-private:
-  rclcpp::Subscription<std_msgs::msg::String>::SharedPtr words_;
 };
"""
    check(text, Remove(K.SUBSCRIPTION, "words"))
