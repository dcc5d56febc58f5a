#include <rclcpp/rclcpp.hpp>
#include <geometry_msgs/msg/twist.hpp>
#include <geometry_msgs/msg/twist_stamped.hpp>

class Conditional : public rclcpp::Node {
public:
    Conditional() : Node("conditional") {
        const bool stamped = declare_parameter("stamped", false);
        if (stamped) {
            stamped_ = create_publisher<geometry_msgs::msg::TwistStamped>("cmd_vel", 1);
        } else {
            plain_ = create_publisher<geometry_msgs::msg::Twist>("cmd_vel", 1);
        }
        other_ = create_publisher<geometry_msgs::msg::Twist>(stamped ? "a" : "b", 1);
        sub_ = stamped ? nullptr : create_subscription<geometry_msgs::msg::Twist>("in", 1, [](const geometry_msgs::msg::Twist&) {});
        if (auto late = create_publisher<geometry_msgs::msg::Twist>("late", 1); late) late->publish(geometry_msgs::msg::Twist());
    }

private:
    rclcpp::Publisher<geometry_msgs::msg::TwistStamped>::SharedPtr stamped_;
    rclcpp::Publisher<geometry_msgs::msg::Twist>::SharedPtr plain_, other_;
    rclcpp::Subscription<geometry_msgs::msg::Twist>::SharedPtr sub_;
};

int main(int argc, char** argv) {
    rclcpp::init(argc, argv);
    rclcpp::spin(std::make_shared<Conditional>());
    rclcpp::shutdown();
}
