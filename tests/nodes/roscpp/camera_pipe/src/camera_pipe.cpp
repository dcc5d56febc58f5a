#include "camera_pipe/camera_pipe.hpp"

CameraPipe::CameraPipe(ros::NodeHandle nh, ros::NodeHandle pnh) : it_(nh), private_it_(pnh)
{
  sub_ = it_.subscribe("image_raw", 1, &CameraPipe::imageCallback, this);
  pub_ = it_.advertise("image_small", 1);
  debug_ = private_it_.advertise("debug", 1, true);
}

void CameraPipe::imageCallback(const sensor_msgs::ImageConstPtr &image)
{
  if (pub_.getNumSubscribers() > 0) {
    pub_.publish(image);
  }
}

int main(int argc, char **argv)
{
  ros::init(argc, argv, "camera_pipe");
  CameraPipe pipe{ros::NodeHandle{}, ros::NodeHandle{"~"}};
  ros::spin();
}
