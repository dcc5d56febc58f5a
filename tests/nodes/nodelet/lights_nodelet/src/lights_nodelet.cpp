#include "lights_nodelet/lights_nodelet.hpp"
#include <pluginlib/class_list_macros.hpp>

void LightsNodelet::onInit() {
    nh_ = getNodeHandle();
    init();
}

PLUGINLIB_EXPORT_CLASS(LightsNodelet, nodelet::Nodelet)
