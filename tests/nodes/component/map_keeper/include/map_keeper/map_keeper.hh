#pragma once
#include <geometry_msgs/msg/pose_array.hpp>
#include <geometry_msgs/msg/pose_stamped.hpp>
#include <rclcpp/rclcpp.hpp>
#include <std_srvs/srv/empty.hpp>

class MapKeeper : public rclcpp::Node {
 public:
  explicit MapKeeper(const rclcpp::NodeOptions& opts);

 private:
  using PoseArray = geometry_msgs::msg::PoseArray;
  using Pose = geometry_msgs::msg::PoseStamped;
  using Empty = std_srvs::srv::Empty;

  static rclcpp::QoS Latched() { return rclcpp::QoS(1).reliable().transient_local(); }
  void Add(const Pose& pose);
  void Clear(Empty::Request::ConstSharedPtr req, Empty::Response::SharedPtr res);

  PoseArray array_;
  rclcpp::Publisher<PoseArray>::SharedPtr poses_;
  rclcpp::Subscription<Pose>::SharedPtr add_;
  rclcpp::Service<Empty>::SharedPtr clear_;
};
