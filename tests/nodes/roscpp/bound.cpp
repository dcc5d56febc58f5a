#include <boost/bind/bind.hpp>
#include <functional>
#include <ros/ros.h>
#include <sensor_msgs/Joy.h>
#include <std_msgs/Float32.h>
#include <std_srvs/Empty.h>

using namespace boost::placeholders;

class Arms
{
public:
  explicit Arms(ros::NodeHandle & nh)
  {
    left_ = nh.subscribe<std_msgs::Float32>("left", 1, boost::bind(&Arms::onArm, this, _1, 0));
    right_ = nh.subscribe<std_msgs::Float32>("right", 1, boost::bind(&Arms::onArm, this, boost::placeholders::_1, 1));
    joy_ = nh.subscribe<sensor_msgs::Joy>("joy", 1, std::bind(&Arms::onJoy, this, std::placeholders::_1));
    reset_ = nh.advertiseService<std_srvs::Empty::Request, std_srvs::Empty::Response>(
      "reset", boost::bind(&Arms::onReset, this, _1, _2));
    tick_ = nh.createTimer(ros::Duration(1.0 / 50), boost::bind(&Arms::onTick, this, _1));
  }

private:
  void onArm(const std_msgs::Float32::ConstPtr & msg, int side) { at_[side] = msg->data; }
  void onJoy(const sensor_msgs::Joy::ConstPtr &) {}
  bool onReset(std_srvs::Empty::Request &, std_srvs::Empty::Response &) { return true; }
  void onTick(const ros::TimerEvent &) {}

  float at_[2] = {0, 0};
  ros::Subscriber left_, right_, joy_;
  ros::ServiceServer reset_;
  ros::Timer tick_;
};

int main(int argc, char ** argv)
{
  ros::init(argc, argv, "bound");
  ros::NodeHandle nh;
  Arms arms(nh);
  ros::spin();
}
