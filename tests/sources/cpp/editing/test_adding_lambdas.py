"""Endpoints added to nodes whose callbacks are lambdas, as patches."""

from __future__ import annotations

import pytest
from additions import provide, publish, subscribe
from patches import check

CASES = [
    pytest.param(
        subscribe("imu"),
        """
 #include "rclcpp/rclcpp.hpp"
+#include "sensor_msgs/msg/imu.hpp"
 #include "std_msgs/msg/string.hpp"

 class Ear : public rclcpp::Node
 {
 public:
   Ear()
   : Node("ear")
   {
     words_ = create_subscription<std_msgs::msg::String>(
       "words", 10,
       [this](const std_msgs::msg::String & words) {
         last_ = words.data;
       });
+    imu_ = create_subscription<sensor_msgs::msg::Imu>(
+      "imu", 10, [this](const sensor_msgs::msg::Imu & msg) {
+        RCLCPP_INFO(get_logger(), "imu: %s", to_yaml(msg).c_str());
+      });
   }

 private:
   std::string last_;
   rclcpp::Subscription<std_msgs::msg::String>::SharedPtr words_;
+  rclcpp::Subscription<sensor_msgs::msg::Imu>::SharedPtr imu_;
 };
""",
        id="a lambda of rclcpp beside others",
    ),
    pytest.param(
        subscribe("imu"),
        """
 #include "rclcpp/rclcpp.hpp"
+#include "sensor_msgs/msg/imu.hpp"
 #include "std_msgs/msg/string.hpp"

 class Ear : public rclcpp::Node
 {
 public:
   Ear()
   : Node("ear")
   {
     auto words_callback =
       [this](std_msgs::msg::String::UniquePtr msg) -> void {
         RCLCPP_INFO(this->get_logger(), "%s", msg->data.c_str());
       };
     words_ = this->create_subscription<std_msgs::msg::String>("words", 10, words_callback);
+    auto imu_callback = [this](sensor_msgs::msg::Imu::UniquePtr msg) -> void {
+      RCLCPP_INFO(this->get_logger(), "imu: %s", to_yaml(*msg).c_str());
+    };
+    imu_ = this->create_subscription<sensor_msgs::msg::Imu>("imu", 10, imu_callback);
   }

 private:
   rclcpp::Subscription<std_msgs::msg::String>::SharedPtr words_;
+  rclcpp::Subscription<sensor_msgs::msg::Imu>::SharedPtr imu_;
 };
""",
        id="a lambda that a variable holds",
    ),
    pytest.param(
        subscribe("imu"),
        """
 #include <rclcpp/rclcpp.hpp>
+#include <sensor_msgs/msg/imu.hpp>
 #include <std_msgs/msg/string.hpp>

 class Ear : public rclcpp::Node {
  public:
   Ear() : Node("ear") {
     words_ = create_subscription<std_msgs::msg::String>(
         "words", 10, [this](std_msgs::msg::String::UniquePtr msg) { OnWords(std::move(msg)); });
+    imu_ = create_subscription<sensor_msgs::msg::Imu>(
+        "imu", 10, [this](sensor_msgs::msg::Imu::UniquePtr msg) { OnImu(std::move(msg)); });
   }

  private:
   void OnWords(std_msgs::msg::String::UniquePtr msg) { last_ = msg->data; }

+  void OnImu(sensor_msgs::msg::Imu::UniquePtr msg) {
+    RCLCPP_INFO(get_logger(), "imu: %s", to_yaml(*msg).c_str());
+  }
+
   std::string last_;
   rclcpp::Subscription<std_msgs::msg::String>::SharedPtr words_;
+  rclcpp::Subscription<sensor_msgs::msg::Imu>::SharedPtr imu_;
 };
""",
        id="a lambda that hands a message on",
    ),
    pytest.param(
        subscribe("imu", callback="on_imu"),
        """
+#include <functional>
+
 #include <rclcpp/rclcpp.hpp>
+#include <sensor_msgs/msg/imu.hpp>
 #include <std_msgs/msg/string.hpp>

 struct Ear : rclcpp::Node {
   Ear() : Node("ear") {
     words = create_subscription<std_msgs::msg::String>(
       "words", 10, [this](const std_msgs::msg::String &msg) { last = msg.data; });
+    imu = create_subscription<sensor_msgs::msg::Imu>(
+      "imu", 10, std::bind(&Ear::on_imu, this, std::placeholders::_1));
+  }
+
+  void on_imu(const sensor_msgs::msg::Imu &msg) {
+    RCLCPP_INFO(get_logger(), "imu: %s", to_yaml(msg).c_str());
   }

   std::string last;
   rclcpp::Subscription<std_msgs::msg::String>::SharedPtr words;
+  rclcpp::Subscription<sensor_msgs::msg::Imu>::SharedPtr imu;
 };
""",
        id="a named function among lambdas",
    ),
    pytest.param(
        provide("go", "std_srvs/Trigger", success=True),
        """
 #include <ros/ros.h>
 #include <std_srvs/SetBool.h>
+#include <std_srvs/Trigger.h>

 int main(int argc, char** argv)
 {
   ros::init(argc, argv, "gate");
   ros::NodeHandle nh;
   bool is_open = false;
   auto open = nh.advertiseService<std_srvs::SetBool::Request, std_srvs::SetBool::Response>(
       "open", [&](auto& req, auto& res) {
         res.success = is_open = req.data;
         return true;
       });
+  auto go = nh.advertiseService<std_srvs::Trigger::Request, std_srvs::Trigger::Response>(
+      "go", [&](auto& req, auto& res) {
+        ROS_INFO_STREAM("go: " << req);
+        res.success = true;
+        return true;
+      });
   ros::spin();
 }
""",
        id="a service of roscpp in a lambda",
    ),
    pytest.param(
        publish("state", rate=4.0, data="on"),
        """
+#include <chrono>
+
 #include "rclcpp/rclcpp.hpp"
 #include "std_msgs/msg/string.hpp"

 using namespace std::chrono_literals;

 class Clock : public rclcpp::Node
 {
 public:
   Clock()
   : Node("clock")
   {
     tick_timer_ = create_wall_timer(1s, [this]() {count_++;});
+    state_pub_ = create_publisher<std_msgs::msg::String>("state", 10);
+    state_timer_ = create_wall_timer(250ms, [this]() {
+      std_msgs::msg::String message;
+      message.data = "on";
+      state_pub_->publish(message);
+    });
   }

 private:
   int count_ = 0;
   rclcpp::TimerBase::SharedPtr tick_timer_;
+  rclcpp::Publisher<std_msgs::msg::String>::SharedPtr state_pub_;
+  rclcpp::TimerBase::SharedPtr state_timer_;
 };
""",
        id="a message at a rate, from a lambda",
    ),
    pytest.param(
        publish("echo", heard="a", data="x"),
        """
 #include <ros/ros.h>
 #include <std_msgs/String.h>

 class Ear {
  public:
   Ear() {
     words_ = nh_.subscribe<std_msgs::String>("a", 1, [this](const std_msgs::StringConstPtr& msg) {
       last_ = msg->data;
+      std_msgs::String echo_message;
+      echo_message.data = "x";
+      echo_pub_.publish(echo_message);
     });
+    echo_pub_ = nh_.advertise<std_msgs::String>("echo", 10);
   }

  private:
   ros::NodeHandle nh_;
   ros::Subscriber words_;
+  ros::Publisher echo_pub_;
   std::string last_;
 };

 int main(int argc, char** argv) {
   ros::init(argc, argv, "ear");
   Ear ear;
   ros::spin();
 }
""",
        id="a message for each that a lambda hears",
    ),
]


@pytest.mark.parametrize(("change", "patch"), CASES)
def test_a_patch(change, patch):
    check(patch, change)
