#include "rclcpp/rclcpp.hpp"
#include "rclcpp_components/register_node_macro.hpp"
#include "std_msgs/msg/string.hpp"

class Events : public rclcpp::Node
{
public:
  explicit Events(const rclcpp::NodeOptions & options)
  : Node("events", options)
  {
    rclcpp::PublisherOptions publisher_options;
    publisher_options.event_callbacks.deadline_callback = [](rclcpp::QOSDeadlineOfferedInfo &) {};
    rclcpp::SubscriptionOptions subscription_options;
    subscription_options.event_callbacks.liveliness_callback =
      [this](rclcpp::QOSLivelinessChangedInfo & event) {RCLCPP_INFO(get_logger(), "%d", event.alive_count);};
    rclcpp::QoS qos(10);
    qos.deadline(std::chrono::milliseconds(500));
    out_ = create_publisher<std_msgs::msg::String>("out", qos, publisher_options);
    in_ = create_subscription<std_msgs::msg::String>(
      "in", qos, std::bind(&Events::in, this, std::placeholders::_1, std::placeholders::_2), subscription_options);
  }

private:
  void in(const std_msgs::msg::String &, const rclcpp::MessageInfo &) {}
  rclcpp::Publisher<std_msgs::msg::String>::SharedPtr out_;
  rclcpp::Subscription<std_msgs::msg::String>::SharedPtr in_;
};

RCLCPP_COMPONENTS_REGISTER_NODE(Events)
