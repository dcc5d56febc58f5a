#ifndef DOCK_ACTIONS_DOCK_HPP
#define DOCK_ACTIONS_DOCK_HPP
#include <example_interfaces/action/fibonacci.hpp>
#include <rclcpp/rclcpp.hpp>
#include <rclcpp_action/rclcpp_action.hpp>

class Dock : public rclcpp::Node
{
public:
  using DockAction = example_interfaces::action::Fibonacci;
  using GoalHandle = rclcpp_action::ServerGoalHandle<DockAction>;
  Dock();

private:
  rclcpp_action::GoalResponse onGoal(const rclcpp_action::GoalUUID & uuid, std::shared_ptr<const DockAction::Goal> goal);
  rclcpp_action::CancelResponse onCancel(const std::shared_ptr<GoalHandle> handle);
  void onAccepted(const std::shared_ptr<GoalHandle> handle);

  rclcpp_action::Server<DockAction>::SharedPtr server_;
  rclcpp_action::Client<DockAction>::SharedPtr client_;
};
#endif
