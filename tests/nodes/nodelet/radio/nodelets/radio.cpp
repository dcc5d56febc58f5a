#include "radio/radio.h"
#include "radio/names.h"
#include <pluginlib/class_list_macros.hpp>

PLUGINLIB_EXPORT_CLASS(radio::Radio, nodelet::Nodelet)

radio::Radio::Radio() : power_(0) {}
radio::Radio::~Radio() = default;

void radio::Radio::onInit()
{
  ros::NodeHandle radio_nh(getNodeHandle(), names::ns);
  send_ = radio_nh.subscribe(names::send, 10, &Radio::sendCallback, this);
  received_ = radio_nh.advertise<std_msgs::String>(names::received, 10);
  if (!getPrivateNodeHandle().getParam("power", power_))
    NODELET_WARN_STREAM("power is " << power_);
}

void radio::Radio::sendCallback(const std_msgs::String::ConstPtr& text)
{
  received_.publish(text);
}
