#ifndef RADIO_RADIO_H
#define RADIO_RADIO_H

#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <std_msgs/String.h>

namespace radio
{

class Radio : public nodelet::Nodelet
{
public:
  Radio();
  ~Radio() override;

private:
  void onInit() override;
  void sendCallback(const std_msgs::String::ConstPtr& text);

  ros::Subscriber send_;
  ros::Publisher received_;
  int power_;
};

}

#endif
