#include "wall_follow.hpp"

WallFollow::WallFollow() : Node("wall_follow")
{
  initParameters();
  initTopics();
}

void WallFollow::initParameters()
{
  distance_ = this->declare_parameter<double>("distance", DEFAULT_DISTANCE);
  this->declare_parameter<std::string>("cmd", cmd_);
}

void WallFollow::initTopics()
{
  scan_ = this->create_subscription<sensor_msgs::msg::LaserScan>(
    "scan",
    rclcpp::QoS(rclcpp::KeepLast(1)).best_effort(),
    [this](sensor_msgs::msg::LaserScan::ConstSharedPtr s) { scan(s); });
  twist_ = this->create_publisher<geometry_msgs::msg::Twist>(cmd_, 1);
}

void WallFollow::scan(sensor_msgs::msg::LaserScan::ConstSharedPtr)
{
  twist_->publish(geometry_msgs::msg::Twist());
}

int main(int argc, char **argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<WallFollow>());
  rclcpp::shutdown();
}
