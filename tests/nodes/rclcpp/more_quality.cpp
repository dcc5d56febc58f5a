#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/int8.hpp>
#include <std_srvs/srv/empty.hpp>

using Int8 = std_msgs::msg::Int8;

class MoreQuality : public rclcpp::Node
{
public:
  MoreQuality() : Node("more_quality")
  {
    auto qos = rclcpp::QoS(rclcpp::QoSInitialization(RMW_QOS_POLICY_HISTORY_KEEP_LAST, 3));
    qos.reliability(RMW_QOS_POLICY_RELIABILITY_BEST_EFFORT);
    qos.durability(RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL);
    p_[0] = create_publisher<Int8>("a", qos);
    p_[1] = create_publisher<Int8>("b", rclcpp::QoS(rclcpp::KeepLast(1), rmw_qos_profile_sensor_data));
    rclcpp::QoS copy = qos;
    copy.reliable().keep_last(9);
    p_[2] = create_publisher<Int8>("c", copy);
    p_[3] = create_publisher<Int8>("d", member_);
    p_[4] = create_publisher<Int8>("e", rclcpp::ServicesQoS().best_effort());
    p_[5] = create_publisher<Int8>("f", 1 + 1);
    p_[6] = create_publisher<Int8>("g", rclcpp::QoS(5).durability(rclcpp::DurabilityPolicy::TransientLocal).history(rclcpp::HistoryPolicy::KeepLast));
    rclcpp::QoS late(1);
    if (declare_parameter("reliable", false)) {
      late.reliable();
    } else {
      late.best_effort();
    }
    p_[7] = create_publisher<Int8>("h", late);
    group_ = create_callback_group(rclcpp::CallbackGroupType::Reentrant);
    client_ = create_client<std_srvs::srv::Empty>("i", rclcpp::ServicesQoS().keep_last(2), group_);
  }

private:
  const rclcpp::QoS member_ = rclcpp::QoS(6).transient_local();
  rclcpp::Publisher<Int8>::SharedPtr p_[8];
  rclcpp::CallbackGroup::SharedPtr group_;
  rclcpp::Client<std_srvs::srv::Empty>::SharedPtr client_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<MoreQuality>());
  rclcpp::shutdown();
}
