#pragma once
#include <std_msgs/msg/u_int64.hpp>
#include <std_srvs/srv/trigger.hpp>

#include "monitor_base/monitor.hpp"

namespace monitor_base
{
class DiskMonitor : public Monitor
{
public:
  DiskMonitor();
  void check() override;

private:
  void clean(
    const std_srvs::srv::Trigger::Request::SharedPtr request,
    const std_srvs::srv::Trigger::Response::SharedPtr response);

  rclcpp::Publisher<std_msgs::msg::UInt64>::SharedPtr free_;
  rclcpp::Service<std_srvs::srv::Trigger>::SharedPtr clean_;
};
}  // namespace monitor_base
