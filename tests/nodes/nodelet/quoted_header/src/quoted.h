#pragma once
#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <std_msgs/Duration.h>

typedef std_msgs::Duration Msg;
#define TOPIC "quoted"

class Quoted : public nodelet::Nodelet {
    ros::Publisher pub;
    ros::Subscriber sub;
    void answer(const Msg::ConstPtr& m) { pub.publish(m); }
public:
    void onInit();
};
