#ifndef DOCKING_H
#define DOCKING_H

#include <actionlib/TestAction.h>
#include <actionlib/TwoIntsAction.h>
#include <actionlib/client/simple_action_client.h>
#include <actionlib/server/simple_action_server.h>
#include <nav_msgs/GetMapAction.h>
#include <ros/ros.h>
#include <sensor_msgs/BatteryState.h>

#include <memory>

class Docking
{
  typedef actionlib::TestGoalConstPtr GoalPtr;
  typedef actionlib::SimpleActionServer<actionlib::TestAction> Server;

public:
  Docking();

private:
  void execute(const GoalPtr &goal);
  void goal();
  void battery(const sensor_msgs::BatteryState &state);

  ros::NodeHandle nh_;
  Server server_;
  actionlib::SimpleActionClient<actionlib::TwoIntsAction> test_client_;
  std::unique_ptr<actionlib::SimpleActionServer<nav_msgs::GetMapAction>> planner_;
  ros::Subscriber battery_;
};

#endif
