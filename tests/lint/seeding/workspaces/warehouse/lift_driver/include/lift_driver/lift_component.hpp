#pragma once

#include <memory>
#include <string>

#include "lift_msgs/msg/lift_status.hpp"
#include "lift_msgs/srv/move_to.hpp"
#include "rclcpp/rclcpp.hpp"
#include "sensor_msgs/msg/joint_state.hpp"
#include "std_srvs/srv/trigger.hpp"

namespace lift_driver
{

class LiftComponent : public rclcpp::Node
{
public:
  explicit LiftComponent(const rclcpp::NodeOptions & options);

private:
  using MoveTo = lift_msgs::srv::MoveTo;

  void on_timer();
  void on_joints(const sensor_msgs::msg::JointState::SharedPtr msg);
  void on_move(const std::shared_ptr<MoveTo::Request> request, std::shared_ptr<MoveTo::Response> response);

  double height_{0.0};
  double target_{0.0};
  double max_height_;
  std::string frame_id_;
  rclcpp::Publisher<lift_msgs::msg::LiftStatus>::SharedPtr status_pub_;
  rclcpp::Subscription<sensor_msgs::msg::JointState>::SharedPtr joint_sub_;
  rclcpp::Service<MoveTo>::SharedPtr move_srv_;
  rclcpp::Service<std_srvs::srv::Trigger>::SharedPtr home_srv_;
  rclcpp::TimerBase::SharedPtr timer_;
};

}  // namespace lift_driver
