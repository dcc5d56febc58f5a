#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <pluginlib/class_list_macros.hpp>
#include <std_msgs/Float32.h>

static const double PERIOD = 0.125;

class Rates : public nodelet::Nodelet
{
public:
    void onInit() override
    {
        ros::NodeHandle &nh = this->getMTNodeHandle();
        fast = nh.createTimer(ros::Duration(PERIOD), &Rates::tick, this);
        wall = nh.createWallTimer(ros::WallDuration(1.0 / 4), boost::bind(&Rates::wallTick, this, boost::placeholders::_1));
        ros::TimerOptions options(ros::Duration(3), boost::bind(&Rates::tick, this, boost::placeholders::_1), nullptr, true);
        late = nh.createTimer(options);
        pub = nh.advertise<std_msgs::Float32>("rate", 1, false);
        pub.publish(std_msgs::Float32());
    }

private:
    void tick(const ros::TimerEvent &) {}
    void wallTick(const ros::WallTimerEvent &) {}
    ros::Timer fast, late;
    ros::WallTimer wall;
    ros::Publisher pub;
};

PLUGINLIB_EXPORT_CLASS(Rates, nodelet::Nodelet)
