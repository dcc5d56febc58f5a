#pragma once
#include <ros/ros.h>
#include <std_msgs/Float32.h>

class Side
{
public:
  explicit Side(const std::string& name)
    : pub_(nh_.advertise<std_msgs::Float32>(name + "/speed", 1))
    , sub_(nh_.subscribe(name + "/goal", 1, &Side::goal, this))
  {
  }

private:
  void goal(const std_msgs::Float32ConstPtr& msg) { pub_.publish(msg); }

  ros::NodeHandle nh_;
  ros::Publisher pub_;
  ros::Subscriber sub_;
};
