#include <ros/ros.h>
#include <std_msgs/Float32.h>
#include <sensor_msgs/Range.h>

struct Publishers
{
  ros::Publisher a, b;
};

static void onRange(const sensor_msgs::Range::ConstPtr& r) { (void)r; }

Publishers makePublishers(ros::NodeHandle& handle)
{
  return {handle.advertise<std_msgs::Float32>("a", 1), handle.advertise<std_msgs::Float32>("b", 1)};
}

auto listen(ros::NodeHandle* handle) -> ros::Subscriber
{
  return handle->subscribe("range", 1, &onRange);
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "passed");
  ros::NodeHandle nh;
  ros::NodeHandle private_nh("~");
  Publishers pubs = makePublishers(private_nh);
  ros::Subscriber sub = listen(&nh);
  ros::spin();
  return 0;
}
