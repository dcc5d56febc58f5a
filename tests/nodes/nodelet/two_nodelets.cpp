#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <pluginlib/class_list_macros.hpp>
#include <std_msgs/Time.h>

namespace pair
{

class Ping : public nodelet::Nodelet
{
  ros::Publisher pub_;
  ros::Timer timer_;

  void onInit() override
  {
    pub_ = getNodeHandle().advertise<std_msgs::Time>("ping", 1);
    timer_ = getNodeHandle().createTimer(ros::Rate(2), &Ping::onTimer, this);
  }

  void onTimer(const ros::TimerEvent& event)
  {
    std_msgs::Time now;
    now.data = event.current_real;
    pub_.publish(now);
  }
};

class Pong : public nodelet::Nodelet
{
  ros::Publisher pub_;
  ros::Subscriber sub_;

  void onInit() override
  {
    pub_ = getNodeHandle().advertise<std_msgs::Time>("pong", 1);
    sub_ = getNodeHandle().subscribe("ping", 1, &Pong::onPing, this);
  }

  void onPing(const std_msgs::TimeConstPtr& ping) { pub_.publish(ping); }
};

}  // namespace pair

PLUGINLIB_EXPORT_CLASS(pair::Ping, nodelet::Nodelet)
PLUGINLIB_EXPORT_CLASS(pair::Pong, nodelet::Nodelet)
