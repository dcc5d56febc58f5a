#ifndef WALL_FOLLOW_HPP
#define WALL_FOLLOW_HPP
#include <geometry_msgs/msg/twist.hpp>
#include <rclcpp/rclcpp.hpp>
#include <sensor_msgs/msg/laser_scan.hpp>

class WallFollow : public rclcpp::Node
{
public:
  WallFollow();

private:
  static constexpr double DEFAULT_DISTANCE{0.4};
  void initParameters();
  void initTopics();
  void scan(sensor_msgs::msg::LaserScan::ConstSharedPtr s);

  double distance_;
  const std::string cmd_{"cmd_vel"};
  rclcpp::Subscription<sensor_msgs::msg::LaserScan>::SharedPtr scan_;
  rclcpp::Publisher<geometry_msgs::msg::Twist>::SharedPtr twist_;
};
#endif
