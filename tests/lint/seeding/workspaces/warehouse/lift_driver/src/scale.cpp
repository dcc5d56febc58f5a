#include <chrono>
#include <memory>
#include <string>

#include "rclcpp/rclcpp.hpp"
#include "sensor_msgs/msg/temperature.hpp"
#include "std_msgs/msg/float64.hpp"
#include "std_msgs/msg/string.hpp"

using namespace std::chrono_literals;
typedef std_msgs::msg::Float64 Weight;

template<typename MessageT>
void stamp(MessageT & message, const rclcpp::Time & now, const std::string & frame)
{
  message.header.stamp = now;
  message.header.frame_id = frame;
}

class Scale : public rclcpp::Node
{
public:
  Scale() : Node("scale")
  {
    declare_parameter("offset", 0.0);
    declare_parameter("samples", 8);
    pub_ = create_publisher<Weight>("scale/weight", rclcpp::SensorDataQoS());
    temperature_pub_ = create_publisher<sensor_msgs::msg::Temperature>("scale/temperature", 10);
    mode_sub_ = create_subscription<std_msgs::msg::String>(
      "scale/mode", rclcpp::QoS(1).transient_local(),
      [this](const std_msgs::msg::String::SharedPtr msg) { mode_ = msg->data; });
    timer_ = create_wall_timer(100ms, [this]() { read(); });
  }

private:
  void read()
  {
    Weight weight;
    weight.data = 12.5 - get_parameter("offset").as_double();
    pub_->publish(weight);
    sensor_msgs::msg::Temperature temperature;
    stamp(temperature, now(), "scale");
    temperature.temperature = 21.0;
    temperature_pub_->publish(temperature);
  }

  std::string mode_;
  rclcpp::Publisher<Weight>::SharedPtr pub_;
  rclcpp::Publisher<sensor_msgs::msg::Temperature>::SharedPtr temperature_pub_;
  rclcpp::Subscription<std_msgs::msg::String>::SharedPtr mode_sub_;
  rclcpp::TimerBase::SharedPtr timer_;
};

int main(int argc, char * argv[])
{
  rclcpp::init(argc, argv);
  rclcpp::executors::SingleThreadedExecutor executor;
  auto scale = std::make_shared<Scale>();
  executor.add_node(scale);
  executor.spin();
  rclcpp::shutdown();
}
