#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <pluginlib/class_list_macros.hpp>
#include <std_msgs/UInt16.h>
#include <std_srvs/SetBool.h>

struct Lambdas : nodelet::Nodelet {
    ros::Subscriber sub;
    ros::ServiceServer srv;
    ros::Timer timer;
    bool on{};

    void onInit() final {
        auto& nh = getNodeHandle();
        sub = nh.subscribe<std_msgs::UInt16>("port", 1, [this](const std_msgs::UInt16ConstPtr& p) {
            if (on) NODELET_INFO_STREAM("port " << p->data);
        });
        srv = nh.advertiseService<std_srvs::SetBool::Request, std_srvs::SetBool::Response>("on",
            [this](auto& req, auto& res) { on = req.data; return res.success = true; });
        timer = nh.createTimer(ros::Duration(10), [](const ros::TimerEvent&) {}, true);
    }
};

PLUGINLIB_EXPORT_CLASS(Lambdas, nodelet::Nodelet)
