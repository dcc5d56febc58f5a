"""Parameters added to nodes in C++, as patches."""

from __future__ import annotations

import pytest
from additions import parameter
from patches import check

CASES = [
    pytest.param(
        parameter("~/gain", "float", 2.5),
        """
 #include <nodelet/nodelet.h>
 #include <pluginlib/class_list_macros.hpp>
 #include <ros/ros.h>
 #include <std_msgs/Bool.h>

 namespace lamps {

 class LampNodelet : public nodelet::Nodelet {
  private:
   void onInit() override {
     ros::NodeHandle& nh = getNodeHandle();
     ros::NodeHandle& private_nh = getPrivateNodeHandle();
     private_nh.param("dim", dim_, 0.5);
+    private_nh.param<double>("gain", gain_, 2.5);
     switch_sub_ = nh.subscribe("switch", 1, &LampNodelet::SwitchCb, this);
   }

   void SwitchCb(const std_msgs::BoolConstPtr& msg) {
     NODELET_INFO("switch: %d", msg->data);
   }

   double dim_;
+  double gain_;
   ros::Subscriber switch_sub_;
 };

 }  // namespace lamps

 PLUGINLIB_EXPORT_CLASS(lamps::LampNodelet, nodelet::Nodelet)
""",
        id="a parameter of a nodelet",
    ),
    pytest.param(
        parameter("speed", "int", 5, minimum=1, maximum=9),
        """
 #include <memory>
 #include <string>

 #include "geometry_msgs/msg/twist.hpp"
+#include "rcl_interfaces/msg/parameter_descriptor.hpp"
 #include "rclcpp/rclcpp.hpp"

 namespace wheels
 {
 using geometry_msgs::msg::Twist;

 class Wheels final : public rclcpp::Node
 {
 public:
   explicit Wheels(const rclcpp::NodeOptions & options = rclcpp::NodeOptions())
   : rclcpp::Node("wheels", options)
   {
     gain_ = this->declare_parameter<double>("gain", 1.0);
+    {
+      rcl_interfaces::msg::ParameterDescriptor descriptor;
+      descriptor.integer_range.resize(1);
+      descriptor.integer_range[0].from_value = 1;
+      descriptor.integer_range[0].to_value = 9;
+      this->declare_parameter<int64_t>("speed", 5, descriptor);
+    }
     sub_twist_ = this->create_subscription<Twist>(
       "cmd_vel", rclcpp::SensorDataQoS(),
       std::bind(&Wheels::onTwist, this, std::placeholders::_1));
   }

 private:
   void onTwist(Twist::UniquePtr twist)
   {
     RCLCPP_DEBUG(this->get_logger(), "%f", gain_ * twist->linear.x);
   }

   double gain_;
   rclcpp::Subscription<Twist>::SharedPtr sub_twist_;
 };
 }  // namespace wheels

 int main(int argc, char ** argv)
 {
   rclcpp::init(argc, argv);
   rclcpp::spin(std::make_shared<wheels::Wheels>());
   rclcpp::shutdown();
 }
""",
        id="a parameter of rclcpp with a range",
    ),
]


@pytest.mark.parametrize(("change", "patch"), CASES)
def test_a_patch(change, patch):
    check(patch, change)
