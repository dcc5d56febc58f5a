#include <cinttypes>

#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/int64.hpp"
#include "std_msgs/msg/u_int64.hpp"

#ifndef WITH_EXTRA
# define WITH_EXTRA 1
#endif

class Branches : public rclcpp::Node
{
public:
  Branches() : Node("branches")
  {
#if WITH_EXTRA
    extra_ = create_publisher<std_msgs::msg::Int64>("extra", 1);
#endif
#ifdef NEVER_DEFINED
    extra_ = create_publisher<std_msgs::msg::Int64>("other", 1);
#else
    sub_ = create_subscription<std_msgs::msg::UInt64>("ticks", 1,
      [this](std_msgs::msg::UInt64::ConstSharedPtr ticks) {
        RCLCPP_INFO(get_logger(), "ticks: %" PRIu64 ", %" PRId64, ticks->data, int64_t{-1});
      });
#endif
#if 0
    dead_ = create_publisher<std_msgs::msg::Int64>("dead", 1);
#endif
  }

private:
  rclcpp::Publisher<std_msgs::msg::Int64>::SharedPtr extra_;
  rclcpp::Subscription<std_msgs::msg::UInt64>::SharedPtr sub_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Branches>());
  rclcpp::shutdown();
}
