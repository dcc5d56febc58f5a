#include <image_transport/image_transport.h>
#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <pluginlib/class_list_macros.hpp>
#include <sensor_msgs/CameraInfo.h>

class CameraPair : public nodelet::Nodelet
{
  boost::shared_ptr<image_transport::ImageTransport> it_in_, it_out_;
  image_transport::CameraSubscriber sub_;
  image_transport::CameraPublisher pub_;

  void onInit() override
  {
    ros::NodeHandle &nh = getNodeHandle();
    ros::NodeHandle nh_in(nh, "camera");
    ros::NodeHandle nh_out(nh, "camera_out");
    it_in_.reset(new image_transport::ImageTransport(nh_in));
    it_out_.reset(new image_transport::ImageTransport(nh_out));
    pub_ = it_out_->advertiseCamera("image_raw", 1);
    sub_ = it_in_->subscribeCamera("image_raw", 1, &CameraPair::imageCb, this);
  }

  void imageCb(const sensor_msgs::ImageConstPtr &image, const sensor_msgs::CameraInfoConstPtr &info)
  {
    pub_.publish(image, info);
  }
};

PLUGINLIB_EXPORT_CLASS(CameraPair, nodelet::Nodelet)
