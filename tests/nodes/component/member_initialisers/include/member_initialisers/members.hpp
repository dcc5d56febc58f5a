#pragma once
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/string.hpp>
#include <std_srvs/srv/trigger.hpp>

class Members : public rclcpp::Node
{
public:
  explicit Members(const rclcpp::NodeOptions & options);

private:
  void onText(std_msgs::msg::String::UniquePtr text);

  const std::string topic_ = declare_parameter<std::string>("topic", "text");
  const rclcpp::Publisher<std_msgs::msg::String>::SharedPtr pub_ = create_publisher<std_msgs::msg::String>("copy", 10);
  const rclcpp::Subscription<std_msgs::msg::String>::SharedPtr sub_{create_subscription<std_msgs::msg::String>(
    topic_, 10, std::bind(&Members::onText, this, std::placeholders::_1))};
  rclcpp::Client<std_srvs::srv::Trigger>::SharedPtr client_ {
    this->create_client<std_srvs::srv::Trigger>("go")};
};
