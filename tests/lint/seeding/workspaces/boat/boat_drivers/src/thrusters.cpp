#include <boat_msgs/Thrust.h>
#include <ros/ros.h>
#include <sensor_msgs/Imu.h>
#include <std_msgs/Bool.h>
#include <std_msgs/Float64.h>

using boat_msgs::Thrust;

static ros::Publisher left_pub;
static ros::Publisher right_pub;
double limit = 1.0;

void thrustCallback(const Thrust::ConstPtr& msg)
{
  if (!msg->armed)
    return;
  std_msgs::Float64 left, right;
  left.data = std::min(msg->left, limit);
  right.data = std::min(msg->right, limit);
  left_pub.publish(left);
  right_pub.publish(right);
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "thrusters");
  ros::NodeHandle n;
  n.param("limit", limit, 1.0);
  left_pub = n.advertise<std_msgs::Float64>("thrusters/left", 1);
  right_pub = n.advertise<std_msgs::Float64>("thrusters/right", 1);
  ros::Publisher imu_pub = n.advertise<sensor_msgs::Imu>("imu/data", 10);
  ros::Subscriber thrust_sub = n.subscribe("thrust", 1, thrustCallback);

  ros::Rate rate(50);
  while (ros::ok())
  {
    sensor_msgs::Imu imu;
    imu.header.stamp = ros::Time::now();
    imu.header.frame_id = "imu_link";
    imu.orientation.w = 1.0;
    imu_pub.publish(imu);
    ros::spinOnce();
    rate.sleep();
  }
  return 0;
}
