#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <pluginlib/class_list_macros.hpp>

#include "shared_core/core.h"

namespace shared_core {

class CoreNodelet : public nodelet::Nodelet {
public:
    void onInit() override { core_.reset(new Core(getNodeHandle(), getPrivateNodeHandle())); }

private:
    std::unique_ptr<Core> core_;
};

Core::Core(ros::NodeHandle nh, ros::NodeHandle pnh) {
    in_ = nh.subscribe("heading", 1, &Core::heading, this);
    out_ = pnh.advertise<std_msgs::Float64>("error", 1);
    timer_ = pnh.createTimer(ros::Duration(kPeriod), &Core::step, this);
}

void Core::heading(const std_msgs::Float64& h) { error_ = h.data; }

void Core::step(const ros::TimerEvent&) {
    std_msgs::Float64 e;
    e.data = error_;
    out_.publish(e);
}

}  // namespace shared_core

PLUGINLIB_EXPORT_CLASS(shared_core::CoreNodelet, nodelet::Nodelet)
