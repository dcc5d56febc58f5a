#ifndef RECTIFY__RECTIFY_HPP_
#define RECTIFY__RECTIFY_HPP_

#include <image_transport/image_transport.hpp>
#include <memory>
#include <message_filters/subscriber.h>
#include <message_filters/sync_policies/exact_time.h>
#include <message_filters/synchronizer.h>
#include <rclcpp/rclcpp.hpp>
#include <sensor_msgs/msg/camera_info.hpp>

namespace vision
{

class Rectify : public rclcpp::Node
{
public:
  explicit Rectify(const rclcpp::NodeOptions & options);

private:
  using InfoSubscriber = message_filters::Subscriber<sensor_msgs::msg::CameraInfo>;
  using Policy = message_filters::sync_policies::ExactTime<
    sensor_msgs::msg::Image, sensor_msgs::msg::CameraInfo>;
  using Synchronizer = message_filters::Synchronizer<Policy>;

  void process(
    const sensor_msgs::msg::Image::ConstSharedPtr & image,
    const sensor_msgs::msg::CameraInfo::ConstSharedPtr & info);

  message_filters::Subscriber<sensor_msgs::msg::Image> image_sub_;
  std::shared_ptr<InfoSubscriber> info_sub_;
  std::shared_ptr<Synchronizer> sync_;
  image_transport::Publisher rect_pub_;
  int queue_size_;
};

}  // namespace vision

#endif
