#ifndef MANAGED_LIDAR__MANAGED_LIDAR_HPP_
#define MANAGED_LIDAR__MANAGED_LIDAR_HPP_

#include "rclcpp/rclcpp.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"
#include "rclcpp_lifecycle/lifecycle_publisher.hpp"
#include "sensor_msgs/msg/laser_scan.hpp"
#include "std_srvs/srv/empty.hpp"

namespace lidar
{
using nav2_util_CallbackReturn = rclcpp_lifecycle::node_interfaces::LifecycleNodeInterface::CallbackReturn;

class ManagedLidar : public rclcpp_lifecycle::LifecycleNode
{
public:
  explicit ManagedLidar(const rclcpp::NodeOptions & options = rclcpp::NodeOptions());

protected:
  nav2_util_CallbackReturn on_configure(const rclcpp_lifecycle::State & state) override;
  nav2_util_CallbackReturn on_activate(const rclcpp_lifecycle::State & state) override;

private:
  void start(
    const std::shared_ptr<std_srvs::srv::Empty::Request> request,
    const std::shared_ptr<std_srvs::srv::Empty::Response> response);
  void spinOnce();

  rclcpp_lifecycle::LifecyclePublisher<sensor_msgs::msg::LaserScan>::SharedPtr scan_pub_;
  rclcpp::Service<std_srvs::srv::Empty>::SharedPtr start_srv_;
  rclcpp::TimerBase::SharedPtr timer_;
};
}  // namespace lidar

#endif
