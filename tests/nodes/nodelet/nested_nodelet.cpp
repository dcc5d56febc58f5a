// Geschwindigkeit in m/s, Winkel in ° (Grad)
#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <pluginlib/class_list_macros.hpp>
#include <std_msgs/Float64.h>

class Outer
{
public:
    class Inner : public nodelet::Nodelet
    {
    public:
        struct Config { std::string topic = "speed"; double hz = 25.0; };

    private:
        void onInit() override
        {
            pub = getNodeHandle().advertise<std_msgs::Float64>("angle", 1); /* in ° */
            sub = getNodeHandle().subscribe(config.topic, 1, &Outer::Inner::onSpeed, this);
            timer = getNodeHandle().createTimer(ros::Duration(1.0 / config.hz), &Inner::step, this);
        }
        void onSpeed(const std_msgs::Float64::ConstPtr &) {}
        void step(const ros::TimerEvent &) {}

        const Config config;
        ros::Publisher pub;
        ros::Subscriber sub;
        ros::Timer timer;
    };
};

PLUGINLIB_EXPORT_CLASS(Outer::Inner, nodelet::Nodelet)
