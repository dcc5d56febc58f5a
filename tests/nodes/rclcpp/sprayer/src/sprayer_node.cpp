#include "sprayer/sprayer.hpp"

int main(int argc, char * argv[])
{
  rclcpp::init(argc, argv);
  auto options = rclcpp::NodeOptions().automatically_declare_parameters_from_overrides(false);
  auto node = std::make_shared<Sprayer>("sprayer", options);
  rclcpp::spin(node);
  rclcpp::shutdown();
}

Sprayer::Sprayer(const std::string & name, const rclcpp::NodeOptions & options)
: rclcpp::Node(name, options)
{
  tank_ = create_publisher<Level>("tank", qos_);
  for (int i = 0; i < 3; i++) {
    nozzles_.push_back(
      create_subscription<Level>(
        "nozzle/" + std::to_string(i), qos_, std::bind(&Sprayer::nozzle, this, std::placeholders::_1)));
  }
}

void Sprayer::nozzle(Level::ConstSharedPtr level) {tank_->publish(*level);}
