#ifndef BOAT_DRIVERS_SONAR_H
#define BOAT_DRIVERS_SONAR_H

#include <boat_msgs/Depth.h>
#include <ros/ros.h>
#include <sensor_msgs/Range.h>
#include <std_srvs/Trigger.h>

#include <string>

namespace boat_drivers
{

class Sonar
{
public:
  Sonar(ros::NodeHandle nh, ros::NodeHandle pnh);

private:
  void onEcho(const sensor_msgs::RangeConstPtr& echo);
  bool onPing(std_srvs::Trigger::Request& req, std_srvs::Trigger::Response& res);
  void onTimer(const ros::TimerEvent& event);

  ros::NodeHandle nh_;
  ros::Publisher depth_pub_;
  ros::Subscriber echo_sub_;
  ros::ServiceServer ping_srv_;
  ros::Timer timer_;
  std::string frame_id_;
  double last_{0.0};
};

}  // namespace boat_drivers

#endif
