#include <rclcpp/rclcpp.hpp>
#include <rclcpp_components/register_node_macro.hpp>
#include <std_msgs/msg/float64.hpp>

class Params : public rclcpp::Node
{
public:
  explicit Params(const rclcpp::NodeOptions & options)
  : Node("params", rclcpp::NodeOptions(options).allow_undeclared_parameters(true))
  {
    topic_ = declare_parameter("topic", std::string("value"));
    period_ms_ = declare_parameter<int>("period_ms", 100);
    declare_parameters<double>("pid", {{"p", 1.0}, {"i", 0.1}});
    if (has_parameter("debug")) {
      RCLCPP_INFO(get_logger(), "debug is %d", get_parameter("debug").as_bool());
    }
    pub_ = create_publisher<std_msgs::msg::Float64>(topic_, 10);
    timer_ = create_wall_timer(std::chrono::milliseconds(period_ms_), std::bind(&Params::tick, this));
  }

private:
  void tick()
  {
    std_msgs::msg::Float64 m;
    m.data = get_parameter("pid.p").as_double();
    pub_->publish(m);
  }

  std::string topic_;
  int period_ms_;
  rclcpp::Publisher<std_msgs::msg::Float64>::SharedPtr pub_;
  rclcpp::TimerBase::SharedPtr timer_;
};

RCLCPP_COMPONENTS_REGISTER_NODE(Params)
