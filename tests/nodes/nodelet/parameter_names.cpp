#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <pluginlib/class_list_macros.hpp>
#include <sensor_msgs/LaserScan.h>
#include <std_srvs/Trigger.h>

namespace filters {

class Decimate : public nodelet::Nodelet {
 protected:
  void onInit() override {
    ros::NodeHandle& pnh = getPrivateNodeHandle();
    std::string input = pnh.param<std::string>("input", "scan");
    pnh.param<std::string>("output", output_, kOutput);
    pnh.param("step", step_, 2);
    pnh.getParamCached("live", live_);
    sub_ = getNodeHandle().subscribe(input, 1, &Decimate::OnScan, this);
    pub_ = getNodeHandle().advertise<sensor_msgs::LaserScan>(output_, 1);
    if (pnh.hasParam("service")) {
      reset_ = pnh.advertiseService("reset", &Decimate::Reset, this);
    }
    pnh.setParam("ready", true);
  }

 private:
  static constexpr char kOutput[] = "scan_decimated";
  void OnScan(const sensor_msgs::LaserScanConstPtr& scan) { pub_.publish(scan); }
  bool Reset(std_srvs::Trigger::Request&, std_srvs::Trigger::Response&) { return true; }

  std::string output_;
  int step_;
  bool live_ = false;
  ros::Subscriber sub_;
  ros::Publisher pub_;
  ros::ServiceServer reset_;
};
constexpr char Decimate::kOutput[];

}  // namespace filters

PLUGINLIB_EXPORT_CLASS(filters::Decimate, nodelet::Nodelet)
