#pragma once
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/u_int8.hpp>

class Held {
 public:
  Held();
  void Spin();

 private:
  void Level(const std_msgs::msg::UInt8& m);

  const std::string prefix_ = "held";
  rclcpp::Node::SharedPtr node_;
  rclcpp::Subscription<std_msgs::msg::UInt8>::SharedPtr sub_;
  rclcpp::Publisher<std_msgs::msg::UInt8>::SharedPtr pub_;
};
