#include <ros/ros.h>

#include "header_only/blinker.h"

int main(int argc, char** argv)
{
  ros::init(argc, argv, "header_only");
  ros::NodeHandle nh;
  Blinker blinker(nh);
  ros::Publisher version = nh.advertise<std_msgs::String>("version", 1, true);
  ros::spin();
}
