#include <ros/ros.h>

int main(int argc, char** argv)
{
  ros::init(argc, argv, "parameters");
  ros::NodeHandle nh;
  ros::NodeHandle nh_priv("~");
  int count; double speed; bool on; std::string name; std::vector<double> gains;

  nh.param("count", count, 10);
  nh_priv.param<double>("speed", speed, 1.5);
  nh_priv.param("on", on, false);
  nh_priv.param<std::string>("name", name, "bob");
  auto size = nh_priv.param("size", 3.0);
  nh.getParam("/gains", gains);
  nh_priv.getParamCached("live", speed);
  if (nh.hasParam("optional"))
    nh.setParam("seen", true);
  ros::param::get("~raw", count);
  ros::param::param<int>("/global", count, 5);
  ros::param::getCached("cached", speed);
  ros::param::set("out", 1);
  const double negative = nh_priv.param<double>("negative", -2.0);
  nh.deleteParam("old");
  ROS_INFO("%d %f", count, size + negative);
}
