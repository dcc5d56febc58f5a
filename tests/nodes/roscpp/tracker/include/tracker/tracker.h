#ifndef TRACKER_TRACKER_H_
#define TRACKER_TRACKER_H_

#include <geometry_msgs/PoseArray.h>
#include <ros/ros.h>
#include <std_msgs/Empty.h>
#include <std_srvs/Trigger.h>

namespace tracker {

using geometry_msgs::PoseArray;

class Tracker {
 public:
  explicit Tracker(const ros::NodeHandle& nh);
  Tracker(const Tracker&) = delete;

 private:
  static constexpr const char* kReset = "reset";

  void OnDetections(const PoseArray::ConstPtr& detections);
  void OnReset(const std_msgs::EmptyConstPtr& empty);
  bool OnResetService(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);

  ros::NodeHandle nh_;
  ros::Subscriber detections_sub_;
  ros::Subscriber reset_sub_;
  ros::Publisher tracks_pub_;
  ros::ServiceServer reset_srv_;
  PoseArray tracks_;
};

}  // namespace tracker

#endif  // TRACKER_TRACKER_H_
