#include <ros/ros.h>
#include <nav_msgs/Odometry.h>
#include <geometry_msgs/PoseStamped.h>

void odomCb(const nav_msgs::Odometry&) {}
void poseCb(const geometry_msgs::PoseStamped&) {}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "conditional");
  ros::NodeHandle nh, pnh("~");
  bool use_odom, sim;
  pnh.param("use_odom", use_odom, true);
  ros::param::param<bool>("/use_sim_time", sim, false);
  ros::Subscriber sub = use_odom ? nh.subscribe("odom", 1, odomCb) : nh.subscribe("pose", 1, poseCb);
  ros::Publisher pub = nh.advertise<nav_msgs::Odometry>(sim ? "sim/odom" : "real/odom", 1);
  std::string topic = "first";
  if (sim)
    topic = "second";
  ros::Publisher changed = nh.advertise<nav_msgs::Odometry>(topic, 1);
  if (ros::Publisher early = nh.advertise<nav_msgs::Odometry>("early", 1); early)
    early.publish(nav_msgs::Odometry());
  switch (argc)
  {
    case 1:
      pub = nh.advertise<nav_msgs::Odometry>("one", 1);
      break;
    default:
      break;
  }
  ros::spin();
}
