#ifndef CAMERA_PIPE__CAMERA_PIPE_HPP_
#define CAMERA_PIPE__CAMERA_PIPE_HPP_

#include <image_transport/image_transport.h>
#include <ros/ros.h>

#include <memory>

class CameraPipe
{
public:
  CameraPipe(ros::NodeHandle nh, ros::NodeHandle pnh);

private:
  void imageCallback(const sensor_msgs::ImageConstPtr &image);

  image_transport::ImageTransport it_;
  image_transport::ImageTransport private_it_;
  image_transport::Subscriber sub_;
  image_transport::Publisher pub_, debug_;
};

#endif
