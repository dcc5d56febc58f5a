#ifndef EXPORTED_MONITOR_H
#define EXPORTED_MONITOR_H
#include <memory>
#include <ros/ros.h>
#include <std_msgs/Header.h>
#include <std_msgs/UInt32.h>
#include "exported/visibility.h"

namespace exported {
class EXPORTED_PUBLIC Monitor {
 public:
  EXPORTED_PUBLIC Monitor();
  EXPORTED_LOCAL void beat(const std_msgs::UInt32::ConstPtr& n);
  EXPORTED_LOCAL void check(const ros::WallTimerEvent& event);

 private:
  std::shared_ptr<ros::NodeHandle> nh_ = std::make_shared<ros::NodeHandle>();
  std::unique_ptr<ros::NodeHandle> private_nh_;
  ros::Publisher heart_;
  ros::Subscriber beats_;
  ros::WallTimer wall_;
};
}  // namespace exported
#endif
