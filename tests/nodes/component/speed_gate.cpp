#include <geometry_msgs/msg/twist.hpp>
#include <rclcpp/rclcpp.hpp>
#include <rclcpp_components/register_node_macro.hpp>
#include <std_srvs/srv/set_bool.hpp>

class SpeedGate : public rclcpp::Node {
 public:
  explicit SpeedGate(const rclcpp::NodeOptions& options) : rclcpp::Node("speed_gate", options) {
    max_speed_ = declare_parameter<double>("max_speed", 1.0);
    out_ = create_publisher<geometry_msgs::msg::Twist>("cmd_vel_out", rclcpp::QoS(1));
    in_ = create_subscription<geometry_msgs::msg::Twist>("cmd_vel", rclcpp::QoS(1), std::bind(&SpeedGate::OnTwist, this, std::placeholders::_1));
    gate_ = create_service<std_srvs::srv::SetBool>("~/open", [this](const std_srvs::srv::SetBool::Request::SharedPtr q, std_srvs::srv::SetBool::Response::SharedPtr r) {
      open_ = q->data;
      r->success = true;
    });
  }

 private:
  void OnTwist(geometry_msgs::msg::Twist::UniquePtr twist) {
    if (open_) out_->publish(std::move(twist));
  }

  double max_speed_;
  bool open_{true};
  rclcpp::Publisher<geometry_msgs::msg::Twist>::SharedPtr out_;
  rclcpp::Subscription<geometry_msgs::msg::Twist>::SharedPtr in_;
  rclcpp::Service<std_srvs::srv::SetBool>::SharedPtr gate_;
};

RCLCPP_COMPONENTS_REGISTER_NODE(SpeedGate)
