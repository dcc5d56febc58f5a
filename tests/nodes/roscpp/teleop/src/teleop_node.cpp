#include <teleop/teleop_node.hpp>

TeleopNode::TeleopNode()
    : nh("~")
{
    sub = global.subscribe<sensor_msgs::Joy>("joy", 10, &TeleopNode::joy, this);
    pub = global.advertise<geometry_msgs::Twist>(CMD_VEL, 1);
    stop = nh.advertiseService("stop", &TeleopNode::onStop, this);
    nh.getParam("scale", scale);
}

void TeleopNode::joy(const sensor_msgs::Joy::ConstPtr &msg)
{
    geometry_msgs::Twist twist;
    twist.linear.x = scale * msg->axes.at(1);
    pub.publish(twist);
}

bool TeleopNode::onStop(std_srvs::Empty::Request &, std_srvs::Empty::Response &)
{
    pub.publish(geometry_msgs::Twist{});
    return true;
}

int main(int argc, char **argv)
{
    ros::init(argc, argv, "teleop");
    TeleopNode node;
    ros::spin();
}
