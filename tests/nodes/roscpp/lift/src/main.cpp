#include <ros/ros.h>
#include "lift/topics.h"
#include <std_msgs/UInt8.h>
#include <std_msgs/Float64.h>

static void floorCallback(const std_msgs::UInt8::ConstPtr&) {}

int main(int argc, char** argv)
{
  ros::init(argc, argv, lift::NODE);
  ros::NodeHandle nh;
  ros::Subscriber sub = nh.subscribe(lift::topics::FLOOR, 1, floorCallback);
  ros::Publisher height = nh.advertise<std_msgs::Float64>(lift::topics::HEIGHT, lift::QUEUE);
  ros::Publisher load = nh.advertise<std_msgs::Float64>(LIFT_LOAD_TOPIC, 1);
  ros::spin();
}
