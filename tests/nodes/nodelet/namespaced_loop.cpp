#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <pluginlib/class_list_macros.hpp>
#include <sensor_msgs/Range.h>
#include <array>
#include <vector>

static const char* const SENSORS[] = {"front", "rear"};

class Multi : public nodelet::Nodelet
{
  std::vector<ros::Subscriber> subs_;
  std::vector<ros::Publisher> pubs_;
  ros::Publisher nearest_;

  void onInit()
  {
    ros::NodeHandle nh(getNodeHandle(), "ranges");
    nearest_ = nh.advertise<sensor_msgs::Range>("nearest", 1);
    for (const char* name : SENSORS)
      subs_.push_back(nh.subscribe(name, 1, &Multi::range, this));
    for (const std::string& name : {"a", "b", "c"}) {
      pubs_.emplace_back(nh.advertise<sensor_msgs::Range>("copy_" + name, 1));
    }
  }

  void range(const sensor_msgs::Range::ConstPtr& r) { nearest_.publish(r); }
};

PLUGINLIB_EXPORT_CLASS(Multi, nodelet::Nodelet)
