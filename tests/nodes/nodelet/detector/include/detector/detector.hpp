#pragma once

#include <geometry_msgs/PoseArray.h>
#include <image_transport/image_transport.h>
#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <std_srvs/SetBool.h>

#include "detector/topics.hpp"

namespace detector {

class Detector : public nodelet::Nodelet {
 public:
  using Detections = geometry_msgs::PoseArray;

 private:
  void onInit() override;
  void onImage(const sensor_msgs::ImageConstPtr& image);
  bool onEnable(std_srvs::SetBool::Request& q, std_srvs::SetBool::Response& r);

  image_transport::Subscriber sub_;
  ros::Publisher pub_;
  ros::ServiceServer model_srv_;
  double threshold_;
  static constexpr double kThreshold = 0.7;
};

}  // namespace detector
