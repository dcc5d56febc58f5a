#pragma once

#include <nav_msgs/Path.h>
#include <ros/ros.h>

namespace planners
{
class PlannerBase
{
public:
  explicit PlannerBase(const std::string& name) : pnh_("~"), name_(name)
  {
    path_pub_ = nh_.advertise<nav_msgs::Path>("path", 1);
  }
  virtual ~PlannerBase() = default;

protected:
  ros::NodeHandle nh_;
  ros::NodeHandle pnh_;
  ros::Publisher path_pub_;
  std::string name_;
};
}  // namespace planners
