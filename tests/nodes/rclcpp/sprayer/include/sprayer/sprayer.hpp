#pragma once
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/float32.hpp>

class Sprayer : public rclcpp::Node
{
public:
  Sprayer(const std::string & name, const rclcpp::NodeOptions & options);

private:
  using Level = std_msgs::msg::Float32;
  void nozzle(Level::ConstSharedPtr level);

  const rclcpp::QoS qos_{2};
  rclcpp::Publisher<Level>::SharedPtr tank_;
  std::vector<rclcpp::Subscription<Level>::SharedPtr> nozzles_;
};
