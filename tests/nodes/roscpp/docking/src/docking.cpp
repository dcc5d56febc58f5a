#include "docking/docking.h"

Docking::Docking()
  : server_(nh_, "dock", [this](const GoalPtr &goal) { execute(goal); }, false)
  , test_client_("undock", true)
{
  battery_ = nh_.subscribe("battery", 1, &Docking::battery, this);
  planner_.reset(new actionlib::SimpleActionServer<nav_msgs::GetMapAction>(nh_, "plan", false));
  planner_->registerGoalCallback(boost::bind(&Docking::goal, this));
  planner_->start();
  server_.start();
}

void Docking::execute(const GoalPtr &) { server_.setSucceeded(); }
void Docking::goal() { planner_->acceptNewGoal(); }
void Docking::battery(const sensor_msgs::BatteryState &) {}

int main(int argc, char **argv)
{
  ros::init(argc, argv, "docking");
  Docking docking;
  ros::spin();
}
