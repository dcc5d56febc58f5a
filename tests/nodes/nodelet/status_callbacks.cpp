#include <mutex>
#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <pluginlib/class_list_macros.hpp>
#include <sensor_msgs/PointCloud2.h>

namespace proc {

class Lazy : public nodelet::Nodelet {
 public:
  void onInit() final {
    std::lock_guard<std::mutex> lock(mutex_);
    pub_ = getNodeHandle().advertise<sensor_msgs::PointCloud2>(
        "points_small", 3,
        [this](const ros::SingleSubscriberPublisher&) { Connect(); },
        [this](const ros::SingleSubscriberPublisher&) { Connect(); });
  }

 private:
  void Connect() {
    std::lock_guard<std::mutex> lock(mutex_);
    if (!pub_.getNumSubscribers())
      sub_.shutdown();
    else if (!sub_)
      sub_ = getNodeHandle().subscribe("points", 3, &Lazy::Points, this);
  }

  void Points(const sensor_msgs::PointCloud2::ConstPtr& points) { pub_.publish(points); }

  std::mutex mutex_;
  ros::Publisher pub_;
  ros::Subscriber sub_;
};

}

PLUGINLIB_EXPORT_CLASS(proc::Lazy, nodelet::Nodelet)
