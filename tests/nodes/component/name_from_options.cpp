#include <rclcpp/rclcpp.hpp>
#include <rclcpp_components/register_node_macro.hpp>
#include <std_msgs/msg/u_int64.hpp>

namespace
{
constexpr auto kPeriod = std::chrono::milliseconds{10};
std::string prefixed(const std::string & name) {return "prefix/" + name;}
}

class NamedByCaller : public rclcpp::Node
{
public:
  NamedByCaller(const std::string & name, const rclcpp::NodeOptions & options)
  : Node(name, options)
  {
    out_ = create_publisher<std_msgs::msg::UInt64>(prefixed("out"), rclcpp::QoS{1});
    for (const auto & [name, depth] : std::map<std::string, int>{{"x", 1}, {"y", 2}}) {
      more_[name] = create_publisher<std_msgs::msg::UInt64>(name, depth);
    }
    timer_ = create_wall_timer(kPeriod, [this]() {
        std_msgs::msg::UInt64 m;
        m.data = n_++;
        out_->publish(m);
      });
  }
  explicit NamedByCaller(const rclcpp::NodeOptions & options)
  : NamedByCaller(std::getenv("NODE_NAME") ? std::getenv("NODE_NAME") : "named", options) {}

private:
  uint64_t n_ = 0;
  rclcpp::Publisher<std_msgs::msg::UInt64>::SharedPtr out_;
  std::map<std::string, rclcpp::Publisher<std_msgs::msg::UInt64>::SharedPtr> more_;
  rclcpp::TimerBase::SharedPtr timer_;
};

RCLCPP_COMPONENTS_REGISTER_NODE(NamedByCaller)
