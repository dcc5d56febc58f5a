#include "weigh.hpp"

scale::Weigh::Weigh(const rclcpp::NodeOptions & options) : rclcpp::Node("weigh", options)
{
  weight_ = create_publisher<std_msgs::msg::Float32>("weight", rclcpp::SensorDataQoS());
  tare_ = create_service<std_srvs::srv::Trigger>(
    "tare", std::bind(&Weigh::tare, this, std::placeholders::_1, std::placeholders::_2));
}

void scale::Weigh::tare(std_srvs::srv::Trigger::Request::SharedPtr, std_srvs::srv::Trigger::Response::SharedPtr)
{
  weight_->publish(std_msgs::msg::Float32());
}

#include "rclcpp_components/register_node_macro.hpp"

// Lets class_loader find it.
RCLCPP_COMPONENTS_REGISTER_NODE(scale::Weigh)
