#include "rectify/rectify.hpp"

#include <rclcpp_components/register_node_macro.hpp>

namespace vision
{

Rectify::Rectify(const rclcpp::NodeOptions & options)
: Node("rectify", options)
{
  queue_size_ = this->declare_parameter<int>("queue_size", 5);
  image_sub_.subscribe(this, "image", rmw_qos_profile_sensor_data);
  info_sub_ = std::make_shared<InfoSubscriber>(this, "camera_info", rmw_qos_profile_sensor_data);
  sync_ = std::make_shared<Synchronizer>(Policy(queue_size_), image_sub_, *info_sub_);
  sync_->registerCallback(std::bind(&Rectify::process, this, std::placeholders::_1, std::placeholders::_2));
  rect_pub_ = image_transport::create_publisher(this, "image_rect");
}

void Rectify::process(
  const sensor_msgs::msg::Image::ConstSharedPtr & image,
  const sensor_msgs::msg::CameraInfo::ConstSharedPtr &)
{
  rect_pub_.publish(image);
}

}  // namespace vision

RCLCPP_COMPONENTS_REGISTER_NODE(vision::Rectify)
