#include <actionlib/server/simple_action_server.h>
#include <actionlib/TwoIntsAction.h>
#include <ros/ros.h>

class Adder
{
protected:
  ros::NodeHandle nh_;
  // the handle must come first
  actionlib::SimpleActionServer<actionlib::TwoIntsAction> as_;
  std::string action_name_;
  actionlib::TwoIntsResult result_;

public:
  Adder(std::string name) :
    as_(nh_, name, boost::bind(&Adder::executeCB, this, boost::placeholders::_1), false),
    action_name_(name)
  {
    as_.registerPreemptCallback(boost::bind(&Adder::preempt, this));
    as_.start();
  }

  void executeCB(const actionlib::TwoIntsGoalConstPtr &goal)
  {
    ROS_INFO("%s: executing", action_name_.c_str());
    as_.setSucceeded(result_);
  }

  void preempt() { as_.setPreempted(); }
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "two_ints");
  Adder adder("add");
  ros::spin();
  return 0;
}
