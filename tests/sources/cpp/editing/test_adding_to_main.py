"""Endpoints added to a `main` without a class, as patches."""

from __future__ import annotations

import pytest
from additions import publish
from patches import check

CASES = [
    pytest.param(
        publish("state", data="on"),
        """
 #include <ros/ros.h>
 #include <std_msgs/String.h>

 int main(int argc, char **argv)
 {
     ros::init(argc, argv, "talker");
     ros::NodeHandle nh;
     ros::Publisher pub = nh.advertise<std_msgs::String>("chatter", 1000);
+    ros::Publisher state_pub = nh.advertise<std_msgs::String>("state", 1000);
     ros::Rate loop_rate(10);
     while (ros::ok()) {
         std_msgs::String msg;
         msg.data = "hello";
         pub.publish(msg);
+        std_msgs::String state_message;
+        state_message.data = "on";
+        state_pub.publish(state_message);
         ros::spinOnce();
         loop_rate.sleep();
     }
     return 0;
 }
""",
        id="a message in the loop of main",
    ),
    pytest.param(
        publish("echo", heard="chatter", data="x"),
        """
 #include "ros/ros.h"
 #include "std_msgs/String.h"
+
+ros::Publisher echo_pub;

 void chatterCallback(const std_msgs::String::ConstPtr& msg)
 {
   ROS_INFO("I heard: [%s]", msg->data.c_str());
+  std_msgs::String echo_message;
+  echo_message.data = "x";
+  echo_pub.publish(echo_message);
 }

 int main(int argc, char **argv)
 {
   ros::init(argc, argv, "listener");
   ros::NodeHandle n;
   ros::Subscriber sub = n.subscribe("chatter", 1000, chatterCallback);
+  echo_pub = n.advertise<std_msgs::String>("echo", 10);
   ros::spin();
   return 0;
 }
""",
        id="a message for each that main hears",
    ),
    pytest.param(
        publish("state", rate=2.0, data="on"),
        """
+#include <chrono>
+
 #include "rclcpp/rclcpp.hpp"
 #include "std_msgs/msg/string.hpp"

 rclcpp::Node::SharedPtr g_node = nullptr;

 void topic_callback(const std_msgs::msg::String::SharedPtr msg)
 {
   RCLCPP_INFO(g_node->get_logger(), "I heard: '%s'", msg->data.c_str());
 }

 int main(int argc, char * argv[])
 {
   rclcpp::init(argc, argv);
   g_node = rclcpp::Node::make_shared("listener");
   auto subscription =
     g_node->create_subscription<std_msgs::msg::String>("topic", 10, topic_callback);
+  auto state_pub = g_node->create_publisher<std_msgs::msg::String>("state", 10);
+  rclcpp::TimerBase::SharedPtr state_timer = g_node->create_wall_timer(
+    std::chrono::milliseconds(500), [state_pub]() {
+      std_msgs::msg::String message;
+      message.data = "on";
+      state_pub->publish(message);
+    });
   rclcpp::spin(g_node);
   rclcpp::shutdown();
   return 0;
 }
""",
        id="a message at a rate, in main",
    ),
]


@pytest.mark.parametrize(("change", "patch"), CASES)
def test_a_patch(change, patch):
    check(patch, change)
