#include <rclcpp/rclcpp.hpp>
#include <rclcpp_components/register_node_macro.hpp>
#include <sensor_msgs/msg/range.hpp>

constexpr const char * DEFAULT_NAME = "radar";

class Radar : public rclcpp::Node
{
public:
  Radar(const std::string & name, const rclcpp::NodeOptions & options)
  : Node(name, options), prefix_("radar")
  {
    near_ = create_publisher<sensor_msgs::msg::Range>(prefix_ + "/near", 10);
    far_ = create_publisher<sensor_msgs::msg::Range>(prefix_ + "/far", 10);
  }
  explicit Radar(const rclcpp::NodeOptions & options) : Radar(DEFAULT_NAME, options) {}

private:
  const std::string prefix_;
  rclcpp::Publisher<sensor_msgs::msg::Range>::SharedPtr near_, far_;
};

RCLCPP_COMPONENTS_REGISTER_NODE(Radar)
