#include "hardware_pipe/pipe_nodelet.h"

#include <pluginlib/class_list_macros.hpp>

namespace hardware_pipe
{

void PipeNodelet::onInit()
{
  nh_ = getNodeHandle();
  private_nh_ = getPrivateNodeHandle();

  private_nh_.param<int>("rate", rate_, 10);
  pressure_pub_ = nh_.advertise<sensor_msgs::FluidPressure>("pressure", 2);
  valve_sub_ = nh_.subscribe("valve", 2, &PipeNodelet::valveCallback, this);
  flush_srv_ = private_nh_.advertiseService("flush", &PipeNodelet::flushCallback, this);
  timer_ = nh_.createTimer(ros::Duration(0.1), &PipeNodelet::timerCallback, this);
}

void PipeNodelet::valveCallback(const std_msgs::Float64ConstPtr& valve)
{
  opening_ = valve->data;
}

bool PipeNodelet::flushCallback(std_srvs::Empty::Request&, std_srvs::Empty::Response&)
{
  opening_ = 1.0;
  return true;
}

void PipeNodelet::timerCallback(const ros::TimerEvent&)
{
  pressure_pub_.publish(sensor_msgs::FluidPressure());
}

}  // namespace hardware_pipe

PLUGINLIB_EXPORT_CLASS(hardware_pipe::PipeNodelet, nodelet::Nodelet)
