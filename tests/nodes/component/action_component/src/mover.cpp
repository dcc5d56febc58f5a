#include "action_component/mover.hpp"

Mover::Mover(const rclcpp::NodeOptions &options)
    : Node("mover", options)
{
    using namespace std::placeholders;
    server_ = rclcpp_action::create_server<Move>(
        get_node_base_interface(), get_node_clock_interface(), get_node_logging_interface(), get_node_waitables_interface(),
        "move", std::bind(&Mover::goal, this, _1, _2), std::bind(&Mover::cancel, this, _1), std::bind(&Mover::accepted, this, _1));
    client_ = rclcpp_action::create_client<Move>(this, "plan");
}

rclcpp_action::GoalResponse Mover::goal(const rclcpp_action::GoalUUID &, std::shared_ptr<const Move::Goal>)
{
    return rclcpp_action::GoalResponse::REJECT;
}

rclcpp_action::CancelResponse Mover::cancel(Handle) { return rclcpp_action::CancelResponse::REJECT; }

void Mover::accepted(Handle handle) { handle->abort(std::make_shared<Move::Result>()); }

#include <rclcpp_components/register_node_macro.hpp>
RCLCPP_COMPONENTS_REGISTER_NODE(Mover)
