#include <image_transport/image_transport.h>
#include <image_transport/subscriber_filter.h>
#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <pluginlib/class_list_macros.hpp>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/SetCameraInfo.h>

namespace cam
{
namespace it = image_transport;

class Camera : public nodelet::Nodelet
{
  std::unique_ptr<it::ImageTransport> transport_;
  it::Publisher raw_;
  ros::Publisher info_;
  ros::ServiceServer set_;
  it::SubscriberFilter left_;

  void onInit() override
  {
    auto & nh = getNodeHandle();
    transport_ = std::make_unique<it::ImageTransport>(nh);
    raw_ = transport_->advertise("image_raw", 1, true);
    info_ = nh.advertise<sensor_msgs::CameraInfo>("camera_info", 1);
    set_ = nh.advertiseService("set_camera_info", &Camera::set, this);
    left_.subscribe(*transport_, "left", 1);
  }

  bool set(sensor_msgs::SetCameraInfo::Request & req, sensor_msgs::SetCameraInfo::Response & res)
  {
    info_.publish(req.camera_info);
    return res.success = true;
  }
};
}  // namespace cam

PLUGINLIB_EXPORT_CLASS(cam::Camera, nodelet::Nodelet)
