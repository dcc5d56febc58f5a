#include "localizer/localizer.hpp"

Localizer::Localizer() : rclcpp::Node("localizer")
{
    odom_ = create_subscription<Twist>(topics::ODOM, 10, std::bind(&Localizer::odom, this, std::placeholders::_1));
    fix_ = create_subscription<NavSatFix>(topics::FIX, rclcpp::SensorDataQoS(), std::bind(&Localizer::fix, this, std::placeholders::_1));
    pose_ = create_publisher<Pose>(LOCALIZER_POSE, 10);
    reset_ = create_client<std_srvs::srv::Trigger>("imu/reset");
}

int main(int argc, char **argv)
{
    rclcpp::init(argc, argv);
    rclcpp::spin(std::make_shared<Localizer>());
    rclcpp::shutdown();
}
