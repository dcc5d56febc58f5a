#pragma once

#include <geometry_msgs/Twist.h>
#include <ros/ros.h>
#include <sensor_msgs/Joy.h>
#include <std_srvs/Empty.h>

static const char CMD_VEL[] = "cmd_vel";

class TeleopNode
{
public:
    TeleopNode();

private:
    void joy(const sensor_msgs::Joy::ConstPtr &msg);
    bool onStop(std_srvs::Empty::Request &req, std_srvs::Empty::Response &res);

    ros::NodeHandle global, nh;
    ros::Subscriber sub;
    ros::Publisher pub;
    ros::ServiceServer stop;
    double scale{1.0};
};
