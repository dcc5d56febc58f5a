#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/float32.hpp>

using Float = std_msgs::msg::Float32;

rclcpp::Publisher<Float>::SharedPtr speaker(const rclcpp::Node::SharedPtr & node, const char * topic)
{
  return node->create_publisher<Float>(topic, 1);
}

static auto hear(rclcpp::Node & node)
{
  return node.create_subscription<Float>("three", 1, [](Float::UniquePtr f) { (void)f; });
}

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::NodeOptions options;
  options.automatically_declare_parameters_from_overrides(true);
  auto n = std::make_shared<rclcpp::Node>("passed", options);
  const auto one = speaker(n, "one");
  const auto two = speaker(n, "two");
  const auto three = hear(*n);
  double rate = 1.0;
  n->get_parameter_or("rate", rate, 5.0);
  rclcpp::Rate loop(rate);
  while (rclcpp::ok()) {
    one->publish(Float());
    rclcpp::spin_some(n);
    loop.sleep();
  }
  rclcpp::shutdown();
}
