#ifndef NAVIGATION_H_
#define NAVIGATION_H_

#include <string>
#include <boost/bind.hpp>
#include <ros/ros.h>
#include <actionlib/TestAction.h>
#include <actionlib/server/simple_action_server.h>
#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/Twist.h>
#include <message_filters/subscriber.h>
#include <nav_msgs/GetPlan.h>
#include <sensor_msgs/LaserScan.h>

namespace navigation {
  typedef actionlib::SimpleActionServer<actionlib::TestAction> NavigationServer;

  /**
   * @class Navigation
   * @brief Moves the base to where `goal` says.
   */
  class Navigation {
    public:
      Navigation();
      virtual ~Navigation();

    private:
      void goalCB(const geometry_msgs::PoseStamped::ConstPtr& goal);
      bool planService(nav_msgs::GetPlan::Request &req, nav_msgs::GetPlan::Response &resp);
      void executeCb(const actionlib::TestGoalConstPtr& goal);
      void scanCb(const sensor_msgs::LaserScan::ConstPtr& scan);

      NavigationServer* as_;
      message_filters::Subscriber<sensor_msgs::LaserScan>* scan_filter_sub_;
      ros::Publisher vel_pub_, current_goal_pub_, action_goal_pub_;
      ros::Subscriber goal_sub_;
      ros::ServiceServer make_plan_srv_;
      std::string base_frame_;
      double frequency_;
      bool running_;
  };
};
#endif
