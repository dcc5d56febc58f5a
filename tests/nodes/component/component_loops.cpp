#include <map>
#include <rclcpp/rclcpp.hpp>
#include <rclcpp_components/register_node_macro.hpp>
#include <sensor_msgs/msg/illuminance.hpp>

namespace sensors
{
class Bank : public rclcpp::Node
{
  using Light = sensor_msgs::msg::Illuminance;
  std::map<std::string, rclcpp::Publisher<Light>::SharedPtr> pubs_;
  std::vector<rclcpp::Subscription<Light>::SharedPtr> subs_;

public:
  explicit Bank(const rclcpp::NodeOptions & options)
  : Node("bank", options)
  {
    for (const std::string name : {"north", "south"})
    {
      pubs_[name] = create_publisher<Light>("light/" + name, 1);
    }
    const auto names = declare_parameter<std::vector<std::string>>("names", {});
    for (const auto & name : names)
    {
      subs_.emplace_back(create_subscription<Light>(name, 1, [](const Light &) {}));
    }
  }
};
}

RCLCPP_COMPONENTS_REGISTER_NODE(sensors::Bank)
