#include <elevation/elevation.hpp>

void Elevation::Update(Cloud::ConstSharedPtr cloud) { map_->publish(*cloud); }

void Elevation::Save(std_srvs::srv::Trigger::Request::SharedPtr, std_srvs::srv::Trigger::Response::SharedPtr res) {
  res->success = false;
}
