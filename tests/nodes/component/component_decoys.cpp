#include <rclcpp/rclcpp.hpp>
#include <rclcpp_components/register_node_macro.hpp>
#include <std_msgs/msg/int32.hpp>

namespace gui {
template <class T> struct Model { void create_publisher(const char *, int) {} void create_client(const char *) {} };
struct Window { void create_timer(int) {} void declare_parameter(const char *) {} };
}

/* RCLCPP_COMPONENTS_REGISTER_NODE(Old) */

class DecoyComponent : public rclcpp::Node {
 public:
  explicit DecoyComponent(const rclcpp::NodeOptions& options) : Node("decoy_component", options) {
    gui::Model<std_msgs::msg::Int32> model;
    model.create_publisher("model", 1);
    model.create_client("model");
    window_.create_timer(5);
    window_.declare_parameter("window");
    publish("not a topic");
    only_ = create_subscription<std_msgs::msg::Int32>("only", 1, [](const std_msgs::msg::Int32&) {});
    RCLCPP_INFO(get_logger(), "create_publisher<std_msgs::msg::Int32>(\"log\", 1)");
  }

 private:
  void publish(const std::string&) {}
  gui::Window window_;
  rclcpp::Subscription<std_msgs::msg::Int32>::SharedPtr only_;
};

RCLCPP_COMPONENTS_REGISTER_NODE(DecoyComponent)
