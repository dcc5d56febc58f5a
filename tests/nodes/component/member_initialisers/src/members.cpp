#include "member_initialisers/members.hpp"
#include "rclcpp_components/register_node_macro.hpp"

Members::Members(const rclcpp::NodeOptions & options) : rclcpp::Node("members", options) {}

void Members::onText(std_msgs::msg::String::UniquePtr text) {pub_->publish(std::move(text));}

RCLCPP_COMPONENTS_REGISTER_NODE(Members)
