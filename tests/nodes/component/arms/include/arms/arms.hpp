#pragma once
#include <geometry_msgs/msg/pose_stamped.hpp>
#include <rclcpp/rclcpp.hpp>

using Pose = geometry_msgs::msg::PoseStamped;

class Left : public rclcpp::Node
{
public:
  explicit Left(const rclcpp::NodeOptions & options);

private:
  void goal(Pose::SharedPtr pose);
  rclcpp::Subscription<Pose>::SharedPtr goal_;
};

class Right : public rclcpp::Node
{
public:
  explicit Right(const rclcpp::NodeOptions & options);

private:
  void goal(Pose::SharedPtr pose);
  rclcpp::Subscription<Pose>::SharedPtr goal_;
  rclcpp::Publisher<Pose>::SharedPtr at_;
};
