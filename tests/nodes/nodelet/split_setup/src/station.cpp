#include "split_setup/station.h"
#include <pluginlib/class_list_macros.hpp>
PLUGINLIB_EXPORT_CLASS(split_setup::Station, nodelet::Nodelet)

namespace split_setup
{
void Station::onInit()
{
  NODELET_INFO("station");
  readParameters();
  createPublishers();
  createSubscribers();
}

void Station::readParameters()
{
  ros::NodeHandle private_handle = getPrivateNodeHandle();
  if (!private_handle.getParam("name", name_))
  {
    NODELET_WARN("no name");
  }
  hz_ = private_handle.param("hz", 5.0);
}

void Station::createPublishers()
{
  weather_ = getNodeHandle().advertise<sensor_msgs::Temperature>("weather", 1);
  humid_ = getNodeHandle().advertise<sensor_msgs::RelativeHumidity>("humidity", 1);
}

void Station::createSubscribers()
{
  wind_ = getNodeHandle().subscribe(wind_topic_, 1, &Station::windCb, this);
  timer_ = getNodeHandle().createTimer(ros::Duration(1.0 / hz_), &Station::timerCb, this);
}
}  // namespace split_setup
