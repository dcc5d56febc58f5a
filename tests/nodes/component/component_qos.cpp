#include "rclcpp/rclcpp.hpp"
#include "rclcpp_components/register_node_macro.hpp"
#include "sensor_msgs/msg/temperature.hpp"

using Temp = sensor_msgs::msg::Temperature;
static const rclcpp::QoS kLatched = rclcpp::QoS(1).transient_local().reliable();

class Qos : public rclcpp::Node
{
public:
  Qos(const rclcpp::NodeOptions & options) : Node("qos", options)
  {
    rclcpp::QoS sensor = rclcpp::SensorDataQoS();
    sensor.keep_last(2);
    auto all = rclcpp::QoS(rclcpp::KeepAll()).reliable();
    rmw_qos_profile_t raw = rmw_qos_profile_default;
    auto from = rclcpp::QoS(rclcpp::QoSInitialization(raw.history, 8), raw);

    a_ = create_publisher<Temp>("a", kLatched);
    b_ = create_publisher<Temp>("b", sensor);
    c_ = create_publisher<Temp>("c", all);
    d_ = create_publisher<Temp>("d", from);
    e_ = create_publisher<Temp>("e", rclcpp::QoS(rclcpp::KeepLast(6)).reliable().transient_local());
    f_ = create_publisher<Temp>("f", rclcpp::QoS{rclcpp::KeepLast(11)});
    g_ = create_publisher<Temp>("g", sensorQos(3));
  }

private:
  static rclcpp::QoS sensorQos(size_t depth)
  {
    rclcpp::QoS qos(depth);
    if (depth > 2) {
      qos.best_effort();
    }
    return qos;
  }
  rclcpp::Publisher<Temp>::SharedPtr a_, b_, c_, d_, e_, f_, g_;
};

RCLCPP_COMPONENTS_REGISTER_NODE(Qos)
