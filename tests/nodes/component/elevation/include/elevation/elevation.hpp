#pragma once
#include <rclcpp/rclcpp.hpp>
#include <sensor_msgs/msg/point_cloud2.hpp>
#include <std_srvs/srv/trigger.hpp>

#define NODE "elevation"

class Elevation : public rclcpp::Node {
 public:
  using Cloud = sensor_msgs::msg::PointCloud2;
  explicit Elevation(const rclcpp::NodeOptions& options);

 private:
  static constexpr auto kCloud = "points";
  static constexpr auto kMap = "elevation";

  void Update(Cloud::ConstSharedPtr cloud);
  void Save(std_srvs::srv::Trigger::Request::SharedPtr req, std_srvs::srv::Trigger::Response::SharedPtr res);

  rclcpp::Subscription<Cloud>::SharedPtr cloud_;
  rclcpp::Publisher<Cloud>::SharedPtr map_;
  rclcpp::Service<std_srvs::srv::Trigger>::SharedPtr save_;
};
