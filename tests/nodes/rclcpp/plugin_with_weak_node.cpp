// A layer that a server loads: the node is the server's, held weakly.
#include <rclcpp/rclcpp.hpp>
#include <rclcpp_lifecycle/lifecycle_node.hpp>
#include <sensor_msgs/msg/range.hpp>
#include <std_srvs/srv/set_bool.hpp>

namespace layers
{

class RangeLayer
{
public:
  void onInitialize(const rclcpp_lifecycle::LifecycleNode::WeakPtr & parent, const std::string & name)
  {
    node_ = parent;
    name_ = name;
    auto node = node_.lock();
    if (!node) {
      throw std::runtime_error{"Failed to lock node"};
    }
    node->declare_parameter(name_ + ".enabled", rclcpp::ParameterValue(true));
    range_sub_ = node->create_subscription<sensor_msgs::msg::Range>(
      "range", rclcpp::SensorDataQoS(),
      std::bind(&RangeLayer::rangeCallback, this, std::placeholders::_1));
    enable_srv_ = node->create_service<std_srvs::srv::SetBool>(
      name_ + "/enable", std::bind(&RangeLayer::enable, this, std::placeholders::_1, std::placeholders::_2));
  }

private:
  void rangeCallback(const sensor_msgs::msg::Range::SharedPtr) {}
  void enable(const std_srvs::srv::SetBool::Request::SharedPtr, std_srvs::srv::SetBool::Response::SharedPtr) {}

  rclcpp_lifecycle::LifecycleNode::WeakPtr node_;
  std::string name_;
  rclcpp::Subscription<sensor_msgs::msg::Range>::SharedPtr range_sub_;
  rclcpp::Service<std_srvs::srv::SetBool>::SharedPtr enable_srv_;
};

}  // namespace layers
