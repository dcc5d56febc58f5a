#include "marine.hpp"
#include "rclcpp_components/register_node_macro.hpp"

namespace ocean::deep
{
Marine::Marine(const rclcpp::NodeOptions &options)
	: rclcpp::Node{"marine", options}
{
	depth_ = this->create_subscription<Depth>("depth", rclcpp::QoS{rclcpp::KeepLast{7}},
	                                          [this](Depth::ConstSharedPtr msg) { this->onDepth(std::move(msg)); });
	state_ = this->create_publisher<State>(topic("state"), 1);
}

void Marine::onDepth(Depth::ConstSharedPtr)
{
	state_->publish(State{});
}
} // namespace ocean::deep

RCLCPP_COMPONENTS_REGISTER_NODE(ocean::deep::Marine);
