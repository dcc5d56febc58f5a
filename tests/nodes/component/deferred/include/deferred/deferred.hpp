#pragma once
#include <rclcpp/rclcpp.hpp>
#include <sensor_msgs/msg/imu.hpp>
#include <std_srvs/srv/empty.hpp>

class Deferred : public rclcpp::Node
{
public:
  explicit Deferred(const rclcpp::NodeOptions & options);

private:
  void init();
  void onImu(sensor_msgs::msg::Imu::ConstSharedPtr imu);

  rclcpp::TimerBase::SharedPtr start_;
  rclcpp::Subscription<sensor_msgs::msg::Imu>::SharedPtr imu_;
  rclcpp::Client<std_srvs::srv::Empty>::SharedPtr zero_;
};
