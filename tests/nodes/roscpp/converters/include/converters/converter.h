#ifndef CONVERTERS_CONVERTER_H
#define CONVERTERS_CONVERTER_H
#include <ros/ros.h>
#include <sensor_msgs/PointCloud.h>
#include <sensor_msgs/PointCloud2.h>

class Converter
{
public:
  Converter();
  void callback(sensor_msgs::PointCloud2ConstPtr cloud);

private:
  ros::NodeHandle n_;
  ros::Publisher pub_;
  ros::Subscriber sub_;
  std::string topic_in_ = "points_in";
  std::string topic_out_;
  const std::string frame_{"base"};
};
#endif
