#include "visible/visible.hpp"
#include <cinttypes>

VISIBLE_OPEN
VISIBLE_PUBLIC
Visible::Visible()
: rclcpp::Node("visible")
{
  value_ = create_subscription<std_msgs::msg::Int64>("value", 10, std::bind(&Visible::on_value, this, std::placeholders::_1));
  echo_ = create_publisher<std_msgs::msg::Int64>("echo", 10);
}

VISIBLE_LOCAL void Visible::on_value(const std_msgs::msg::Int64::SharedPtr msg)
{
  RCLCPP_INFO(get_logger(), "value %" PRId64 " [" VISIBLE_UNIT "]", msg->data);
  echo_->publish(*msg);
}
VISIBLE_CLOSE

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<visible::Visible>());
  rclcpp::shutdown();
  return 0;
}
