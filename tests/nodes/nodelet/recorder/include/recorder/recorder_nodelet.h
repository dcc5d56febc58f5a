#pragma once

#include <map>
#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <nav_msgs/Odometry.h>
#include <sensor_msgs/Imu.h>
#include <std_msgs/String.h>
#include <std_srvs/Trigger.h>

namespace recorder {

class RecorderNodelet : public nodelet::Nodelet
{
private:
  virtual void onInit() override;
  bool start(std_srvs::TriggerRequest&, std_srvs::TriggerResponse&);
  bool stop(std_srvs::TriggerRequest&, std_srvs::TriggerResponse&);
  void odom(const nav_msgs::OdometryConstPtr&) {}
  void imu(const sensor_msgs::ImuConstPtr&) {}

  std::map<std::string, ros::Subscriber> subscribers_;
  ros::ServiceServer start_, stop_;
  ros::Publisher state_;
};

}
