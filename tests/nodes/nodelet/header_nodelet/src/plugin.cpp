#include "header_nodelet/mixer.h"
#include <pluginlib/class_list_macros.hpp>

PLUGINLIB_EXPORT_CLASS(header_nodelet::Mixer, nodelet::Nodelet)
