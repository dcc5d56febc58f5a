#include "monitor_base/disk_monitor.hpp"

namespace monitor_base
{
DiskMonitor::DiskMonitor() : Monitor("disk")
{
  free_ = create_publisher<std_msgs::msg::UInt64>("free", 1);
  clean_ = create_service<std_srvs::srv::Trigger>(
    "clean", std::bind(&DiskMonitor::clean, this, std::placeholders::_1, std::placeholders::_2));
}

void DiskMonitor::clean(
  const std_srvs::srv::Trigger::Request::SharedPtr, const std_srvs::srv::Trigger::Response::SharedPtr response)
{
  response->success = true;
}

void DiskMonitor::check() {free_->publish(std_msgs::msg::UInt64());}
}  // namespace monitor_base

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<monitor_base::DiskMonitor>());
}
