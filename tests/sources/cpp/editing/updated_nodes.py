"""Nodes that updates change in tests, and patches of their lines."""

from __future__ import annotations

PAIR = """
 #include "x.hpp"

 Robot::Robot() : Node("robot")
 {
   goal_ = create_subscription<std_msgs::msg::String>(
     "goal", 3, std::bind(&Robot::on_goal, this, std::placeholders::_1));  // where to go
   out_ = create_publisher<geometry_msgs::msg::PoseStamped>("out", 1);
 }

 void Robot::on_goal(const std_msgs::msg::String::SharedPtr msg)
 {
   RCLCPP_INFO(get_logger(), "goal");
   (void)msg;
 }
=== x.hpp
 #pragma once
 #include <geometry_msgs/msg/pose_stamped.hpp>
 #include <rclcpp/rclcpp.hpp>
 #include <std_msgs/msg/string.hpp>

 class Robot : public rclcpp::Node
 {
 public:
   Robot();

 private:
   void on_goal(const std_msgs::msg::String::SharedPtr msg);
   void on_other(const std_msgs::msg::String::SharedPtr msg);
   rclcpp::Subscription<std_msgs::msg::String>::SharedPtr goal_;
   rclcpp::Publisher<geometry_msgs::msg::PoseStamped>::SharedPtr out_;
 };
"""

ROS1 = """
 #include <ros/ros.h>
 #include <std_msgs/String.h>
 #include <std_srvs/Trigger.h>

 class Robot {
  public:
   Robot() {
     goal_ = nh_.subscribe("goal", 3, &Robot::onGoal, this);
     out_ = nh_.advertise<std_msgs::String>("out", 5);
     srv_ = nh_.advertiseService("stop", &Robot::stop, this);
     timer_ = nh_.createTimer(ros::Duration(0.5), &Robot::tick, this);
     nh_.param<std::string>("frame", frame_, "map");
     speed_ = nh_.param("speed", 1.5);
   }

   void onGoal(const std_msgs::StringConstPtr& msg) { goal_text_ = msg->data; }

   bool stop(std_srvs::Trigger::Request& req, std_srvs::Trigger::Response& res) {
     ROS_INFO("stop");
     return true;
   }

   void tick(const ros::TimerEvent&) {
     std_msgs::String text;
     text.data = "here";
     out_.publish(text);
   }

  private:
   ros::NodeHandle nh_;
   ros::Subscriber goal_;
   ros::Publisher out_;
   ros::ServiceServer srv_;
   ros::Timer timer_;
   std::string frame_, goal_text_;
   double speed_;
 };

 int main(int argc, char** argv) {
   ros::init(argc, argv, "robot");
   Robot robot;
   ros::spin();
 }
"""


def patched(text: str, *edits: tuple[str, str | None]) -> str:
    """Return a patch of a text that changes lines of it."""
    for old, new in edits:
        lines = [line for line in text.split("\n") if line.removeprefix(" ") == old]
        assert len(lines) == 1, (old, lines)
        put = "" if new is None else "".join(f"\n+{line}" for line in new.split("\n"))
        text = text.replace(f" {old}\n", f"-{old}{put}\n", 1)
    return text
