#include "beacon/beacon.hpp"
#include "beacon/names.hpp"
#include <rclcpp_components/register_node_macro.hpp>

using namespace acme;

Beacon::Beacon(rclcpp::NodeOptions const & opts) : Node(names::kNode, opts)
{
  m_pBlink = create_publisher<std_msgs::msg::Bool>(names::kBlink, names::kDepth);
  m_pMode = create_subscription<std_msgs::msg::UInt8>(names::mode, names::kDepth,
    [this](std_msgs::msg::UInt8::ConstSharedPtr const & pMode) { m_mode = pMode->data; });
  m_pTimer = create_wall_timer(names::kPeriod, [this] { OnTimer(); });
}

void Beacon::OnTimer()
{
  std_msgs::msg::Bool lit;
  lit.data = m_mode != 0;
  m_pBlink->publish(lit);
}

RCLCPP_COMPONENTS_REGISTER_NODE(acme::Beacon)
