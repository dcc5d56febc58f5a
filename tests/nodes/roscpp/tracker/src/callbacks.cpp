#include "tracker/tracker.h"

namespace tracker {

void Tracker::OnDetections(const PoseArray::ConstPtr& detections) {
  tracks_ = *detections;
  tracks_pub_.publish(tracks_);
}

void Tracker::OnReset(const std_msgs::EmptyConstPtr&) { tracks_.poses.clear(); }

bool Tracker::OnResetService(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
  tracks_.poses.clear();
  response.success = true;
  return true;
}

}  // namespace tracker
