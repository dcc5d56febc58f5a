#include "nodelet/nodelet.h"
#include "ros/ros.h"
#include "pluginlib/class_list_macros.hpp"
#include "std_msgs/String.h"
#include "std_msgs/Int32.h"
#include "std_srvs/Empty.h"

namespace demo {
using std_msgs::String;

class DirectHandles : public nodelet::Nodelet {
    ros::Publisher a, b, c;
    ros::Subscriber d;
    ros::ServiceServer e;
    ros::ServiceClient f;
    ros::Timer g;

    void onInit() {
        a = getNodeHandle().advertise<String>("a", 1);
        b = getPrivateNodeHandle().advertise<String>("b", 1);
        c = getMTNodeHandle().advertise<String>("c", 1);
        d = getMTPrivateNodeHandle().subscribe("d", 1, &DirectHandles::cb, this);
        e = getPrivateNodeHandle().advertiseService("e", &DirectHandles::srv, this);
        f = this->getNodeHandle().serviceClient<std_srvs::Empty>("f");
        g = getNodeHandle().createTimer(ros::Duration(1.0), &DirectHandles::tick, this);
    }
    void cb(const std_msgs::Int32 &) {}
    bool srv(std_srvs::Empty::Request &, std_srvs::Empty::Response &) { return true; }
    void tick(const ros::TimerEvent &) {}
};
}
PLUGINLIB_EXPORT_CLASS(demo::DirectHandles, nodelet::Nodelet)
