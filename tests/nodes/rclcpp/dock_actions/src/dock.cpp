#include "dock_actions/dock.hpp"

Dock::Dock() : Node("dock")
{
  using namespace std::placeholders;
  server_ = rclcpp_action::create_server<DockAction>(this, "dock",
    std::bind(&Dock::onGoal, this, _1, _2), std::bind(&Dock::onCancel, this, _1),
    std::bind(&Dock::onAccepted, this, _1));
  client_ = rclcpp_action::create_client<DockAction>(this, "navigate");
}

rclcpp_action::GoalResponse Dock::onGoal(const rclcpp_action::GoalUUID &, std::shared_ptr<const DockAction::Goal>)
{
  return rclcpp_action::GoalResponse::ACCEPT_AND_EXECUTE;
}

rclcpp_action::CancelResponse Dock::onCancel(const std::shared_ptr<GoalHandle>)
{
  return rclcpp_action::CancelResponse::ACCEPT;
}

void Dock::onAccepted(const std::shared_ptr<GoalHandle> handle)
{
  client_->async_send_goal(*handle->get_goal());
}

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Dock>());
}
