#include <ros/ros.h>
#include <ros/topic.h>
#include <sensor_msgs/CameraInfo.h>
#include <std_srvs/Empty.h>
#include <nav_msgs/OccupancyGrid.h>

int main(int argc, char** argv)
{
  ros::init(argc, argv, "waits");
  ros::NodeHandle nh;

  sensor_msgs::CameraInfoConstPtr info = ros::topic::waitForMessage<sensor_msgs::CameraInfo>("camera_info", nh, ros::Duration(5));
  auto map = ros::topic::waitForMessage<nav_msgs::OccupancyGrid>("map");
  if (!info || !map)
    return 1;

  std_srvs::Empty empty;
  if (!ros::service::waitForService("start", 1000))
    return 2;
  ros::service::call("start", empty);
  return 0;
}
