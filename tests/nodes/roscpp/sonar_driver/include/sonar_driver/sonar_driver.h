#ifndef SONAR_DRIVER_SONAR_DRIVER_H
#define SONAR_DRIVER_SONAR_DRIVER_H

#include <ros/ros.h>
#include <sensor_msgs/Range.h>
#include <std_msgs/Bool.h>

namespace sonar_driver
{

class SonarDriver
{
public:
  SonarDriver(ros::NodeHandle& nh, ros::NodeHandle& pnh);

private:
  void enableCallback(const std_msgs::Bool::ConstPtr& msg);
  void ping(const ros::TimerEvent& event);

  ros::NodeHandle nh_;
  ros::NodeHandle pnh_;
  ros::Publisher range_pub_;
  ros::Subscriber enable_sub_;
  ros::Timer ping_timer_;
  double max_range_;
  bool enabled_ = true;
};

}  // namespace sonar_driver

#endif
