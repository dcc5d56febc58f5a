#pragma once
#include <example_interfaces/action/fibonacci.hpp>
#include <rclcpp/rclcpp.hpp>
#include <rclcpp_action/rclcpp_action.hpp>

class Mover : public rclcpp::Node
{
    using Move = example_interfaces::action::Fibonacci;
    using Handle = std::shared_ptr<rclcpp_action::ServerGoalHandle<Move>>;

public:
    explicit Mover(const rclcpp::NodeOptions &options);

private:
    rclcpp_action::GoalResponse goal(const rclcpp_action::GoalUUID &id, std::shared_ptr<const Move::Goal> goal);
    rclcpp_action::CancelResponse cancel(Handle handle);
    void accepted(Handle handle);

    rclcpp_action::Server<Move>::SharedPtr server_;
    rclcpp_action::Client<Move>::SharedPtr client_;
};
