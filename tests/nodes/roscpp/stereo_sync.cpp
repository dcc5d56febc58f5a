#include <message_filters/subscriber.h>
#include <message_filters/sync_policies/approximate_time.h>
#include <message_filters/synchronizer.h>
#include <message_filters/time_synchronizer.h>
#include <ros/ros.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>

#include <memory>

class StereoSync
{
  using Policy = message_filters::sync_policies::ApproximateTime<sensor_msgs::Image, sensor_msgs::Image>;

public:
  StereoSync()
  : left_(nh_, "left/image", 1)
  , right_(nh_, "right/image", 1)
  , sync_(Policy(10), left_, right_)
  {
    sync_.registerCallback(boost::bind(&StereoSync::both, this, boost::placeholders::_1, boost::placeholders::_2));
    info_.subscribe(nh_, "left/camera_info", 5);
    depth_ = std::make_shared<message_filters::Subscriber<sensor_msgs::Image>>(nh_, "depth", 1);
    mask_.reset(new message_filters::Subscriber<sensor_msgs::Image>(nh_, "mask", 1));
  }

private:
  void both(const sensor_msgs::ImageConstPtr &, const sensor_msgs::ImageConstPtr &) {}

  ros::NodeHandle nh_;
  message_filters::Subscriber<sensor_msgs::Image> left_;
  message_filters::Subscriber<sensor_msgs::Image> right_;
  message_filters::Subscriber<sensor_msgs::CameraInfo> info_;
  std::shared_ptr<message_filters::Subscriber<sensor_msgs::Image>> depth_;
  std::unique_ptr<message_filters::Subscriber<sensor_msgs::Image>> mask_;
  message_filters::Synchronizer<Policy> sync_;
};

int main(int argc, char ** argv)
{
  ros::init(argc, argv, "stereo_sync");
  StereoSync node;
  ros::spin();
}
