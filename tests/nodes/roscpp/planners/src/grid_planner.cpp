#include "planners/grid_planner.h"

namespace planners
{
GridPlanner::GridPlanner() : PlannerBase("grid")
{
  goal_sub_ = nh_.subscribe("goal", 1, &GridPlanner::goalCb, this);
  cost_pub_ = pnh_.advertise<nav_msgs::OccupancyGrid>("cost", 1, true);
}

void GridPlanner::goalCb(const geometry_msgs::PoseStamped::ConstPtr& goal)
{
  nav_msgs::Path path;
  path.poses.push_back(*goal);
  path_pub_.publish(path);
}
}  // namespace planners

int main(int argc, char** argv)
{
  ros::init(argc, argv, "planner");
  planners::GridPlanner planner;
  ros::spin();
}
