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
  struct Wrapped {
    explicit Wrapped(ros::NodeHandle &nh) : transport(nh) {}
    image_transport::ImageTransport *operator->() { return &transport; }
    image_transport::ImageTransport transport;
  } private_it_;
  image_transport::Subscriber sub_;
  image_transport::Publisher pub_, debug_;
};

#endif
