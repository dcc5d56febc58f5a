#include <ros/ros.h>
#include <std_msgs/Float32.h>

class Wheel
{
public:
  Wheel(ros::NodeHandle& nh, const std::string& speed_topic, std::string state = "wheel_state")
    : speed_topic_(speed_topic)
  {
    sub_ = nh.subscribe(speed_topic_, 1, &Wheel::speedCallback, this);
    pub_ = nh.advertise<std_msgs::Float32>(state, 1);
  }

private:
  void speedCallback(const std_msgs::Float32::ConstPtr& msg) { pub_.publish(*msg); }

  std::string speed_topic_;
  ros::Subscriber sub_;
  ros::Publisher pub_;
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "wheel_watch");
  ros::NodeHandle nh;
  Wheel wheel(nh, "wheel_speed");
  ros::spin();
  return 0;
}
