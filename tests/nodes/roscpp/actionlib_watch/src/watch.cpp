#include <actionlib_watch/watch.h>

namespace actionlib_watch
{
Watch::Watch() : ac_("run", false)
{
  goals_ = nh_.subscribe("run/goal", 5, &Watch::goal, this);
  request_ = nh_.advertise<actionlib::TestRequestGoal>("request", 5);
  result_ = nh_.advertise<TestRequestResult>("result", 5);
}

void Watch::goal(const actionlib::TestRequestActionGoal::ConstPtr& goal)
{
  request_.publish(goal->goal);
}
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "actionlib_watch");
  actionlib_watch::Watch watch;
  ros::spin();
}
