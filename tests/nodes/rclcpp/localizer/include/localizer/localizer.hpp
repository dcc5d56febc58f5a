#pragma once
#include <geometry_msgs/msg/pose_with_covariance_stamped.hpp>
#include <geometry_msgs/msg/twist_stamped.hpp>
#include <rclcpp/rclcpp.hpp>
#include <sensor_msgs/msg/nav_sat_fix.hpp>
#include <std_srvs/srv/trigger.hpp>

#include "localizer/topics.hpp"

class Localizer : public rclcpp::Node
{
public:
    Localizer();

private:
    using Pose = geometry_msgs::msg::PoseWithCovarianceStamped;
    using Twist = geometry_msgs::msg::TwistStamped;
    using NavSatFix = sensor_msgs::msg::NavSatFix;

    void odom(Twist::ConstSharedPtr twist);
    void fix(NavSatFix::ConstSharedPtr fix);

    rclcpp::Subscription<Twist>::SharedPtr odom_;
    rclcpp::Subscription<NavSatFix>::SharedPtr fix_;
    rclcpp::Publisher<Pose>::SharedPtr pose_;
    rclcpp::Client<std_srvs::srv::Trigger>::SharedPtr reset_;
};
