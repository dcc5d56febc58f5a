"""Endpoints added to files of many layouts, as patches."""

from __future__ import annotations

import pytest
from additions import provide, publish, subscribe
from patches import check

CASES = [
    pytest.param(
        provide("stop_everything", "std_srvs/Trigger"),
        """
 #include <rclcpp/rclcpp.hpp>
 #include <std_srvs/srv/set_bool.hpp>
+#include <std_srvs/srv/trigger.hpp>

 class Gate : public rclcpp::Node {
 public:
     Gate() : Node("gate") {
         open_server_ = create_service<std_srvs::srv::SetBool>("open",
                                                               std::bind(&Gate::Open,
                                                                         this,
                                                                         std::placeholders::_1,
                                                                         std::placeholders::_2));
+        stop_everything_server_ = create_service<std_srvs::srv::Trigger>(
+            "stop_everything",
+            std::bind(&Gate::StopEverythingCallback, this, std::placeholders::_1,
+                      std::placeholders::_2));
     }

 private:
     void Open(const std::shared_ptr<std_srvs::srv::SetBool::Request> request,
               std::shared_ptr<std_srvs::srv::SetBool::Response> response) {
         response->success = request->data;
     }

+    void StopEverythingCallback(const std::shared_ptr<std_srvs::srv::Trigger::Request> request,
+                                std::shared_ptr<std_srvs::srv::Trigger::Response> response) {
+        RCLCPP_INFO(get_logger(), "stop_everything: %s", to_yaml(*request).c_str());
+        (void)response;
+    }
+
     rclcpp::Service<std_srvs::srv::SetBool>::SharedPtr open_server_;
+    rclcpp::Service<std_srvs::srv::Trigger>::SharedPtr stop_everything_server_;
 };
""",
        id="arguments below the first",
    ),
    pytest.param(
        subscribe("imu"),
        """
 #include <ros/ros.h>
+#include <sensor_msgs/Imu.h>
 #include <std_msgs/Bool.h>
 struct Gate
 {
     Gate()
     {
         open = nh.subscribe("open", 1, &Gate::onOpen, this);
+        imu = nh.subscribe("imu", 1, &Gate::onImu, this);
     }
     void onOpen(const std_msgs::Bool& msg)
     {
         is_open = msg.data;
+    }
+    void onImu(const sensor_msgs::Imu& msg)
+    {
+        ROS_INFO_STREAM("imu: " << msg);
     }
     void close()
     {
         is_open = false;
     }
     ros::NodeHandle nh;
     ros::Subscriber open;
+    ros::Subscriber imu;
     bool is_open;
 };
 int main(int argc, char** argv)
 {
     ros::init(argc, argv, "gate");
     Gate gate;
     ros::spin();
 }
""",
        id="functions without an empty line between",
    ),
    pytest.param(
        subscribe("imu"),
        """
 #include <ros/ros.h>
+#include <sensor_msgs/Imu.h>
 #include <sensor_msgs/JointState.h>

 ros::Subscriber g_joint_sub;
+ros::Subscriber g_imu_sub;
 bool g_moves = false;

 void jointCb(const sensor_msgs::JointState &js) { g_moves = !js.velocity.empty(); }
+
+void imuCb(const sensor_msgs::Imu &msg)
+{
+  ROS_INFO_STREAM("imu: " << msg);
+}

 int main(int argc, char **argv)
 {
   ros::init(argc, argv, "joints");
   ros::NodeHandle nh;
   g_joint_sub = nh.subscribe("joints", 1, jointCb);
+  g_imu_sub = nh.subscribe("imu", 1, imuCb);
   ros::spin();
 }
""",
        id="variables of the file that begin with `g_`",
    ),
    pytest.param(
        publish("mode", rate=2.0, data="on"),
        """
 #include "x.hpp"

+#include <chrono>
+#include <functional>
 #include <string>

 #include <rclcpp_components/register_node_macro.hpp>

 Gate::Gate(const rclcpp::NodeOptions & options)
 : Node("gate", options)
 {
   pub_ = create_publisher<std_msgs::msg::String>("state", 1);
+  mode_pub_ = create_publisher<std_msgs::msg::String>("mode", 1);
+  mode_timer_ = create_wall_timer(
+    std::chrono::milliseconds(500), std::bind(&Gate::publish_mode, this));
 }
+
+void Gate::publish_mode()
+{
+  std_msgs::msg::String message;
+  message.data = "on";
+  mode_pub_->publish(message);
+}
+
 RCLCPP_COMPONENTS_REGISTER_NODE(Gate)
=== x.hpp
 #pragma once
 #include <std_msgs/msg/string.hpp>
 #include <rclcpp/rclcpp.hpp>
 class Gate : public rclcpp::Node
 {
 public:
   explicit Gate(const rclcpp::NodeOptions & options);

 private:
+  void publish_mode();
   rclcpp::Publisher<std_msgs::msg::String>::SharedPtr pub_;
+  rclcpp::Publisher<std_msgs::msg::String>::SharedPtr mode_pub_;
+  rclcpp::TimerBase::SharedPtr mode_timer_;
 };
""",
        id="headers of the standard and of packages in order",
    ),
    pytest.param(
        publish("mode", "geometry_msgs/Point", rate=2.0, x=1.5),
        """
+#include <chrono>
+#include <functional>
+#include <geometry_msgs/msg/point.hpp>
 #include <memory>
 #include <rclcpp/rclcpp.hpp>
 #include <std_msgs/msg/string.hpp>
 #include <utility>

 struct Gate : rclcpp::Node
 {
   Gate()
   : Node("gate")
   {
     pub_ = create_publisher<std_msgs::msg::String>("state", 1);
+    mode_pub_ = create_publisher<geometry_msgs::msg::Point>("mode", 1);
+    mode_timer_ = create_wall_timer(
+      std::chrono::milliseconds(500), std::bind(&Gate::publish_mode, this));
   }
+
+  void publish_mode()
+  {
+    geometry_msgs::msg::Point message;
+    message.x = 1.5;
+    mode_pub_->publish(message);
+  }
+
   rclcpp::Publisher<std_msgs::msg::String>::SharedPtr pub_;
+  rclcpp::Publisher<geometry_msgs::msg::Point>::SharedPtr mode_pub_;
+  rclcpp::TimerBase::SharedPtr mode_timer_;
 };
""",
        id="headers of all kinds in one order",
    ),
    pytest.param(
        publish("at", "sensor_msgs/Temperature", rate=7.0, temperature=1.5),
        """
+#include <chrono>
+#include <functional>
+
 #include <rclcpp/rclcpp.hpp>
+#include <sensor_msgs/msg/temperature.hpp>
 #include <std_msgs/msg/bool.hpp>

 class Gate
 {
 public:
   explicit Gate(rclcpp::Node::SharedPtr node)
   {
     pub_ = node->create_publisher<std_msgs::msg::Bool>("open", 1);
+    at_pub_ = node->create_publisher<sensor_msgs::msg::Temperature>("at", 1);
+    at_timer_ = node->create_wall_timer(
+      std::chrono::duration<double>(1.0 / 7.0), std::bind(&Gate::publish_at, this));
   }

 private:
+  void publish_at()
+  {
+    sensor_msgs::msg::Temperature message;
+    message.temperature = 1.5;
+    message.header.stamp = rclcpp::Clock(RCL_ROS_TIME).now();
+    at_pub_->publish(message);
+  }
+
   rclcpp::Publisher<std_msgs::msg::Bool>::SharedPtr pub_;
+  rclcpp::Publisher<sensor_msgs::msg::Temperature>::SharedPtr at_pub_;
+  rclcpp::TimerBase::SharedPtr at_timer_;
 };

 int main(int argc, char ** argv)
 {
   rclcpp::init(argc, argv);
   auto node = std::make_shared<rclcpp::Node>("gate");
   Gate gate(node);
   rclcpp::spin(node);
 }
""",
        id="a node that only the constructor sees",
    ),
    pytest.param(
        subscribe("imu"),
        """
 #include <message_filters/subscriber.h>
 #include <ros/ros.h>
+#include <sensor_msgs/Imu.h>
 #include <std_msgs/Header.h>

 class Gate
 {
 public:
   Gate()
   {
     filtered_.subscribe(nh_, "open", 1);
+    imu_ = nh_.subscribe("imu", 1, &Gate::imuCallback, this);
   }

 private:
+  void imuCallback(const sensor_msgs::Imu::ConstPtr& msg)
+  {
+    ROS_INFO_STREAM("imu: " << *msg);
+  }
+
   ros::NodeHandle nh_;
   message_filters::Subscriber<std_msgs::Header> filtered_;
+  ros::Subscriber imu_;
 };

 int main(int argc, char** argv)
 {
   ros::init(argc, argv, "gate");
   Gate gate;
   ros::spin();
 }
""",
        id="what a filter holds is no model for a member",
    ),
]


@pytest.mark.parametrize(("change", "patch"), CASES)
def test_a_patch(change, patch):
    check(patch, change)
