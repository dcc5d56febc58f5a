#include <rclcpp/node_interfaces/node_base_interface.hpp>
#include <rclcpp/rclcpp.hpp>
#include <rclcpp_components/register_node_macro.hpp>
#include <std_msgs/msg/int16.hpp>

// No subclass of Node: whatever has this constructor and get_node_base_interface() can be loaded.
class Plain
{
public:
  explicit Plain(const rclcpp::NodeOptions & options)
  : node_(std::make_shared<rclcpp::Node>("plain", options))
  {
    sub_ = node_->create_subscription<std_msgs::msg::Int16>("number", 1,
      [this](std_msgs::msg::Int16::ConstSharedPtr) {});
    pub_ = node_->create_publisher<std_msgs::msg::Int16>("square", 1);
  }

  rclcpp::node_interfaces::NodeBaseInterface::SharedPtr get_node_base_interface() const
  {
    return node_->get_node_base_interface();
  }

private:
  rclcpp::Node::SharedPtr node_;
  rclcpp::Subscription<std_msgs::msg::Int16>::SharedPtr sub_;
  rclcpp::Publisher<std_msgs::msg::Int16>::SharedPtr pub_;
};

RCLCPP_COMPONENTS_REGISTER_NODE(Plain)
