#ifndef DEEP_HXX
#define DEEP_HXX

#include <ros/ros.h>
#include <std_msgs/Int64.h>
#include <std_srvs/Trigger.h>

namespace a { namespace b { namespace c {

using Message = std_msgs::Int64;
typedef std_srvs::Trigger Service;

class Deep
{
public:
    explicit Deep(ros::NodeHandle n);
    void handle(const Message::ConstPtr& m);

private:
    ros::Publisher pub;
    ros::Subscriber sub;
    ros::ServiceClient client;
};

}}}

#endif
