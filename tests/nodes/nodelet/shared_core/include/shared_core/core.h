#ifndef SHARED_CORE_CORE_H
#define SHARED_CORE_CORE_H

#include <ros/ros.h>
#include <std_msgs/Float64.h>

#include <memory>

namespace shared_core {

constexpr double kPeriod = 0.02;

class Core {
public:
    Core(ros::NodeHandle nh, ros::NodeHandle pnh);

private:
    void heading(const std_msgs::Float64& h);
    void step(const ros::TimerEvent&);

    ros::Subscriber in_;
    ros::Publisher out_;
    ros::Timer timer_;
    double error_ = 0;
};

}  // namespace shared_core

#endif
