#include "sonar_driver/sonar_driver.h"

namespace sonar_driver
{

SonarDriver::SonarDriver(ros::NodeHandle& nh, ros::NodeHandle& pnh)
  : nh_(nh), pnh_("~")
{
  pnh_.param("range", max_range_, 4.0);
  range_pub_ = nh_.advertise<sensor_msgs::Range>("range", 10);
  enable_sub_ = nh_.subscribe("enable", 1, &SonarDriver::enableCallback, this);
  ping_timer_ = nh_.createTimer(ros::Duration(0.1), &SonarDriver::ping, this);
}

void SonarDriver::enableCallback(const std_msgs::Bool::ConstPtr& msg)
{
  enabled_ = msg->data;
}

void SonarDriver::ping(const ros::TimerEvent& /*event*/)
{
  if (!enabled_)
    return;
  sensor_msgs::Range range;
  range.max_range = max_range_;
  range_pub_.publish(range);
}

}  // namespace sonar_driver
