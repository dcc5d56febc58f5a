#ifndef FOREIGN_LIFECYCLE__CONTROLLER_HPP_
#define FOREIGN_LIFECYCLE__CONTROLLER_HPP_

#include "geometry_msgs/msg/pose_stamped.hpp"
#include "geometry_msgs/msg/twist.hpp"
#include "robot_utils/lifecycle_node.hpp"
#include "std_msgs/msg/float64.hpp"

namespace nav
{

class Controller : public robot_utils::LifecycleNode
{
public:
  explicit Controller(const rclcpp::NodeOptions & options = rclcpp::NodeOptions());
  ~Controller();

protected:
  robot_utils::CallbackReturn on_configure(const rclcpp_lifecycle::State & state) override;
  robot_utils::CallbackReturn on_activate(const rclcpp_lifecycle::State & state) override;

  void odom(geometry_msgs::msg::PoseStamped::SharedPtr odom);
  void speedLimit(const std_msgs::msg::Float64::SharedPtr limit);

  rclcpp_lifecycle::LifecyclePublisher<geometry_msgs::msg::Twist>::SharedPtr vel_publisher_;
  rclcpp::Subscription<geometry_msgs::msg::PoseStamped>::SharedPtr odom_sub_;
  rclcpp::Subscription<std_msgs::msg::Float64>::SharedPtr speed_limit_sub_;
};

}  // namespace nav

#endif
