#include <geometry_msgs/PointStamped.h>
#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <pluginlib/class_list_macros.hpp>
#include <tf2_geometry_msgs/tf2_geometry_msgs.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_broadcaster.h>
#include <tf2_ros/transform_listener.h>

class Frames : public nodelet::Nodelet {
public:
    Frames() : listener_(buffer_) {}

    void onInit() override {
        broadcaster_ = std::make_shared<tf2_ros::TransformBroadcaster>();
        point_ = getNodeHandle().subscribe("point", 10, &Frames::point, this);
    }

    void point(const geometry_msgs::PointStamped& p) {
        geometry_msgs::PointStamped out;
        buffer_.transform(p, out, "map", ros::Duration(0.1));
    }

private:
    tf2_ros::Buffer buffer_;
    tf2_ros::TransformListener listener_;
    std::shared_ptr<tf2_ros::TransformBroadcaster> broadcaster_;
    ros::Subscriber point_;
};

PLUGINLIB_EXPORT_CLASS(Frames, nodelet::Nodelet)
