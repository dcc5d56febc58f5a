#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/header.hpp>

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  const auto node = std::make_shared<rclcpp::Node>("sub_nodes", "/robots");
  auto arm = node->create_sub_node("arm");
  auto a = node->create_publisher<std_msgs::msg::Header>("a", 1);
  auto b = arm->create_publisher<std_msgs::msg::Header>("b", 1);
  auto c = node->create_publisher<std_msgs::msg::Header>("~/c", 1);
  auto d = node->create_publisher<std_msgs::msg::Header>("/d", 1);
  rclcpp::spin(node);
}
