#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <pluginlib/class_list_macros.hpp>
#include <sensor_msgs/JointState.h>
#include <std_srvs/SetBool.h>

using namespace ros;
using namespace std;
using namespace sensor_msgs;
using nodelet::Nodelet;

class Hub : public Nodelet {
    NodeHandle nh;
    Publisher joints;
    Subscriber commands;
    ServiceServer power;

    static const string COMMANDS;
    bool setPower(std_srvs::SetBoolRequest& req, std_srvs::SetBoolResponse& res) { res.success = req.data; return true; }
    void onCommand(JointStateConstPtr const& js) { joints.publish(js); }

    void onInit() override {
        nh = getNodeHandle();
        joints = nh.advertise<JointState>("joint_states", 10);
        commands = nh.subscribe(COMMANDS, 10, &Hub::onCommand, this);
        power = nh.advertiseService("power", &Hub::setPower, this);
    }
};
const string Hub::COMMANDS = "joint_commands";

PLUGINLIB_EXPORT_CLASS(Hub, Nodelet)
