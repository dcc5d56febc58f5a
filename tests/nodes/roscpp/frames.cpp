#include <geometry_msgs/TransformStamped.h>
#include <ros/ros.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/static_transform_broadcaster.h>
#include <tf2_ros/transform_broadcaster.h>
#include <tf2_ros/transform_listener.h>
#include <geometry_msgs/Pose2D.h>

void onPose(const geometry_msgs::Pose2DConstPtr & pose)
{
  static tf2_ros::TransformBroadcaster broadcaster;
  geometry_msgs::TransformStamped t;
  t.header.stamp = ros::Time::now();
  t.header.frame_id = "world";
  t.child_frame_id = "turtle";
  t.transform.translation.x = pose->x;
  t.transform.rotation.w = 1;
  broadcaster.sendTransform(t);
}

int main(int argc, char ** argv)
{
  ros::init(argc, argv, "frames");
  ros::NodeHandle node;
  tf2_ros::Buffer buffer;
  tf2_ros::TransformListener listener(buffer);
  tf2_ros::StaticTransformBroadcaster fixed;
  ros::Subscriber sub = node.subscribe("pose", 10, &onPose);
  ros::spin();
  return 0;
}
