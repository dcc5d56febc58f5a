#include "exported_nodelet/shown.h"
#include <pluginlib/class_list_macros.hpp>

namespace vis {
VIS_PUBLIC void Shown::onInit() {
  VIS_TRACE("init");
  pub_ = getNodeHandle().advertise<std_msgs::Int64>("shown", 1);
  sub_ = getNodeHandle().subscribe("show", 1, &Shown::show, this);
}

VIS_LOCAL
void Shown::show(const std_msgs::Int64ConstPtr& n) {
  NODELET_INFO("show %" PRId64 " of %" PRIu64 " things", n->data, uint64_t{7});
  pub_.publish(n);
}
}
PLUGINLIB_EXPORT_CLASS(vis::Shown, nodelet::Nodelet)
