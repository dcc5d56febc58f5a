#include "managed_camera/managed_camera.hpp"

namespace managed_camera
{
using CallbackReturn = ManagedCamera::CallbackReturn;

ManagedCamera::ManagedCamera()
: LifecycleNode("camera")
{
  declare_parameter<int64_t>("fps", 30);
}

CallbackReturn ManagedCamera::on_configure(const rclcpp_lifecycle::State &)
{
  get_parameter("fps", fps_);
  image_pub_ = create_publisher<sensor_msgs::msg::Image>("image", rclcpp::SensorDataQoS());
  createServices();
  return CallbackReturn::SUCCESS;
}

CallbackReturn ManagedCamera::on_activate(const rclcpp_lifecycle::State & state)
{
  timer_ = create_wall_timer(std::chrono::milliseconds(33), std::bind(&ManagedCamera::grab, this));
  return LifecycleNode::on_activate(state);
}

CallbackReturn ManagedCamera::on_deactivate(const rclcpp_lifecycle::State & state)
{
  timer_->cancel();
  return LifecycleNode::on_deactivate(state);
}

void ManagedCamera::createServices()
{
  trigger_ = create_service<std_srvs::srv::Trigger>(
    "trigger", std::bind(&ManagedCamera::trigger, this, std::placeholders::_1, std::placeholders::_2));
}

void ManagedCamera::grab() {image_pub_->publish(sensor_msgs::msg::Image());}

void ManagedCamera::trigger(
  std_srvs::srv::Trigger::Request::SharedPtr, std_srvs::srv::Trigger::Response::SharedPtr)
{
  grab();
}
}  // namespace managed_camera

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<managed_camera::ManagedCamera>();
  rclcpp::spin(node->get_node_base_interface());
  rclcpp::shutdown();
}
