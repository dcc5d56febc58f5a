#ifndef ACTIONLIB_WATCH_WATCH_H
#define ACTIONLIB_WATCH_WATCH_H
#include <actionlib/TestAction.h>
#include <actionlib/TestRequestAction.h>
#include <actionlib/client/simple_action_client.h>
#include <ros/ros.h>

namespace actionlib_watch
{
using namespace actionlib;

class Watch
{
public:
  Watch();

private:
  void goal(const actionlib::TestRequestActionGoal::ConstPtr& goal);

  ros::NodeHandle nh_;
  SimpleActionClient<TestAction> ac_;
  ros::Subscriber goals_;
  ros::Publisher request_, result_;
};
}
#endif
