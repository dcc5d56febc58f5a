"""What is taken out of nodes of roscpp and nodelets with an endpoint."""

from __future__ import annotations

import pytest
from patches import check

from plastron_tui.model.source import EndpointKind, Remove

K = EndpointKind

REMOVALS = [
    (
        "what a label stands before",
        K.PUBLISHER,
        "chatter",
        """
 #include <ros/ros.h>
-#include <std_msgs/String.h>

-ros::Publisher pub;
-
 void send(int kind) {
   switch (kind) {
-    case 0: pub.publish(std_msgs::String()); break;
+    case 0: break;
-    case 1: pub.publish(std_msgs::String());
+    case 1:
     case 2: return;
-    default: pub.publish(std_msgs::String());
+    default: {}
   }
 }

 int main(int argc, char** argv) {
   ros::init(argc, argv, "n");
   ros::NodeHandle nh;
-  pub = nh.advertise<std_msgs::String>("chatter", 10);
   send(argc);
   ros::spin();
 }
""",
    ),
    (
        "a local publisher in main with its loop",
        K.PUBLISHER,
        "chatter",
        """
 #include <ros/ros.h>
-#include <std_msgs/String.h>

 int main(int argc, char ** argv)
 {
   ros::init(argc, argv, "talker");
   ros::NodeHandle nh;
-  ros::Publisher pub = nh.advertise<std_msgs::String>("chatter", 10);  // talks
   ros::Rate rate(5);
   while (ros::ok()) {
-    std_msgs::String msg;
-    msg.data = "hello";
-    pub.publish(msg);
     ros::spinOnce();
     rate.sleep();
   }
 }
""",
    ),
    (
        "a global publisher, assigned in main, used in a callback with a guard",
        K.PUBLISHER,
        "out",
        """
 #include <ros/ros.h>
 #include <std_msgs/String.h>

-// where it goes
-ros::Publisher pub;
-
 int count = 0;

-void heard(const std_msgs::String::ConstPtr& msg) {
+void heard(const std_msgs::String::ConstPtr& /*msg*/) {
   count++;
-  if (pub.getNumSubscribers() > 0) {
-    pub.publish(msg);
-  }
 }

 int main(int argc, char** argv) {
   ros::init(argc, argv, "relay");
   ros::NodeHandle nh;
-  pub = nh.advertise<std_msgs::String>("out", 10);
   ros::Subscriber sub = nh.subscribe("in", 10, heard);
   ros::spin();
 }
""",
    ),
    (
        "a stub callback that nothing else calls, of a local subscriber",
        K.SUBSCRIPTION,
        "in",
        """
 #include <ros/ros.h>
-#include <std_msgs/String.h>
 #include <std_msgs/Int32.h>

-void onIn(const std_msgs::String::ConstPtr& msg)
-{
-  ROS_INFO("in");
-}
-
 void onCount(const std_msgs::Int32& msg)
 {
   ROS_INFO("count");
 }

 int main(int argc, char** argv)
 {
   ros::init(argc, argv, "ears");
   ros::NodeHandle nh;
-  ros::Subscriber in = nh.subscribe("in", 10, &onIn);
   ros::Subscriber count = nh.subscribe("count", 10, &onCount);
   ros::spin();
 }
""",
    ),
    (
        "a header pair: member, declaration of the callback, its definition, the includes",
        K.SUBSCRIPTION,
        "goal",
        """
 #include "x.hpp"

 namespace robot
 {

 Robot::Robot(ros::NodeHandle & nh)
 {
-  goal_sub_ = nh.subscribe("goal", 1, &Robot::onGoal, this);
   pose_pub_ = nh.advertise<geometry_msgs::PoseStamped>("pose", 1);
 }

-void Robot::onGoal(const std_msgs::String::ConstPtr & msg)
-{
-  ROS_INFO_STREAM("goal: " << *msg);
-}
-
 void Robot::send()
 {
   pose_pub_.publish(geometry_msgs::PoseStamped());
 }

 }  // namespace robot

 int main(int argc, char ** argv)
 {
   ros::init(argc, argv, "robot");
   ros::NodeHandle nh;
   robot::Robot robot(nh);
   ros::spin();
 }
=== x.hpp
 #pragma once

 #include <geometry_msgs/PoseStamped.h>
 #include <ros/ros.h>
-#include <std_msgs/String.h>

 namespace robot
 {

 class Robot
 {
 public:
   explicit Robot(ros::NodeHandle & nh);

 private:
-  void onGoal(const std_msgs::String::ConstPtr & msg);
   void send();

-  ros::Subscriber goal_sub_;  ///< where to go
   ros::Publisher pose_pub_;
 };

 }  // namespace robot
""",
    ),
    (
        "one declarator of several, the first",
        K.PUBLISHER,
        "a",
        """
 #include <ros/ros.h>
 #include <std_msgs/String.h>
 class Two {
   ros::NodeHandle nh_;
-  ros::Publisher a_, b_;
+  ros::Publisher b_;
  public:
   Two() {
-    a_ = nh_.advertise<std_msgs::String>("a", 1);
     b_ = nh_.advertise<std_msgs::String>("b", 1);
   }
 };
 int main(int c, char** v) { ros::init(c, v, "two"); Two two; ros::spin(); }
""",
    ),
    (
        "one declarator of several, the last, over two lines",
        K.PUBLISHER,
        "b",
        """
 #include <ros/ros.h>
 #include <std_msgs/String.h>
 class Two {
   ros::NodeHandle nh_;
-  ros::Publisher a_,
-                 b_;
+  ros::Publisher a_;
  public:
   Two() {
     a_ = nh_.advertise<std_msgs::String>("a", 1);
-    b_ = nh_.advertise<std_msgs::String>("b", 1);
   }
 };
 int main(int c, char** v) { ros::init(c, v, "two"); Two two; ros::spin(); }
""",
    ),
    (
        "an entry of an initializer list in the middle, one on each line",
        K.PUBLISHER,
        "b",
        """
 #include <ros/ros.h>
 #include <std_msgs/String.h>
 class Node
 {
 public:
   Node()
   : nh_(),
-    pub_(nh_.advertise<std_msgs::String>("b", 1)),
     count_(0)
   {
   }

 private:
   ros::NodeHandle nh_;
-  ros::Publisher pub_;
   int count_;
   std_msgs::String last_;
 };
 int main(int c, char** v) { ros::init(c, v, "n"); Node node; ros::spin(); }
""",
    ),
    (
        "an entry of an initializer list that is the last of it, commas first",
        K.SUBSCRIPTION,
        "in",
        """
 #include <ros/ros.h>
 #include <std_msgs/String.h>
 class Node
 {
 public:
   Node()
     : count_(0)
-    , sub_(nh_.subscribe("in", 1, &Node::heard, this))
   {
   }

   void heard(const std_msgs::String& msg) { last_ = msg; }

 private:
   int count_;
   std_msgs::String last_;
   ros::NodeHandle nh_;
-  ros::Subscriber sub_;
 };
 int main(int c, char** v) { ros::init(c, v, "n"); Node node; ros::spin(); }
""",
    ),
    (
        "a nodelet with the members in its class, and a stub of its own",
        K.SERVICE,
        "clear",
        """
 #include <nodelet/nodelet.h>
 #include <pluginlib/class_list_macros.h>
 #include <ros/ros.h>
-#include <std_srvs/Empty.h>

 namespace maps
 {
 class Map : public nodelet::Nodelet
 {
 private:
   void onInit() override
   {
     ros::NodeHandle& nh = getNodeHandle();
-    clear_service_ = nh.advertiseService("clear", &Map::onClear, this);
     timer_ = nh.createTimer(ros::Duration(1.0), &Map::tick, this);
   }

-  bool onClear(std_srvs::Empty::Request& request, std_srvs::Empty::Response& response)
-  {
-    NODELET_INFO("clear");
-    return true;
-  }
-
   void tick(const ros::TimerEvent&) { count_++; }

-  ros::ServiceServer clear_service_;
   ros::Timer timer_;
   int count_ = 0;
 };
 }  // namespace maps

 PLUGINLIB_EXPORT_CLASS(maps::Map, nodelet::Nodelet)
""",
    ),
    (
        "a client of a service, and what calls it",
        K.TIMER,
        "tick",
        """
 #include <ros/ros.h>

-void tick(const ros::TimerEvent& event)
-{
-  ROS_INFO("tick");
-}
-
 int main(int argc, char** argv)
 {
   ros::init(argc, argv, "clock");
   ros::NodeHandle nh;
-  ros::Timer timer = nh.createTimer(ros::Duration(0.5), tick);
   ros::spin();
 }
""",
    ),
]


@pytest.mark.parametrize(("kind", "name", "patch"), [each[1:] for each in REMOVALS],
                         ids=[each[0] for each in REMOVALS])  # fmt: skip
def test_a_removal_takes_what_served_the_endpoint(
    kind: EndpointKind, name: str, patch: str
) -> None:
    check(patch, Remove(kind, name))
