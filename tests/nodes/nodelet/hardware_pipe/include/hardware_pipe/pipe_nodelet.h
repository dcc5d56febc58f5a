#ifndef HARDWARE_PIPE_PIPE_NODELET_H
#define HARDWARE_PIPE_PIPE_NODELET_H

#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <sensor_msgs/FluidPressure.h>
#include <std_msgs/Float64.h>
#include <std_srvs/Empty.h>

namespace hardware_pipe
{

class PipeNodelet : public nodelet::Nodelet
{
public:
  PipeNodelet() = default;

private:
  void onInit() override;
  void valveCallback(const std_msgs::Float64ConstPtr& valve);
  bool flushCallback(std_srvs::Empty::Request& req, std_srvs::Empty::Response& res);
  void timerCallback(const ros::TimerEvent& event);

  ros::NodeHandle nh_;
  ros::NodeHandle private_nh_;
  ros::Publisher pressure_pub_;
  ros::Subscriber valve_sub_;
  ros::ServiceServer flush_srv_;
  ros::Timer timer_;
  int rate_;
  double opening_ = 0.0;
};

}  // namespace hardware_pipe

#endif
