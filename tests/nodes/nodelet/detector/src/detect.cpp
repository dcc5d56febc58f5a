#include <detector/detector.hpp>

void detector::Detector::onImage(const sensor_msgs::ImageConstPtr& image) {
  Detections found;
  found.header = image->header;
  pub_.publish(found);
}

bool detector::Detector::onEnable(std_srvs::SetBool::Request& q, std_srvs::SetBool::Response& r) {
  r.success = q.data;
  return true;
}
