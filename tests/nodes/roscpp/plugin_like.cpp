// Something that a simulator loads; the node is the simulator's.
#include <ros/advertise_options.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <ros/subscribe_options.h>

#include <boost/thread.hpp>
#include <geometry_msgs/Wrench.h>
#include <sensor_msgs/JointState.h>

class PluginLike {
 public:
  void Load(const std::string& robot_namespace) {
    if (!ros::isInitialized()) {
      ROS_FATAL_STREAM("A ROS node has not been initialized");
      return;
    }
    node_ = new ros::NodeHandle(robot_namespace);
    ros::SubscribeOptions so = ros::SubscribeOptions::create<geometry_msgs::Wrench>(
        topic_, 1, boost::bind(&PluginLike::OnWrench, this, boost::placeholders::_1), ros::VoidPtr(), &queue_);
    sub_ = node_->subscribe(so);
    ros::AdvertiseOptions ao = ros::AdvertiseOptions::create<sensor_msgs::JointState>(
        "/joint_states", 1, ros::SubscriberStatusCallback(), ros::SubscriberStatusCallback(), ros::VoidPtr(), NULL);
    pub_ = node_->advertise(ao);
  }

 private:
  void OnWrench(const geometry_msgs::Wrench::ConstPtr& wrench) { wrench_ = *wrench; }

  ros::NodeHandle* node_ = nullptr;
  std::string topic_{"wrench"};
  ros::CallbackQueue queue_;
  ros::Subscriber sub_;
  ros::Publisher pub_;
  geometry_msgs::Wrench wrench_;
};
