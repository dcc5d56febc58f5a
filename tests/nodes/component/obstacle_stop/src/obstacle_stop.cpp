#include "obstacle_stop/obstacle_stop.hpp"

#include "rclcpp_components/register_node_macro.hpp"

namespace obstacle_stop
{

ObstacleStop::ObstacleStop(const rclcpp::NodeOptions & options)
: Node("obstacle_stop", options)
{
  distance_ = declare_parameter<double>("distance", 0.3);
  using std::placeholders::_1;
  scan_sub_ = create_subscription<sensor_msgs::msg::LaserScan>(
    "scan", rclcpp::SensorDataQoS(), std::bind(&ObstacleStop::on_scan, this, _1));
  twist_sub_ = create_subscription<geometry_msgs::msg::Twist>(
    "cmd_vel_in", 10, std::bind(&ObstacleStop::on_twist, this, _1));
  twist_pub_ = create_publisher<geometry_msgs::msg::Twist>("cmd_vel", 10);
  override_srv_ = create_service<std_srvs::srv::SetBool>(
    "~/override",
    std::bind(&ObstacleStop::on_override, this, _1, std::placeholders::_2));
}

void ObstacleStop::on_scan(const sensor_msgs::msg::LaserScan::ConstSharedPtr scan)
{
  blocked_ = !scan->ranges.empty() && scan->ranges.front() < distance_;
}

void ObstacleStop::on_twist(const geometry_msgs::msg::Twist::ConstSharedPtr twist)
{
  if (!blocked_ || override_) {
    twist_pub_->publish(*twist);
  }
}

void ObstacleStop::on_override(
  const std_srvs::srv::SetBool::Request::SharedPtr request,
  std_srvs::srv::SetBool::Response::SharedPtr response)
{
  override_ = request->data;
  response->success = true;
}

}  // namespace obstacle_stop

RCLCPP_COMPONENTS_REGISTER_NODE(obstacle_stop::ObstacleStop)
