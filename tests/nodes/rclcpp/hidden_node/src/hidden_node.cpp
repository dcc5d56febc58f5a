#include "hidden_node/hidden_node.hpp"

#include <sensor_msgs/msg/magnetic_field.hpp>

struct HiddenNode::Impl
{
  explicit Impl(rclcpp::Node * node) : node(node)
  {
    pub = node->create_publisher<sensor_msgs::msg::MagneticField>("mag", 10);
    sub = node->create_subscription<sensor_msgs::msg::MagneticField>(
      "mag_raw", 10, std::bind(&Impl::raw, this, std::placeholders::_1));
  }
  void raw(const sensor_msgs::msg::MagneticField & m) {pub->publish(m);}

  rclcpp::Node * node;
  rclcpp::Publisher<sensor_msgs::msg::MagneticField>::SharedPtr pub;
  rclcpp::Subscription<sensor_msgs::msg::MagneticField>::SharedPtr sub;
};

HiddenNode::HiddenNode() : Node("hidden"), impl_(std::make_unique<Impl>(this)) {}
HiddenNode::~HiddenNode() = default;

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<HiddenNode>());
}
