#include <rclcpp/rclcpp.hpp>
#include <rclcpp_components/register_node_macro.hpp>
#include <std_msgs/msg/float64.hpp>
#include <std_msgs/msg/int64.hpp>
#include <cinttypes>

#define HALF_CLASS(name) class name : public rclcpp::Node
#define HALF_DEFAULTS \
  rclcpp::TimerBase::SharedPtr timer_; \
  int64_t ticks_ = 0;
#define HALF_PUB(type, topic) create_publisher<type>(topic, 1)
#define THROTTLED(...) RCLCPP_INFO_THROTTLE(get_logger(), *get_clock(), 1000, __VA_ARGS__)

class __attribute__((visibility("default"))) Half final : public rclcpp::Node
{
  HALF_DEFAULTS
  RCLCPP_DISABLE_COPY(Half)

public:
  explicit Half(const rclcpp::NodeOptions & options) noexcept(false)
  : Node("half", options)
  {
    static_assert(sizeof(int64_t) == 8, "64 bits");
    timer_ = create_wall_timer(std::chrono::seconds(1), [this]() {
      THROTTLED("tick %" PRId64 " / %" PRIu64 "%s", ticks_++, static_cast<uint64_t>(ticks_), "!");
    });
    in_ = create_subscription<std_msgs::msg::Int64>(
      "in", 1, std::bind(&Half::in, this, std::placeholders::_1));
    out_ = create_publisher<std_msgs::msg::Float64>("out", 1);
  }
  ~Half() override = default;

private:
  void in(std_msgs::msg::Int64::ConstSharedPtr msg)
  {
    RCLCPP_DEBUG(get_logger(), "in %" PRId64, msg->data);
    out_->publish(std_msgs::msg::Float64());
  }
  rclcpp::Subscription<std_msgs::msg::Int64>::SharedPtr in_;
  rclcpp::Publisher<std_msgs::msg::Float64>::SharedPtr out_;
};

RCLCPP_COMPONENTS_REGISTER_NODE(Half)
