#include "managed_lidar/managed_lidar.hpp"

#include "rclcpp_components/register_node_macro.hpp"

namespace lidar
{

ManagedLidar::ManagedLidar(const rclcpp::NodeOptions & options)
: rclcpp_lifecycle::LifecycleNode("lidar", options) {}

nav2_util_CallbackReturn ManagedLidar::on_configure(const rclcpp_lifecycle::State & /*state*/)
{
  scan_pub_ = create_publisher<sensor_msgs::msg::LaserScan>("scan", rclcpp::SensorDataQoS());
  start_srv_ = create_service<std_srvs::srv::Empty>(
    "start_motor", std::bind(&ManagedLidar::start, this, std::placeholders::_1, std::placeholders::_2));
  return nav2_util_CallbackReturn::SUCCESS;
}

nav2_util_CallbackReturn ManagedLidar::on_activate(const rclcpp_lifecycle::State & state)
{
  LifecycleNode::on_activate(state);
  timer_ = this->create_wall_timer(std::chrono::milliseconds(100), std::bind(&ManagedLidar::spinOnce, this));
  return nav2_util_CallbackReturn::SUCCESS;
}

void ManagedLidar::start(
  const std::shared_ptr<std_srvs::srv::Empty::Request>,
  const std::shared_ptr<std_srvs::srv::Empty::Response>) {}

void ManagedLidar::spinOnce() {scan_pub_->publish(sensor_msgs::msg::LaserScan());}

}  // namespace lidar

RCLCPP_COMPONENTS_REGISTER_NODE(lidar::ManagedLidar)
