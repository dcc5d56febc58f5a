#include "health/cpu_health.hpp"
#include "rclcpp_components/register_node_macro.hpp"

namespace health
{
CpuHealth::CpuHealth(const rclcpp::NodeOptions & options) : HealthBase("cpu_health", options)
{
  load_ = create_publisher<std_msgs::msg::Float32>("cpu/load", 1);
  limit_ = declare_parameter("limit", 0.9);
}

void CpuHealth::sample() {load_->publish(std_msgs::msg::Float32());}
}

RCLCPP_COMPONENTS_REGISTER_NODE(health::CpuHealth)
