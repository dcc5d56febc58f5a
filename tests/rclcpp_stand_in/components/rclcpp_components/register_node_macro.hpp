// What makes a program of a component, as `rclcpp_components_register_node(... EXECUTABLE ...)`
// does: the stand-in of rclcpp has no container that loads it.

#ifndef RCLCPP_COMPONENTS__REGISTER_NODE_MACRO_HPP_
#define RCLCPP_COMPONENTS__REGISTER_NODE_MACRO_HPP_

#include <memory>

#include "rclcpp/rclcpp.hpp"

#define RCLCPP_COMPONENTS_REGISTER_NODE(NodeClass) \
  int main(int argc, char ** argv) \
  { \
    rclcpp::init(argc, argv); \
    auto node = std::make_shared<NodeClass>(rclcpp::NodeOptions()); \
    rclcpp::spin(node->get_node_base_interface()); \
    rclcpp::shutdown(); \
    return 0; \
  }

#endif  // RCLCPP_COMPONENTS__REGISTER_NODE_MACRO_HPP_
