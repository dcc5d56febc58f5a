#include "recorder/recorder_nodelet.h"
#include <pluginlib/class_list_macros.hpp>

PLUGINLIB_EXPORT_CLASS(recorder::RecorderNodelet, nodelet::Nodelet)

namespace recorder {

void RecorderNodelet::onInit()
{
  start_ = getPrivateNodeHandle().advertiseService("start", &RecorderNodelet::start, this);
  stop_ = getPrivateNodeHandle().advertiseService("stop", &RecorderNodelet::stop, this);
  state_ = getPrivateNodeHandle().advertise<std_msgs::String>("state", 1, true);
}

bool RecorderNodelet::start(std_srvs::TriggerRequest&, std_srvs::TriggerResponse& response)
{
  subscribers_["odom"] = getNodeHandle().subscribe("odom", 10, &RecorderNodelet::odom, this);
  subscribers_["imu"] = getNodeHandle().subscribe("imu", 10, &RecorderNodelet::imu, this);
  response.success = true;
  return true;
}

bool RecorderNodelet::stop(std_srvs::TriggerRequest&, std_srvs::TriggerResponse& response)
{
  subscribers_.clear();
  return response.success = true;
}

}
