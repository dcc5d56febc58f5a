#include "boat_drivers/sonar.h"

namespace boat_drivers
{

Sonar::Sonar(ros::NodeHandle nh, ros::NodeHandle pnh) : nh_(nh)
{
  pnh.param<std::string>("frame_id", frame_id_, "sonar_link");
  depth_pub_ = nh_.advertise<boat_msgs::Depth>("range", 10);
  echo_sub_ = nh_.subscribe("echo", 5, &Sonar::onEcho, this);
  ping_srv_ = nh_.advertiseService("ping", &Sonar::onPing, this);
  timer_ = nh_.createTimer(ros::Duration(0.2), &Sonar::onTimer, this);
}

void Sonar::onEcho(const sensor_msgs::RangeConstPtr& echo)
{
  last_ = echo->range;
}

bool Sonar::onPing(std_srvs::Trigger::Request& req, std_srvs::Trigger::Response& res)
{
  res.success = last_ > 0.0;
  res.message = "pong";
  return true;
}

void Sonar::onTimer(const ros::TimerEvent& event)
{
  boat_msgs::Depth depth;
  depth.header.stamp = ros::Time::now();
  depth.header.frame_id = frame_id_;
  depth.depth = last_;
  depth.beams[0] = last_;
  depth_pub_.publish(depth);
}

}  // namespace boat_drivers
