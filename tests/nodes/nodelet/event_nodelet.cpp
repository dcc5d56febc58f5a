#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <pluginlib/class_list_macros.hpp>
#include <ros/callback_queue.h>
#include <geometry_msgs/Polygon.h>

class Events : public nodelet::Nodelet {
  ros::Subscriber any_, typed_;
  ros::Publisher loud_;
  ros::CallbackQueue queue_;
  void onInit() {
    NODELET_INFO("Initialise %s", getName().c_str());
    any_ = getNodeHandle().subscribe("any", 1, &Events::any, this);
    ros::SubscribeOptions options; options.initByFullCallbackType<const geometry_msgs::Polygon&>("full", 1, boost::bind(&Events::full, this, boost::placeholders::_1));
    typed_ = getNodeHandle().subscribe(options);
  }
  void any(const ros::MessageEvent<geometry_msgs::Polygon const>& event) {}
  void full(const geometry_msgs::Polygon& shape) {}
};
PLUGINLIB_EXPORT_CLASS(Events, nodelet::Nodelet)
