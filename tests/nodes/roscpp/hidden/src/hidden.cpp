#include <hidden/hidden.h>

#include <ros/ros.h>
#include <sensor_msgs/Imu.h>
#include <sensor_msgs/MagneticField.h>

class Hidden::Impl {
public:
    Impl() {
        imu = nh.advertise<sensor_msgs::Imu>("imu/data", 100);
        mag = nh.subscribe("imu/mag", 100, &Impl::magnetic, this);
    }

    void magnetic(const sensor_msgs::MagneticField::ConstPtr&) { imu.publish(sensor_msgs::Imu()); }

    ros::NodeHandle nh;
    ros::Publisher imu;
    ros::Subscriber mag;
};

Hidden::Hidden() : impl_(new Impl) {}
Hidden::~Hidden() = default;
