#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <nav_msgs/OccupancyGrid.h>

#include "planners/planner_base.h"

namespace planners
{
class GridPlanner : public PlannerBase
{
public:
  GridPlanner();

private:
  void goalCb(const geometry_msgs::PoseStamped::ConstPtr& goal);

  ros::Subscriber goal_sub_;
  ros::Publisher cost_pub_;
};
}  // namespace planners
