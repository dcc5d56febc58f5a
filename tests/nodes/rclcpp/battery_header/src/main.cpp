#include "battery_header/battery.hpp"

int main(int argc, char* argv[]) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Battery>("battery"));
  rclcpp::shutdown();
}
