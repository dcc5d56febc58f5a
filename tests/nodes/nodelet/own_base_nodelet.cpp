#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <pluginlib/class_list_macros.hpp>
#include <std_msgs/Bool.h>
#include <std_msgs/String.h>

namespace acme {

class BaseNodelet : public nodelet::Nodelet {
public:
    void onInit() override {
        status_ = getPrivateNodeHandle().advertise<std_msgs::String>("status", 1, true);
        setup(getNodeHandle(), getPrivateNodeHandle());
    }

protected:
    virtual void setup(ros::NodeHandle& nh, ros::NodeHandle& pnh) = 0;
    ros::Publisher status_;
};

class Gate : public BaseNodelet {
protected:
    void setup(ros::NodeHandle& nh, ros::NodeHandle& pnh) override {
        open_ = nh.subscribe("open", 1, &Gate::open, this);
        pnh.param("closed", closed_, true);
    }

private:
    void open(const std_msgs::BoolConstPtr& b) { closed_ = !b->data; }
    bool closed_;
    ros::Subscriber open_;
};

}

PLUGINLIB_EXPORT_CLASS(acme::Gate, nodelet::Nodelet)
