#pragma once
#include "health/health_base.hpp"
#include "std_msgs/msg/float32.hpp"

namespace health
{
class CpuHealth : public HealthBase
{
public:
  explicit CpuHealth(const rclcpp::NodeOptions & options);

private:
  void sample() override;
  rclcpp::Publisher<std_msgs::msg::Float32>::SharedPtr load_;
  double limit_;
};
}
