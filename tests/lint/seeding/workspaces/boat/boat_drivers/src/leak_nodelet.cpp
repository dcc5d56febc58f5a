#include <nodelet/nodelet.h>
#include <pluginlib/class_list_macros.h>
#include <ros/ros.h>
#include <std_msgs/Bool.h>
#include <std_msgs/Float64.h>

#include <boost/bind.hpp>

namespace boat_drivers
{

class LeakNodelet : public nodelet::Nodelet
{
  virtual void onInit()
  {
    ros::NodeHandle& nh = getNodeHandle();
    ros::NodeHandle& private_nh = getPrivateNodeHandle();
    private_nh.param("threshold", threshold_, 0.8);
    pub_ = nh.advertise<std_msgs::Bool>("leak", 1, true);
    sub_ = nh.subscribe<std_msgs::Float64>("leak/voltage", 10, boost::bind(&LeakNodelet::onVoltage, this, _1));
  }

  void onVoltage(const std_msgs::Float64ConstPtr& voltage)
  {
    std_msgs::Bool leak;
    leak.data = voltage->data > threshold_;
    pub_.publish(leak);
  }

  double threshold_;
  ros::Publisher pub_;
  ros::Subscriber sub_;
};

}  // namespace boat_drivers

PLUGINLIB_EXPORT_CLASS(boat_drivers::LeakNodelet, nodelet::Nodelet)
