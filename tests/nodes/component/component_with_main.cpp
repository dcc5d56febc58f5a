#include <rclcpp/rclcpp.hpp>
#include <rclcpp_components/register_node_macro.hpp>
#include <sensor_msgs/msg/fluid_pressure.hpp>

class Both : public rclcpp::Node
{
public:
  explicit Both(const rclcpp::NodeOptions & options = rclcpp::NodeOptions())
  : Node("both", options)
  {
    timer_ = create_wall_timer(std::chrono::seconds(1), std::bind(&Both::tick, this));
    pub_ = create_publisher<sensor_msgs::msg::FluidPressure>("pressure", rclcpp::SensorDataQoS());
  }

private:
  void tick() {pub_->publish(sensor_msgs::msg::FluidPressure());}
  rclcpp::TimerBase::SharedPtr timer_;
  rclcpp::Publisher<sensor_msgs::msg::FluidPressure>::SharedPtr pub_;
};

RCLCPP_COMPONENTS_REGISTER_NODE(Both)

#ifdef STANDALONE
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Both>());
  rclcpp::shutdown();
}
#endif
