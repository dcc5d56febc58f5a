#pragma once
#include <memory>
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/bool.hpp>
#include <std_msgs/msg/int32.hpp>
#include <std_msgs/msg/string.hpp>

namespace shop
{
static constexpr char kQueue[] = "queue";

class Shop : public rclcpp::Node
{
public:
  static std::shared_ptr<Shop> make(const std::string & topic);

private:
  Shop();
  void order(std_msgs::msg::String::ConstSharedPtr order);

  rclcpp::Subscription<std_msgs::msg::String>::SharedPtr orders_;
  rclcpp::Publisher<std_msgs::msg::Int32>::SharedPtr queue_;
  rclcpp::Publisher<std_msgs::msg::Bool>::SharedPtr open_;
};
}  // namespace shop
