#pragma once
#include <rclcpp/rclcpp.hpp>

namespace monitor_base
{
class Monitor : public rclcpp::Node
{
public:
  explicit Monitor(const std::string & name) : Node(name)
  {
    timer_ = create_wall_timer(std::chrono::seconds(10), [this]() {check();});
  }
  virtual void check() = 0;

private:
  rclcpp::TimerBase::SharedPtr timer_;
};
}  // namespace monitor_base
