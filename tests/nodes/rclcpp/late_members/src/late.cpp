#include "late_members/late.hpp"

Late::Late()
: rclcpp::Node("late"),
  sub_(nullptr), pub_{nullptr}, timer_(), client_(nullptr), action_(nullptr), broadcaster_{nullptr}, filter_(nullptr)
{
  if (!sub_) {
    sub_ = create_subscription<std_msgs::msg::Empty>("go", 1, std::bind(&Late::go, this, std::placeholders::_1));
  }
}

void Late::go(std_msgs::msg::Empty::ConstSharedPtr)
{
  pub_ = create_publisher<std_msgs::msg::Empty>("gone", rclcpp::QoS(1));
  client_ = create_client<std_srvs::srv::Trigger>("prepare");
  action_ = rclcpp_action::create_client<example_interfaces::action::Fibonacci>(this->get_node_base_interface(), this->get_node_graph_interface(), this->get_node_logging_interface(), this->get_node_waitables_interface(), "count");
  broadcaster_ = std::make_unique<tf2_ros::TransformBroadcaster>(this);
  filter_ = std::make_shared<message_filters::Subscriber<sensor_msgs::msg::Image>>(this, "image");
  timer_ = create_wall_timer(std::chrono::seconds(2), [this, self = shared_from_this()]() {pub_->publish(std_msgs::msg::Empty());});
}

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Late>());
  rclcpp::shutdown();
}
