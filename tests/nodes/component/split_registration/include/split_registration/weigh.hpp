#pragma once
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/float32.hpp>
#include <std_srvs/srv/trigger.hpp>

namespace scale
{
class Weigh : public rclcpp::Node
{
public:
  explicit Weigh(const rclcpp::NodeOptions & options);

private:
  void tare(std_srvs::srv::Trigger::Request::SharedPtr, std_srvs::srv::Trigger::Response::SharedPtr);
  rclcpp::Publisher<std_msgs::msg::Float32>::SharedPtr weight_;
  rclcpp::Service<std_srvs::srv::Trigger>::SharedPtr tare_;
};
}
