#include <rclcpp/rclcpp.hpp>
#include <rclcpp_components/register_node_macro.hpp>
#include <std_msgs/msg/u_int16.hpp>

class Interfaces : public rclcpp::Node {
 public:
  explicit Interfaces(const rclcpp::NodeOptions& options) : Node("interfaces", options) {
    auto topics = get_node_topics_interface();
    pub_ = rclcpp::create_publisher<std_msgs::msg::UInt16>(topics, "port", rclcpp::QoS(3));
    sub_ = rclcpp::create_subscription<std_msgs::msg::UInt16>(*this, "wanted", 3, [](std_msgs::msg::UInt16::ConstSharedPtr) {});
    timer_ = rclcpp::create_wall_timer(std::chrono::seconds(3), [this]() { Tick(); }, nullptr, get_node_base_interface().get(), get_node_timers_interface().get());
  }

 private:
  void Tick() {}
  rclcpp::Publisher<std_msgs::msg::UInt16>::SharedPtr pub_;
  rclcpp::Subscription<std_msgs::msg::UInt16>::SharedPtr sub_;
  rclcpp::TimerBase::SharedPtr timer_;
};

RCLCPP_COMPONENTS_REGISTER_NODE(Interfaces)
