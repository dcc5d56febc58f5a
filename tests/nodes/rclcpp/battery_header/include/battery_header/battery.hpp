#ifndef BATTERY_HPP
#define BATTERY_HPP

#include <rclcpp/rclcpp.hpp>
#include <sensor_msgs/msg/battery_state.hpp>

class Battery : public rclcpp::Node {
 public:
  Battery(const std::string& name) : Node(name) {
    using namespace std::chrono_literals;
    pub_ = create_publisher<sensor_msgs::msg::BatteryState>("battery_state", 1);
    timer_ = create_wall_timer(5s, std::bind(&Battery::Tick, this));
  }

 private:
  void Tick() { pub_->publish(sensor_msgs::msg::BatteryState{}); }

  rclcpp::Publisher<sensor_msgs::msg::BatteryState>::SharedPtr pub_;
  rclcpp::TimerBase::SharedPtr timer_;
};

#endif
