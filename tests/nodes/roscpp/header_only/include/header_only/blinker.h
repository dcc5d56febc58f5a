#ifndef BLINKER_H
#define BLINKER_H

#include <ros/ros.h>
#include <std_msgs/Bool.h>
#include <std_msgs/String.h>

class Blinker
{
public:
  explicit Blinker(ros::NodeHandle& nh)
  {
    led_ = nh.advertise<std_msgs::Bool>("led", 1);
    on_ = nh.subscribe("on", 1, &Blinker::on, this);
    timer_ = nh.createTimer(ros::Duration(0.5), &Blinker::blink, this);
  }

private:
  void on(const std_msgs::Bool& m) { is_on_ = m.data; }
  void blink(const ros::TimerEvent&)
  {
    std_msgs::Bool m;
    m.data = is_on_ && (lit_ = !lit_);
    led_.publish(m);
  }

  ros::Publisher led_;
  ros::Subscriber on_;
  ros::Timer timer_;
  bool is_on_ = true, lit_ = false;
};

#endif
