#include <elevation/elevation.hpp>

Elevation::Elevation(const rclcpp::NodeOptions& options) : rclcpp::Node(NODE, options) {
  cloud_ = create_subscription<Cloud>(kCloud, 1, std::bind(&Elevation::Update, this, std::placeholders::_1));
  map_ = create_publisher<Cloud>(kMap, rclcpp::QoS(1).transient_local());
  save_ = create_service<std_srvs::srv::Trigger>("save", std::bind(&Elevation::Save, this, std::placeholders::_1, std::placeholders::_2));
}

#include <rclcpp_components/register_node_macro.hpp>
RCLCPP_COMPONENTS_REGISTER_NODE(Elevation)
