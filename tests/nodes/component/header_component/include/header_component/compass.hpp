#pragma once
#include <rclcpp/rclcpp.hpp>
#include <sensor_msgs/msg/magnetic_field.hpp>
#include <std_msgs/msg/float64.hpp>

namespace header_component {

class Compass : public rclcpp::Node {
public:
    explicit Compass(const rclcpp::NodeOptions &options) : Node("compass", options) {
        heading_ = create_publisher<std_msgs::msg::Float64>("heading", 10);
        field_ = create_subscription<sensor_msgs::msg::MagneticField>("field", 10, [this](const sensor_msgs::msg::MagneticField &f) { onField(f); });
    }

private:
    void onField(const sensor_msgs::msg::MagneticField &) { heading_->publish(std_msgs::msg::Float64()); }
    rclcpp::Publisher<std_msgs::msg::Float64>::SharedPtr heading_;
    rclcpp::Subscription<sensor_msgs::msg::MagneticField>::SharedPtr field_;
};

}
