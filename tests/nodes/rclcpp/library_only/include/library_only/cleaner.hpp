#pragma once
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/float32.hpp>
#include <std_srvs/srv/set_bool.hpp>

namespace library_only
{
class Cleaner : public rclcpp::Node
{
public:
    explicit Cleaner(const rclcpp::NodeOptions &opts = {});

private:
    void dirt(std_msgs::msg::Float32::UniquePtr msg);

    rclcpp::Publisher<std_msgs::msg::Float32>::SharedPtr brush_;
    rclcpp::Subscription<std_msgs::msg::Float32>::SharedPtr dirt_;
    rclcpp::Client<std_srvs::srv::SetBool>::SharedPtr dock_;
};
}
