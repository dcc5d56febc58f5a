#include "lift_driver/lift_component.hpp"

#include <algorithm>
#include <chrono>
#include <functional>

#include "rclcpp_components/register_node_macro.hpp"

using namespace std::chrono_literals;
using std::placeholders::_1;
using std::placeholders::_2;

namespace lift_driver
{

LiftComponent::LiftComponent(const rclcpp::NodeOptions & options)
: Node("lift", options)
{
  max_height_ = this->declare_parameter("max_height", 3.2);
  frame_id_ = this->declare_parameter<std::string>("frame_id", "lift_base");
  declare_parameter<int>("motor_id", 4);
  declare_parameter("brake", true);

  status_pub_ = this->create_publisher<lift_msgs::msg::LiftStatus>("lift/status", 10);
  joint_sub_ = create_subscription<sensor_msgs::msg::JointState>(
    "joint_states", rclcpp::SensorDataQoS(), std::bind(&LiftComponent::on_joints, this, _1));
  move_srv_ = create_service<MoveTo>("lift/move_to", std::bind(&LiftComponent::on_move, this, _1, _2));
  home_srv_ = create_service<std_srvs::srv::Trigger>(
    "lift/home",
    [this](const std_srvs::srv::Trigger::Request::SharedPtr, std_srvs::srv::Trigger::Response::SharedPtr response) {
      target_ = 0.0;
      response->success = true;
      response->message = "going home";
    });
  timer_ = this->create_wall_timer(50ms, std::bind(&LiftComponent::on_timer, this));
}

void LiftComponent::on_timer()
{
  height_ += std::clamp(target_ - height_, -0.05, 0.05);
  auto status = lift_msgs::msg::LiftStatus();
  status.header.stamp = this->now();
  status.header.frame_id = frame_id_;
  status.state = height_ == target_ ? lift_msgs::msg::LiftStatus::IDLE : lift_msgs::msg::LiftStatus::MOVING;
  status.height = height_;
  status_pub_->publish(status);
}

void LiftComponent::on_joints(const sensor_msgs::msg::JointState::SharedPtr msg)
{
  if (!msg->position.empty()) {
    height_ = msg->position[0];
  }
}

void LiftComponent::on_move(
  const std::shared_ptr<MoveTo::Request> request, std::shared_ptr<MoveTo::Response> response)
{
  response->accepted = request->height <= max_height_;
  if (!response->accepted) {
    response->reason = "too high";
    return;
  }
  target_ = request->height;
  RCLCPP_INFO(get_logger(), "brake: %d", get_parameter("brake").as_bool());
}

}  // namespace lift_driver

RCLCPP_COMPONENTS_REGISTER_NODE(lift_driver::LiftComponent)
