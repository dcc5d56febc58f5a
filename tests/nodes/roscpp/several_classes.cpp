#include <ros/ros.h>
#include <geometry_msgs/Twist.h>
#include <sensor_msgs/BatteryState.h>
#include <std_srvs/Trigger.h>

class Wheels
{
  ros::NodeHandle nh;
  ros::Subscriber sub;

  void cb(const geometry_msgs::Twist& twist) { (void)twist; }

public:
  Wheels() { sub = nh.subscribe("cmd_vel", 1, &Wheels::cb, this); }
};

class Battery
{
  ros::NodeHandle nh{"battery"};
  ros::Publisher pub;
  ros::Timer timer;

  void cb(const ros::TimerEvent&) { pub.publish(sensor_msgs::BatteryState()); }

public:
  Battery()
  {
    pub = nh.advertise<sensor_msgs::BatteryState>("state", 1);
    timer = nh.createTimer(ros::Duration(5), &Battery::cb, this);
  }
};

class Brake
{
  ros::ServiceServer srv;

  bool cb(std_srvs::TriggerRequest&, std_srvs::TriggerResponse&) { return true; }

public:
  explicit Brake(ros::NodeHandle nh) : srv(nh.advertiseService("brake", &Brake::cb, this)) {}
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "base");
  Wheels wheels;
  Battery battery;
  Brake brake{ros::NodeHandle()};
  ros::spin();
}
