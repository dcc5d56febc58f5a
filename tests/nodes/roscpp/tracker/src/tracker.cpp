// Set up of the tracker; what it does with detections is in callbacks.cpp.
#include "tracker/tracker.h"

namespace tracker {

Tracker::Tracker(const ros::NodeHandle& nh) : nh_(nh) {
  detections_sub_ = nh_.subscribe("detections", 5, &Tracker::OnDetections, this);
  reset_sub_ = nh_.subscribe(kReset, 1, &Tracker::OnReset, this);
  tracks_pub_ = nh_.advertise<PoseArray>("tracks", 5);
  reset_srv_ = nh_.advertiseService("reset_tracks", &Tracker::OnResetService, this);
}

}  // namespace tracker

int main(int argc, char** argv) {
  ros::init(argc, argv, "tracker");
  tracker::Tracker tracker{ros::NodeHandle()};
  ros::spin();
}
