#include <ros/ros.h>
#include <sensor_msgs/Range.h>
#include <std_msgs/Bool.h>
#include <vector>

void onRange(const sensor_msgs::Range::ConstPtr& r, const std::string& which) { (void)r; (void)which; }

int main(int argc, char** argv)
{
  ros::init(argc, argv, "loops");
  ros::NodeHandle nh;
  std::vector<ros::Subscriber> subs;
  std::vector<ros::Publisher> pubs;

  const std::vector<std::string> sides = {"left", "right"};
  for (const auto& side : sides)
  {
    subs.push_back(nh.subscribe<sensor_msgs::Range>(
        side + "/range", 1, boost::bind(&onRange, boost::placeholders::_1, side)));
  }

  for (int i = 1; i < argc; ++i)
    pubs.push_back(nh.advertise<std_msgs::Bool>(argv[i], 1));

  ros::spin();
  return 0;
}
