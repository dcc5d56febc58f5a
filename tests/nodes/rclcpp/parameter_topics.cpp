#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/string.hpp>

class Relay : public rclcpp::Node {
public:
    Relay() : rclcpp::Node("relay") {
        declare_parameter<std::string>("input", "chatter");
        std::string input, output;
        get_parameter("input", input);
        output = declare_parameter("output", "relayed");
        const auto third = get_parameter("input").as_string();
        pub_ = create_publisher<std_msgs::msg::String>(output, 10);
        sub_ = create_subscription<std_msgs::msg::String>(input, 10, std::bind(&Relay::on, this, std::placeholders::_1));
        copy_ = create_publisher<std_msgs::msg::String>(third + "/copy", 10);
    }

private:
    void on(const std_msgs::msg::String& m) { pub_->publish(m); copy_->publish(m); }
    rclcpp::Publisher<std_msgs::msg::String>::SharedPtr pub_, copy_;
    rclcpp::Subscription<std_msgs::msg::String>::SharedPtr sub_;
};

int main(int argc, char** argv) {
    rclcpp::init(argc, argv);
    rclcpp::spin(std::make_shared<Relay>());
    rclcpp::shutdown();
}
