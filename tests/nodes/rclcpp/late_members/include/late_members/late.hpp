#pragma once
#include <example_interfaces/action/fibonacci.hpp>
#include <memory>
#include <message_filters/subscriber.h>
#include <rclcpp/rclcpp.hpp>
#include <rclcpp_action/rclcpp_action.hpp>
#include <sensor_msgs/msg/image.hpp>
#include <std_msgs/msg/empty.hpp>
#include <std_srvs/srv/trigger.hpp>
#include <tf2_ros/transform_broadcaster.h>

class Late : public rclcpp::Node
{
public:
  Late();

private:
  void go(std_msgs::msg::Empty::ConstSharedPtr);

  rclcpp::Subscription<std_msgs::msg::Empty>::SharedPtr sub_;
  rclcpp::Publisher<std_msgs::msg::Empty>::SharedPtr pub_;
  rclcpp::TimerBase::SharedPtr timer_;
  rclcpp::Client<std_srvs::srv::Trigger>::SharedPtr client_;
  rclcpp_action::Client<example_interfaces::action::Fibonacci>::SharedPtr action_;
  std::unique_ptr<tf2_ros::TransformBroadcaster> broadcaster_;
  std::shared_ptr<message_filters::Subscriber<sensor_msgs::msg::Image>> filter_;
};
