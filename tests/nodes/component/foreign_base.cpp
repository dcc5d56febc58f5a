#include <rclcpp_components/register_node_macro.hpp>
#include <robot_utils/robot_node.hpp>
#include <sensor_msgs/msg/joy.hpp>
#include <std_msgs/msg/string.hpp>

// The base is another package's, and is a node.
class Foreign : public robot_utils::RobotNode
{
public:
  explicit Foreign(const rclcpp::NodeOptions & options)
  : robot_utils::RobotNode("foreign", options)
  {
    joy_ = create_subscription<sensor_msgs::msg::Joy>("joy", 10, std::bind(&Foreign::joy, this, std::placeholders::_1));
    say_ = this->create_publisher<std_msgs::msg::String>("say", 10);
  }

private:
  void joy(sensor_msgs::msg::Joy::ConstSharedPtr) {}
  rclcpp::Subscription<sensor_msgs::msg::Joy>::SharedPtr joy_;
  rclcpp::Publisher<std_msgs::msg::String>::SharedPtr say_;
};

RCLCPP_COMPONENTS_REGISTER_NODE(Foreign)
