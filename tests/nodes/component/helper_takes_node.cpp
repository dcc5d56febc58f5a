// für Grüße: ein Knoten mit Helfer (µs)
#include <rclcpp/rclcpp.hpp>
#include <rclcpp_components/register_node_macro.hpp>
#include <std_msgs/msg/byte.hpp>

class Helper {
public:
    explicit Helper(rclcpp::Node& node) : node_(node) {
        pub_ = node_.create_publisher<std_msgs::msg::Byte>("helped/out", 1); // »raus«
        timer_ = node.create_wall_timer(std::chrono::milliseconds(50), [this]() { pub_->publish(std_msgs::msg::Byte()); });
    }

private:
    rclcpp::Node& node_;
    rclcpp::Publisher<std_msgs::msg::Byte>::SharedPtr pub_;
    rclcpp::TimerBase::SharedPtr timer_;
};

class Helped : public rclcpp::Node {
public:
    explicit Helped(const rclcpp::NodeOptions& options) : Node("helped", options), helper_(*this) {}

private:
    Helper helper_;
};

RCLCPP_COMPONENTS_REGISTER_NODE(Helped)
