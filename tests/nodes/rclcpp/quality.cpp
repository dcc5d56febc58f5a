#include <chrono>
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/byte.hpp"

using Byte = std_msgs::msg::Byte;

class Quality : public rclcpp::Node
{
public:
  Quality() : Node("quality")
  {
    using std::placeholders::_1;
    rclcpp::QoS latched(1);
    latched.transient_local();
    latched.reliable();
    const auto sensor = rclcpp::SensorDataQoS().keep_last(3);
    auto deep = rclcpp::QoS(rclcpp::KeepLast(50)).best_effort().durability_volatile();
    int depth = 12;

    p_[0] = create_publisher<Byte>("a", 7);
    p_[1] = create_publisher<Byte>("b", latched);
    p_[2] = create_publisher<Byte>("c", sensor);
    p_[3] = create_publisher<Byte>("d", deep);
    p_[4] = create_publisher<Byte>("e", rclcpp::QoS(rclcpp::KeepAll()));
    p_[5] = create_publisher<Byte>("f", rclcpp::QoS{depth});
    p_[6] = create_publisher<Byte>("g", rclcpp::SystemDefaultsQoS());
    p_[7] = create_publisher<Byte>("h", rclcpp::QoS(1).deadline(std::chrono::milliseconds(100)));
    p_[8] = create_publisher<Byte>("i", rclcpp::QoS(4).reliability(rclcpp::ReliabilityPolicy::BestEffort));
    p_[9] = create_publisher<Byte>("j", rclcpp::QoS(4).durability(RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL));
    p_[10] = create_publisher<Byte>("k", rclcpp::QoS(rclcpp::QoSInitialization::from_rmw(rmw_qos_profile_sensor_data), rmw_qos_profile_sensor_data));
    p_[11] = create_publisher<Byte>("l", rclcpp::ParametersQoS());
    p_[12] = create_publisher<Byte>("m", rclcpp::QoS(2).lifespan(rclcpp::Duration::from_seconds(1.5)));
    s_ = create_subscription<Byte>("n", rclcpp::SensorDataQoS(), std::bind(&Quality::on, this, _1));
  }

private:
  void on(Byte::ConstSharedPtr) {}
  rclcpp::Publisher<Byte>::SharedPtr p_[13];
  rclcpp::Subscription<Byte>::SharedPtr s_;
};

int main(int c, char ** v) {rclcpp::init(c, v); rclcpp::spin(std::make_shared<Quality>()); rclcpp::shutdown(); return 0;}
