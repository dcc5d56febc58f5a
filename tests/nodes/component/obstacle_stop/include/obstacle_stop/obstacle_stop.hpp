#ifndef OBSTACLE_STOP__OBSTACLE_STOP_HPP_
#define OBSTACLE_STOP__OBSTACLE_STOP_HPP_

#include "geometry_msgs/msg/twist.hpp"
#include "obstacle_stop/visibility_control.h"
#include "rclcpp/rclcpp.hpp"
#include "sensor_msgs/msg/laser_scan.hpp"
#include "std_srvs/srv/set_bool.hpp"

namespace obstacle_stop
{

class ObstacleStop : public rclcpp::Node
{
public:
  OBSTACLE_STOP_PUBLIC
  explicit ObstacleStop(const rclcpp::NodeOptions & options);

private:
  OBSTACLE_STOP_LOCAL
  void on_scan(const sensor_msgs::msg::LaserScan::ConstSharedPtr scan);
  OBSTACLE_STOP_LOCAL
  void on_twist(const geometry_msgs::msg::Twist::ConstSharedPtr twist);
  OBSTACLE_STOP_LOCAL
  void on_override(
    const std_srvs::srv::SetBool::Request::SharedPtr request,
    std_srvs::srv::SetBool::Response::SharedPtr response);

  rclcpp::Subscription<sensor_msgs::msg::LaserScan>::SharedPtr scan_sub_;
  rclcpp::Subscription<geometry_msgs::msg::Twist>::SharedPtr twist_sub_;
  rclcpp::Publisher<geometry_msgs::msg::Twist>::SharedPtr twist_pub_;
  rclcpp::Service<std_srvs::srv::SetBool>::SharedPtr override_srv_;
  double distance_;
  bool blocked_ = false;
  bool override_ = false;
};

}  // namespace obstacle_stop

#endif  // OBSTACLE_STOP__OBSTACLE_STOP_HPP_
