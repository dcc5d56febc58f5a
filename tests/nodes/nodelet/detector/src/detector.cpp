// Copyright: whoever wants it
#include <detector/detector.hpp>
#include <pluginlib/class_list_macros.hpp>

namespace detector {

void Detector::onInit() {
  ros::NodeHandle &nh = getMTNodeHandle(), &pnh = getMTPrivateNodeHandle();
  image_transport::ImageTransport it(nh);
  sub_ = it.subscribe(topics::IMAGE, 1, &Detector::onImage, this);
  pub_ = nh.advertise<Detections>(topics::DETECTIONS, 1);
  pnh.param("threshold", threshold_, kThreshold);
  model_srv_ = pnh.advertiseService("enable", &Detector::onEnable, this);
}

}  // namespace detector

PLUGINLIB_EXPORT_CLASS(detector::Detector, nodelet::Nodelet)
