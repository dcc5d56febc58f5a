#ifndef VISIBLE__VISIBLE_HPP_
#define VISIBLE__VISIBLE_HPP_
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/int64.hpp"
#include "visible/macros.hpp"

namespace visible
{
class VISIBLE_PUBLIC Visible : public rclcpp::Node
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Visible)

  VISIBLE_PUBLIC Visible();

private:
  VISIBLE_LOCAL void on_value(const std_msgs::msg::Int64::SharedPtr msg);

  rclcpp::Subscription<std_msgs::msg::Int64>::SharedPtr value_;
  rclcpp::Publisher<std_msgs::msg::Int64>::SharedPtr echo_;
};
}  // namespace visible
#endif  // VISIBLE__VISIBLE_HPP_
