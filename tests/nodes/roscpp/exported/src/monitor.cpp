#include <exported/monitor.h>
#include <cinttypes>

namespace exported {

EXPORTED_PUBLIC
Monitor::Monitor() : private_nh_(std::make_unique<ros::NodeHandle>("~")) {
  heart_ = private_nh_->advertise<std_msgs::Header>("heart", 1);
  beats_ = nh_->subscribe("beats", 1, &Monitor::beat, this);
  wall_ = nh_->createWallTimer(ros::WallDuration(1), &Monitor::check, this);
}

void Monitor::beat(const std_msgs::UInt32::ConstPtr& n) {
  ROS_INFO("beat %" PRIu32 "%s", n->data, EXPORTED_SUFFIX);
}

void Monitor::check(const ros::WallTimerEvent&) { heart_.publish(std_msgs::Header()); }

}  // namespace exported

int main(int argc, char** argv) {
  ros::init(argc, argv, "exported");
  exported::Monitor monitor;
  ros::spin();
}
