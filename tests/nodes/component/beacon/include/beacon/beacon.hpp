#pragma once
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/bool.hpp>
#include <std_msgs/msg/u_int8.hpp>

namespace acme
{
class Beacon final : public rclcpp::Node
{
public:
  explicit Beacon(rclcpp::NodeOptions const & opts);

private:
  void OnTimer();

  rclcpp::Publisher<std_msgs::msg::Bool>::SharedPtr     m_pBlink;
  rclcpp::Subscription<std_msgs::msg::UInt8>::SharedPtr m_pMode;
  rclcpp::TimerBase::SharedPtr                          m_pTimer;
  uint8_t                                               m_mode{0};
};
}
