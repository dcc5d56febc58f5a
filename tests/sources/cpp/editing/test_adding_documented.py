"""Functions added to files that document theirs, as patches."""

from __future__ import annotations

import pytest
from additions import provide, subscribe
from patches import check

CASES = [
    pytest.param(
        subscribe("imu"),
        """
 #include "x.hpp"

 Ear::Ear() : Node("ear")
 {
   words_ = create_subscription<std_msgs::msg::String>(
     "words", 10, std::bind(&Ear::on_words, this, std::placeholders::_1));
+  imu_ = create_subscription<sensor_msgs::msg::Imu>(
+    "imu", 10, std::bind(&Ear::on_imu, this, std::placeholders::_1));
 }

 void Ear::on_words(const std_msgs::msg::String & msg)
 {
   last_ = msg.data;
 }
+
+void Ear::on_imu(const sensor_msgs::msg::Imu & msg)
+{
+  RCLCPP_INFO(get_logger(), "imu: %s", to_yaml(msg).c_str());
+}
=== x.hpp
 #pragma once

 #include <rclcpp/rclcpp.hpp>
+#include <sensor_msgs/msg/imu.hpp>
 #include <std_msgs/msg/string.hpp>

 /// Hears words.
 class Ear : public rclcpp::Node
 {
 public:
   /// Begins to hear.
   Ear();

 private:
   /// Keeps what was said.
   void on_words(const std_msgs::msg::String & msg);
+  /// Called for each message of imu.
+  void on_imu(const sensor_msgs::msg::Imu & msg);

   std::string last_;
   rclcpp::Subscription<std_msgs::msg::String>::SharedPtr words_;
+  rclcpp::Subscription<sensor_msgs::msg::Imu>::SharedPtr imu_;
 };
""",
        id="a comment in three slashes",
    ),
    pytest.param(
        provide("go", "std_srvs/Trigger"),
        """
 #include <ros/ros.h>
 #include <std_srvs/SetBool.h>
+#include <std_srvs/Trigger.h>

 class Gate
 {
 public:
   Gate()
   {
     open_srv_ = nh_.advertiseService("open", &Gate::openCb, this);
+    go_srv_ = nh_.advertiseService("go", &Gate::goCb, this);
   }

 private:
   /**
    * @brief Opens or closes the gate
    * @param req whether it is to be open
    * @param res whether it is
    * @return always true
    */
   bool openCb(std_srvs::SetBool::Request &req, std_srvs::SetBool::Response &res)
   {
     res.success = is_open_ = req.data;
     return true;
   }

+  /**
+   * @brief Called for each request of go
+   * @param req the request
+   * @param res the response
+   * @return whether the request was answered
+   */
+  bool goCb(std_srvs::Trigger::Request &req, std_srvs::Trigger::Response &res)
+  {
+    ROS_INFO_STREAM("go: " << req);
+    (void)res;
+    return true;
+  }
+
   ros::NodeHandle nh_;
   ros::ServiceServer open_srv_;
+  ros::ServiceServer go_srv_;
   bool is_open_ = false;
 };

 int main(int argc, char **argv)
 {
   ros::init(argc, argv, "gate");
   Gate gate;
   ros::spin();
 }
""",
        id="a comment with commands",
    ),
    pytest.param(
        subscribe("imu"),
        r"""
 #include <ros/ros.h>
+#include <sensor_msgs/Imu.h>
 #include <std_msgs/Bool.h>

 /*! \brief Opens or closes. */
 void heardOpen(const std_msgs::Bool &open)
 {
   ROS_INFO("%d", open.data);
 }

+/*! \brief Called for each message of imu. */
+void imuCallback(const sensor_msgs::Imu &msg)
+{
+  ROS_INFO_STREAM("imu: " << msg);
+}
+
 int main(int argc, char **argv)
 {
   ros::init(argc, argv, "gate");
   ros::NodeHandle nh;
   ros::Subscriber open_sub = nh.subscribe("open", 1, heardOpen);
+  ros::Subscriber imu_sub = nh.subscribe("imu", 1, imuCallback);
   ros::spin();
 }
""",
        id="a comment above a definition",
    ),
]


@pytest.mark.parametrize(("change", "patch"), CASES)
def test_a_patch(change, patch):
    check(patch, change)
