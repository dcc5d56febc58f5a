#pragma once

#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <std_msgs/ColorRGBA.h>
#include <std_srvs/SetBool.h>

class LightsNodelet : public nodelet::Nodelet {
public:
    void onInit() override;

    inline void init() {
        colour_ = nh_.subscribe("colour", 1, &LightsNodelet::onColour, this);
        on_ = nh_.advertiseService("lights_on", &LightsNodelet::onSwitch, this);
    }

private:
    void onColour(const std_msgs::ColorRGBA::ConstPtr& c) { colour_now_ = *c; }
    bool onSwitch(std_srvs::SetBool::Request& rq, std_srvs::SetBool::Response& rs) { return rs.success = rq.data; }

    ros::NodeHandle nh_;
    ros::Subscriber colour_;
    ros::ServiceServer on_;
    std_msgs::ColorRGBA colour_now_;
};
