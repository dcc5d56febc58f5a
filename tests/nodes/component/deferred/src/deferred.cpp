#include "deferred/deferred.hpp"

Deferred::Deferred(const rclcpp::NodeOptions & options) : Node("deferred", options)
{
  start_ = create_wall_timer(std::chrono::milliseconds(1), std::bind(&Deferred::init, this));
}

void Deferred::init()
{
  start_->cancel();
  imu_ = create_subscription<sensor_msgs::msg::Imu>("imu", rclcpp::SensorDataQoS().reliable(), std::bind(&Deferred::onImu, this, std::placeholders::_1));
  zero_ = create_client<std_srvs::srv::Empty>("imu/zero");
  while (rclcpp::ok() && !zero_->wait_for_service(std::chrono::seconds(1))) {
    RCLCPP_INFO_THROTTLE(get_logger(), *get_clock(), 5000, "waiting for create_service<Empty>(\"imu/zero\")");
  }
}

void Deferred::onImu(sensor_msgs::msg::Imu::ConstSharedPtr) {}

#include "rclcpp_components/register_node_macro.hpp"
RCLCPP_COMPONENTS_REGISTER_NODE(Deferred)
