#include <message_filters/subscriber.h>
#include <message_filters/sync_policies/exact_time.h>
#include <message_filters/synchronizer.h>
#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <pluginlib/class_list_macros.hpp>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>

class DepthSync : public nodelet::Nodelet
{
  typedef message_filters::sync_policies::ExactTime<sensor_msgs::Image, sensor_msgs::CameraInfo> Policy;
  typedef message_filters::Synchronizer<Policy> Sync;

  message_filters::Subscriber<sensor_msgs::Image> depth_sub_;
  message_filters::Subscriber<sensor_msgs::CameraInfo> info_sub_;
  boost::shared_ptr<Sync> sync_;
  ros::Publisher cloud_pub_;

  virtual void onInit()
  {
    ros::NodeHandle nh = getNodeHandle();
    int queue_size;
    getPrivateNodeHandle().param("queue_size", queue_size, 5);
    depth_sub_.subscribe(nh, "depth", 1);
    info_sub_.subscribe(nh, "camera_info", 1);
    sync_.reset(new Sync(Policy(queue_size), depth_sub_, info_sub_));
    sync_->registerCallback(boost::bind(&DepthSync::depthCb, this, boost::placeholders::_1, boost::placeholders::_2));
    cloud_pub_ = nh.advertise<sensor_msgs::PointCloud2>("points", 1);
  }

  void depthCb(const sensor_msgs::ImageConstPtr& depth, const sensor_msgs::CameraInfoConstPtr& info)
  {
    cloud_pub_.publish(sensor_msgs::PointCloud2());
  }
};

PLUGINLIB_EXPORT_CLASS(DepthSync, nodelet::Nodelet)
