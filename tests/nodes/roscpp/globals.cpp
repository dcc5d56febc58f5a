#include <ros/ros.h>
#include <std_msgs/Bool.h>
#include <sensor_msgs/JointState.h>
#include <std_srvs/SetBool.h>

ros::Publisher g_state_pub;
ros::ServiceClient *g_client = NULL;
static ros::NodeHandle *node = NULL;
bool g_closed = false;

void jointCb(const sensor_msgs::JointState::ConstPtr &js);

bool setGripper(std_srvs::SetBool::Request &req, std_srvs::SetBool::Response &res)
{
    g_closed = req.data;
    res.success = g_client->call(req, res);
    return true;
}

void setup()
{
    g_state_pub = node->advertise<std_msgs::Bool>("gripper_closed", 10, /* latch = */ true);
    static ros::Subscriber sub = node->subscribe("joint_states", 10, jointCb);
    static ros::ServiceServer srv = node->advertiseService("set_gripper", setGripper);
    g_client = new ros::ServiceClient(node->serviceClient<std_srvs::SetBool>("hardware/gripper"));
}

int main(int argc, char **argv)
{
    ros::init(argc, argv, "gripper_bridge");
    node = new ros::NodeHandle;
    setup();
    ros::spin();
    delete g_client;
    delete node;
    return 0;
}

void jointCb(const sensor_msgs::JointState::ConstPtr &js)
{
    std_msgs::Bool closed;
    closed.data = g_closed && !js->position.empty();
    g_state_pub.publish(closed);
}
