#include <ros/ros.h>
#include <actionlib/client/simple_action_client.h>
#include <actionlib/client/terminal_state.h>
#include <actionlib/TwoIntsAction.h>
#include <actionlib/TestAction.h>

typedef actionlib::SimpleActionClient<actionlib::TwoIntsAction> Client;

void doneCb(const actionlib::SimpleClientGoalState& state, const actionlib::TwoIntsResultConstPtr& result) {}

int main (int argc, char **argv)
{
  ros::init(argc, argv, "two_ints_client");

  Client ac("add", true);
  actionlib::SimpleActionClient<actionlib::TestAction> *test =
    new actionlib::SimpleActionClient<actionlib::TestAction>("test", true);

  ROS_INFO("Waiting for action server to start.");
  ac.waitForServer(ros::Duration(5.0));

  actionlib::TwoIntsGoal goal;
  ac.sendGoal(goal, &doneCb);
  if (ac.waitForResult(ros::Duration(30.0)))
    ROS_INFO("Action finished: %s", ac.getState().toString().c_str());
  else
    ROS_INFO("Action did not finish before the time out.");
  delete test;
  return 0;
}
