#include "held_node/held.hh"

Held::Held() : node_(rclcpp::Node::make_shared("held")) {
  sub_ = node_->create_subscription<std_msgs::msg::UInt8>("level", 1, [this](std_msgs::msg::UInt8::ConstSharedPtr m) { Level(*m); });
  pub_ = node_->create_publisher<std_msgs::msg::UInt8>(prefix_ + "/level", 1);
  node_->declare_parameter("offset", 2);
}

void Held::Level(const std_msgs::msg::UInt8& m) { pub_->publish(m); }

void Held::Spin() { rclcpp::spin(node_); }

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  Held held;
  held.Spin();
}
