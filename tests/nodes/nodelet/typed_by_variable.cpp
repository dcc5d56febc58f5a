#include <functional>
#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <pluginlib/class_list_macros.hpp>
#include <std_msgs/Bool.h>
#include <std_msgs/Byte.h>
#include <std_srvs/SetBool.h>

class Variables : public nodelet::Nodelet {
public:
    typedef boost::function<void(const std_msgs::Bool::ConstPtr&)> BoolCallback;

private:
    void onInit() override {
        nh_ = ros::NodeHandle(getNodeHandle(), "switch");
        BoolCallback callback = boost::bind(&Variables::onBool, this, boost::placeholders::_1, std::string("a"));
        a_ = nh_.subscribe<std_msgs::Bool>("a", 1, callback);
        std::function<void(const std_msgs::Byte::ConstPtr&)> other = [this](const std_msgs::Byte::ConstPtr&) { ++n_; };
        b_ = nh_.subscribe<std_msgs::Byte>("b", 1, other);
        ros::AdvertiseServiceOptions options;
        options.init<std_srvs::SetBool::Request, std_srvs::SetBool::Response>("set", boost::bind(&Variables::set, this, boost::placeholders::_1, boost::placeholders::_2));
        set_ = nh_.advertiseService(options);
        static const uint32_t queue = 1u << 3;
        pub_ = nh_.advertise<std_msgs::Byte>(topic("count"), queue, /*latch*/ true);
    }
    static std::string topic(const std::string& name) { return name; }
    void onBool(const std_msgs::Bool::ConstPtr&, const std::string&) {}
    bool set(std_srvs::SetBool::Request& q, std_srvs::SetBool::Response& r) { return r.success = q.data; }

    ros::NodeHandle nh_;
    ros::Subscriber a_, b_;
    ros::ServiceServer set_;
    ros::Publisher pub_;
    int n_ = 0;
};

PLUGINLIB_EXPORT_CLASS(Variables, nodelet::Nodelet)
