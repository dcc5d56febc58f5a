#include "arms/arms.hpp"
#include "rclcpp_components/register_node_macro.hpp"

Left::Left(const rclcpp::NodeOptions & options) : Node("left_arm", options)
{
  goal_ = create_subscription<Pose>("left/goal", 1, std::bind(&Left::goal, this, std::placeholders::_1));
}

void Left::goal(Pose::SharedPtr) {}

Right::Right(const rclcpp::NodeOptions & options) : Node("right_arm", options)
{
  goal_ = create_subscription<Pose>("right/goal", 1, std::bind(&Right::goal, this, std::placeholders::_1));
  at_ = create_publisher<Pose>("right/at", 1);
}

void Right::goal(Pose::SharedPtr pose) {at_->publish(*pose);}

RCLCPP_COMPONENTS_REGISTER_NODE(Left)
RCLCPP_COMPONENTS_REGISTER_NODE(Right)
