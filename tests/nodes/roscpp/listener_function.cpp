#include <ros/ros.h>
#include <std_msgs/String.h>
#include <std_msgs/Int32.h>
#include <nav_msgs/Odometry.h>

void chatterCallback(const std_msgs::String::ConstPtr& msg)
{
  ROS_INFO("heard [%s]", msg->data.c_str());
}

void onCount(const std_msgs::Int32& count)
{
  ROS_INFO_STREAM("count " << count.data);
}

void onOdom(const nav_msgs::OdometryConstPtr& odom)
{
  ROS_DEBUG("x = %f", odom->pose.pose.position.x);
}

void onName(boost::shared_ptr<std_msgs::String const> name) { ROS_INFO("%s", name->data.c_str()); }

int main(int argc, char** argv)
{
  ros::init(argc, argv, "listener", ros::init_options::AnonymousName);
  ros::NodeHandle nh;
  ros::Subscriber a = nh.subscribe("chatter", 1000, chatterCallback);
  ros::Subscriber b = nh.subscribe("count", 1, &onCount);
  ros::Subscriber c = nh.subscribe<nav_msgs::Odometry>("/odom", 1, onOdom, ros::TransportHints().tcpNoDelay());
  ros::Subscriber d = nh.subscribe("name", 1, ::onName);
  ros::spin();
}
