#include <ros/ros.h>
#include <std_msgs/Int32.h>
#include <std_msgs/Bool.h>

class Device
{
public:
    Device() : nh_("device")
    {
        rpm_ = makePublisher<std_msgs::Int32>("rpm");
        ok_ = makeBool("ok");
        alarm_ = makeBool("alarm");
    }

private:
    template <typename T>
    ros::Publisher makePublisher(const std::string &name)
    {
        return nh_.advertise<T>(name, 1);
    }

    ros::Publisher makeBool(const std::string &name)
    {
        return nh_.advertise<std_msgs::Bool>(name, 1, true);
    }

    ros::NodeHandle nh_;
    ros::Publisher rpm_, ok_, alarm_;
};

int main(int argc, char **argv)
{
    ros::init(argc, argv, "wrappers");
    Device device;
    ros::spin();
    return 0;
}
