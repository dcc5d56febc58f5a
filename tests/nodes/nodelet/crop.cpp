#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <pluginlib/class_list_macros.hpp>
#include <sensor_msgs/Image.h>

class CropNodelet : public nodelet::Nodelet {
 public:
  void onInit() override {
    nh_ = getNodeHandle();
    auto pnh = getPrivateNodeHandle();
    pnh.param("width", width_, 320);
    pnh.param("height", height_, 240);
    pub_ = nh_.advertise<sensor_msgs::Image>("image_cropped", 1);
    sub_ = nh_.subscribe("image", 1, &CropNodelet::ImageCallback, this);
  }

 private:
  void ImageCallback(const sensor_msgs::ImageConstPtr& image) { pub_.publish(image); }

  ros::NodeHandle nh_;
  ros::Publisher pub_;
  ros::Subscriber sub_;
  int width_;
  int height_;
};

PLUGINLIB_EXPORT_CLASS(CropNodelet, nodelet::Nodelet)
