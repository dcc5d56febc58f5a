#include "split_component/station_component.hpp"

StationComponent::StationComponent(const rclcpp::NodeOptions & options) : Node("station", options)
{
  declareParameters();
  createTopics();
}

void StationComponent::declareParameters()
{
  wind_topic_ = declare_parameter<std::string>("wind_topic", "wind");
  hz_ = declare_parameter<double>("hz", 4.0);
}

void StationComponent::createTopics()
{
  wind_ = create_subscription<geometry_msgs::msg::Vector3Stamped>(
    wind_topic_, 10, std::bind(&StationComponent::windCallback, this, std::placeholders::_1));
  weather_ = create_publisher<sensor_msgs::msg::Temperature>("weather", 10);
  calibrate_ = create_client<std_srvs::srv::Trigger>("calibrate");
  timer_ = create_wall_timer(
    std::chrono::duration<double>(1.0 / hz_), std::bind(&StationComponent::timerCallback, this));
}

#include "rclcpp_components/register_node_macro.hpp"
RCLCPP_COMPONENTS_REGISTER_NODE(StationComponent)
