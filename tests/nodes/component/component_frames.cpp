#include <geometry_msgs/msg/pose_stamped.hpp>
#include <geometry_msgs/msg/transform_stamped.hpp>
#include <rclcpp/rclcpp.hpp>
#include <rclcpp_components/register_node_macro.hpp>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_broadcaster.h>
#include <tf2_ros/transform_listener.h>

class FrameSender : public rclcpp::Node
{
public:
  explicit FrameSender(const rclcpp::NodeOptions & options)
  : Node("frame_sender", options), buffer_(get_clock()), listener_(buffer_), broadcaster_(this)
  {
    pose_ = create_subscription<geometry_msgs::msg::PoseStamped>("pose", 10, std::bind(&FrameSender::pose, this, std::placeholders::_1));
  }

private:
  void pose(const geometry_msgs::msg::PoseStamped & p)
  {
    geometry_msgs::msg::TransformStamped t;
    t.header = p.header;
    broadcaster_.sendTransform(t);
  }

  tf2_ros::Buffer buffer_;
  tf2_ros::TransformListener listener_;
  tf2_ros::TransformBroadcaster broadcaster_;
  rclcpp::Subscription<geometry_msgs::msg::PoseStamped>::SharedPtr pose_;
};

RCLCPP_COMPONENTS_REGISTER_NODE(FrameSender)
