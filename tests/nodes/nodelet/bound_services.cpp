#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <pluginlib/class_list_macros.hpp>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

namespace srv {

class Doors : public nodelet::Nodelet {
 public:
  void onInit() override {
    ros::NodeHandle pnh(getPrivateNodeHandle(), "door");
    open_ = pnh.advertiseService<std_srvs::Trigger::Request, std_srvs::Trigger::Response>("open", boost::bind(&Doors::Move, this, boost::placeholders::_1, boost::placeholders::_2, true));
    close_ = pnh.advertiseService<std_srvs::Trigger::Request, std_srvs::Trigger::Response>("close", boost::bind(&Doors::Move, this, boost::placeholders::_1, boost::placeholders::_2, false));
    lock_ = getNodeHandle().advertiseService("lock", Lock);
    ros::ServiceClient power = getNodeHandle().serviceClient<std_srvs::SetBool>("power");
    std_srvs::SetBool on;
    on.request.data = true;
    if (!power.waitForExistence(ros::Duration(1.0)) || !power.call(on)) NODELET_ERROR("no power");
  }

 private:
  bool Move(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response, bool open) {
    response.success = open;
    return true;
  }
  static bool Lock(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response) {
    response.success = request.data;
    return true;
  }
  ros::ServiceServer open_, close_, lock_;
};

}  // namespace srv

PLUGINLIB_EXPORT_CLASS(srv::Doors, nodelet::Nodelet)
