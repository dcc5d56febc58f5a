#include <memory>
#include <thread>
#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <pluginlib/class_list_macros.hpp>
#include <sensor_msgs/NavSatFix.h>
#include <std_srvs/Trigger.h>

class Deferred : public nodelet::Nodelet
{
  std::shared_ptr<std::thread> deferred_thread_;
  ros::Timer init_timer_;
  ros::Publisher fix_pub_;
  ros::Subscriber raw_sub_;
  ros::ServiceServer restart_srv_;

  void onInit() override
  {
    init_timer_ = getNodeHandle().createTimer(ros::Duration(0.1), boost::bind(&Deferred::deferredInit, this), true);
  }

  void deferredInit()
  {
    ros::NodeHandle nh{getNodeHandle(), "gps"}, pnh{getPrivateNodeHandle()};
    int rate = pnh.param<int>("rate", 5);
    NODELET_INFO("rate: %i", rate);
    fix_pub_ = nh.advertise<sensor_msgs::NavSatFix>("fix", 1);
    raw_sub_ = nh.subscribe("raw", 1, &Deferred::raw, this);
    restart_srv_ = pnh.advertiseService("restart", &Deferred::restart, this);
  }

  void raw(sensor_msgs::NavSatFixConstPtr fix) { fix_pub_.publish(fix); }
  bool restart(std_srvs::TriggerRequest&, std_srvs::TriggerResponse&) { return true; }
};

PLUGINLIB_EXPORT_CLASS(Deferred, nodelet::Nodelet)
