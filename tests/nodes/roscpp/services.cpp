#include <ros/ros.h>
#include <std_srvs/Empty.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>
#include <nav_msgs/GetMap.h>

class Caller {
 public:
  Caller() : nh_(), light_(nh_.serviceClient<std_srvs::SetBool>("light")) {
    map_ = nh_.serviceClient<nav_msgs::GetMap>("static_map", true);
    old_ = nh_.serviceClient<std_srvs::Empty::Request, std_srvs::Empty::Response>("old");
    server_ = nh_.advertiseService("switch", &Caller::Switch, this);
    typed_ = nh_.advertiseService<Caller, std_srvs::TriggerRequest, std_srvs::TriggerResponse>(
        "typed", &Caller::Typed, this);
    event_ = nh_.advertiseService("event", &Caller::Event, this);
    ros::service::waitForService("light", ros::Duration(2.0));
    light_.waitForExistence(ros::Duration(1));
  }

  bool Switch(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response) {
    std_srvs::SetBool srv;
    srv.request = request;
    if (!light_.exists() || !light_.call(srv)) return false;
    response = srv.response;
    return true;
  }
  bool Typed(std_srvs::TriggerRequest&, std_srvs::TriggerResponse&);
  bool Event(ros::ServiceEvent<std_srvs::Empty::Request, std_srvs::Empty::Response>&) { return true; }

 private:
  ros::NodeHandle nh_;
  ros::ServiceClient light_, map_, old_;
  ros::ServiceServer server_, typed_, event_;
};

bool Caller::Typed(std_srvs::TriggerRequest& req, std_srvs::TriggerResponse& res) {
  return true;
}

int main(int argc, char** argv) {
  ros::init(argc, argv, "services");
  Caller caller;
  ros::MultiThreadedSpinner spinner(2);
  spinner.spin();
}
