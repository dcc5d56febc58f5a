#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/string.hpp>
#include <std_srvs/srv/trigger.hpp>

using namespace std::literals;

struct Lambdas : rclcpp::Node {
    Lambdas() : Node{"lambdas"} {
        auto on_text = [this](std_msgs::msg::String::UniquePtr msg) { last = msg->data; };
        sub = create_subscription<std_msgs::msg::String>("text", 10, on_text);
        other = create_subscription<std_msgs::msg::String>(
            "other", 10, [this](const std_msgs::msg::String& msg) {
                last = msg.data;
            });
        srv = create_service<std_srvs::srv::Trigger>("what",
            [this](std_srvs::srv::Trigger::Request::SharedPtr, std_srvs::srv::Trigger::Response::SharedPtr res) {
                res->success = true;
                res->message = last;
            });
        timer = create_wall_timer(1min, [this] { RCLCPP_INFO_STREAM(get_logger(), last); });
        quick = create_wall_timer(250us, [] {});
    }

    std::string last;
    rclcpp::SubscriptionBase::SharedPtr sub, other;
    rclcpp::ServiceBase::SharedPtr srv;
    rclcpp::TimerBase::SharedPtr timer, quick;
};

int main(int argc, char** argv) {
    rclcpp::init(argc, argv);
    rclcpp::spin(std::make_shared<Lambdas>());
    rclcpp::shutdown();
}
