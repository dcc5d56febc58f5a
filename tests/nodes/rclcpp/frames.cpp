#include <geometry_msgs/msg/transform_stamped.hpp>
#include <rclcpp/rclcpp.hpp>
#include <tf2_ros/buffer.h>
#include <tf2_ros/static_transform_broadcaster.h>
#include <tf2_ros/transform_broadcaster.h>
#include <tf2_ros/transform_listener.h>

class Frames : public rclcpp::Node
{
public:
  Frames()
  : Node("frames")
  {
    buffer_ = std::make_unique<tf2_ros::Buffer>(this->get_clock());
    listener_ = std::make_shared<tf2_ros::TransformListener>(*buffer_);
    broadcaster_ = std::make_unique<tf2_ros::TransformBroadcaster>(*this);
    static_ = std::make_shared<tf2_ros::StaticTransformBroadcaster>(this);
    timer_ = create_wall_timer(std::chrono::milliseconds(50), [this]() {send();});
  }

private:
  void send()
  {
    geometry_msgs::msg::TransformStamped t;
    t.header.stamp = now();
    broadcaster_->sendTransform(t);
  }

  std::unique_ptr<tf2_ros::Buffer> buffer_;
  std::shared_ptr<tf2_ros::TransformListener> listener_;
  std::unique_ptr<tf2_ros::TransformBroadcaster> broadcaster_;
  std::shared_ptr<tf2_ros::StaticTransformBroadcaster> static_;
  rclcpp::TimerBase::SharedPtr timer_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Frames>());
  rclcpp::shutdown();
}
