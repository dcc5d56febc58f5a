#include <memory>
#include "example_interfaces/action/fibonacci.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_action/rclcpp_action.hpp"
#include "rclcpp_components/register_node_macro.hpp"

namespace act
{
class FibonacciActionServer : public rclcpp::Node
{
public:
  using Fibonacci = example_interfaces::action::Fibonacci;
  using GoalHandleFibonacci = rclcpp_action::ServerGoalHandle<Fibonacci>;

  explicit FibonacciActionServer(const rclcpp::NodeOptions & options = rclcpp::NodeOptions())
  : Node("fibonacci_action_server", options)
  {
    auto handle_goal = [](const rclcpp_action::GoalUUID &, std::shared_ptr<const Fibonacci::Goal>) {
        return rclcpp_action::GoalResponse::ACCEPT_AND_EXECUTE;
      };
    auto handle_cancel = [](const std::shared_ptr<GoalHandleFibonacci>) {
        return rclcpp_action::CancelResponse::ACCEPT;
      };
    auto handle_accepted = [this](const std::shared_ptr<GoalHandleFibonacci> goal_handle) {
        std::thread{[this, goal_handle]() {this->execute(goal_handle);}}.detach();
      };
    action_server_ = rclcpp_action::create_server<Fibonacci>(this, "fibonacci", handle_goal, handle_cancel, handle_accepted);
  }

private:
  void execute(const std::shared_ptr<GoalHandleFibonacci> goal_handle)
  {
    goal_handle->succeed(std::make_shared<Fibonacci::Result>());
  }
  rclcpp_action::Server<Fibonacci>::SharedPtr action_server_;
};
}

RCLCPP_COMPONENTS_REGISTER_NODE(act::FibonacciActionServer)
