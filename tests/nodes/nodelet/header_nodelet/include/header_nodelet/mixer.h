#ifndef HEADER_NODELET_MIXER_H_
#define HEADER_NODELET_MIXER_H_

#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <std_msgs/Float32MultiArray.h>

namespace header_nodelet {

class Mixer : public nodelet::Nodelet {
 public:
  void onInit() override {
    in_ = getNodeHandle().subscribe("channels", 8, &Mixer::OnChannels, this);
    out_ = getNodeHandle().advertise<std_msgs::Float32MultiArray>("mixed", 8);
  }

 private:
  void OnChannels(const std_msgs::Float32MultiArrayConstPtr& c) { out_.publish(c); }

  ros::Subscriber in_;
  ros::Publisher out_;
};

}  // namespace header_nodelet

#endif
