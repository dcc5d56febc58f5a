#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/bool.hpp>
#include <std_msgs/msg/string.hpp>

class RobotNode : public rclcpp::Node {
public:
    explicit RobotNode(const std::string& name) : rclcpp::Node(name) {
        status_ = create_publisher<std_msgs::msg::String>("~/status", 10);
    }
    virtual ~RobotNode() = default;

protected:
    rclcpp::Publisher<std_msgs::msg::String>::SharedPtr status_;
};

class Mower : public RobotNode {
public:
    Mower() : RobotNode("mower") {
        blade_ = create_subscription<std_msgs::msg::Bool>("blade", 1, [this](const std_msgs::msg::Bool&) {
            status_->publish(std_msgs::msg::String{});
        });
    }

private:
    rclcpp::Subscription<std_msgs::msg::Bool>::SharedPtr blade_;
};

int main(int argc, char** argv) {
    rclcpp::init(argc, argv);
    rclcpp::spin(std::make_shared<Mower>());
    rclcpp::shutdown();
}
