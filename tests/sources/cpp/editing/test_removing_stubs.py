"""Stubs that go with what called them, with their comments; and what is more than a stub."""

from __future__ import annotations

import pytest
from patches import check

from plastron_tui.model.source import EndpointKind, Remove

REMOVALS = {
    "a block of doxygen": """
 #include <ros/ros.h>
-#include <std_msgs/String.h>

 class Hearer {
  public:
-  Hearer() { sub_ = nh_.subscribe("in", 1, &Hearer::heard, this); }
+  Hearer() {}

-  /**
-   * @brief Called for each message of in
-   */
-  void heard(const std_msgs::String& msg) { ROS_INFO_STREAM(msg); }
-
   /**
    * @brief Does something else
    */
   void other();

  private:
   ros::NodeHandle nh_;
-  ros::Subscriber sub_;
 };
""",
    "a block that is not about it": """
 #include <ros/ros.h>
-#include <std_msgs/String.h>

 class Hearer {
  public:
-  Hearer() { sub_ = nh_.subscribe("in", 1, &Hearer::heard, this); }
+  Hearer() {}

   /* The callbacks,
      in their order. */
-  void heard(const std_msgs::String& msg) { ROS_INFO_STREAM(msg); }
   void other();

  private:
   ros::NodeHandle nh_;
-  ros::Subscriber sub_;
 };
""",
    "a lambda of a name": """
 #include <rclcpp/rclcpp.hpp>
-#include <std_msgs/msg/string.hpp>

 class Hearer : public rclcpp::Node
 {
 public:
   Hearer() : Node("hearer")
   {
-    auto heard = [this](const std_msgs::msg::String & msg) {
-      RCLCPP_INFO(get_logger(), "%s", msg.data.c_str());
-    };
-    sub_ = create_subscription<std_msgs::msg::String>("in", 10, heard);
     start();
   }

 private:
-  rclcpp::Subscription<std_msgs::msg::String>::SharedPtr sub_;
   int count_;
 };
""",
    "a lambda of a name that does something": """
 #include <rclcpp/rclcpp.hpp>
 #include <std_msgs/msg/string.hpp>

 class Hearer : public rclcpp::Node
 {
 public:
   Hearer() : Node("hearer")
   {
     auto heard = [this](const std_msgs::msg::String & msg) {count_ += msg.data.size();};
-    sub_ = create_subscription<std_msgs::msg::String>("in", 10, heard);
     start();
   }

 private:
-  rclcpp::Subscription<std_msgs::msg::String>::SharedPtr sub_;
   int count_;
 };
""",
}


@pytest.mark.parametrize("patch", REMOVALS.values(), ids=REMOVALS)
def test_stubs_go_with_what_called_them(patch: str) -> None:
    check(patch, Remove(EndpointKind.SUBSCRIPTION, "in"))
