#ifndef JOY_MUX_MUX_H
#define JOY_MUX_MUX_H

#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <sensor_msgs/Joy.h>
#include <std_srvs/SetBool.h>

namespace joy_mux
{

static const char DEFAULT_BASE[] = "base";

class Mux : public nodelet::Nodelet
{
public:
  void onInit() override;

private:
  void pick(const sensor_msgs::Joy::ConstPtr & joy, int side);

  ros::Subscriber left_;
  ros::Subscriber right_;
  ros::Publisher out_;
  ros::ServiceClient select_;
};

}

#endif
