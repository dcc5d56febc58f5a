"""Small nodes of ROS 1 in C++, each in a manner of its own, that endpoints are added to."""

from __future__ import annotations

ROSCPP = {
    "class with members": """
#include <ros/ros.h>
#include <std_msgs/String.h>

class Talker
{
public:
  Talker() : private_nh_("~")
  {
    chatter_pub_ = nh_.advertise<std_msgs::String>("chatter", 10);
    mode_sub_ = nh_.subscribe("mode", 10, &Talker::modeCallback, this);
  }

private:
  void modeCallback(const std_msgs::String::ConstPtr& msg)
  {
    ROS_INFO_STREAM("mode: " << msg->data);
  }

  ros::NodeHandle nh_;
  ros::NodeHandle private_nh_;
  ros::Publisher chatter_pub_;
  ros::Subscriber mode_sub_;
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "talker");
  Talker talker;
  ros::spin();
  return 0;
}
""",
    "functions and main": """
#include "ros/ros.h"
#include "std_msgs/String.h"

void chatterCallback(const std_msgs::String::ConstPtr& msg)
{
  ROS_INFO("I heard: [%s]", msg->data.c_str());
}

int main(int argc, char **argv)
{
  ros::init(argc, argv, "listener");
  ros::NodeHandle n;
  ros::Subscriber sub = n.subscribe("chatter", 1000, chatterCallback);
  ros::spin();
  return 0;
}
""",
    "a loop of its own": """
#include <ros/ros.h>
#include <std_msgs/String.h>

int main(int argc, char **argv)
{
    ros::init(argc, argv, "talker");
    ros::NodeHandle nh;
    ros::Publisher pub = nh.advertise<std_msgs::String>("chatter", 1000);
    ros::Rate loop_rate(10);
    while (ros::ok()) {
        std_msgs::String msg;
        msg.data = "hello";
        pub.publish(msg);
        ros::spinOnce();
        loop_rate.sleep();
    }
    return 0;
}
""",
    "header with namespace": """
#include "x.hpp"

namespace drive
{

Driver::Driver(ros::NodeHandle nh, ros::NodeHandle pnh) : m_nh(nh), m_pnh(pnh) {
    m_pubState = m_nh.advertise<std_msgs::String>("state", 1);
    m_subSpeed = m_nh.subscribe<std_msgs::Float64>(
        "speed", 1, boost::bind(&Driver::onSpeed, this, boost::placeholders::_1));
    m_timer = m_nh.createTimer(ros::Duration(0.5), &Driver::onTimer, this);
}

void Driver::onSpeed(const std_msgs::Float64ConstPtr &speed) {
    m_speed = speed->data;
}

void Driver::onTimer(const ros::TimerEvent &) {
    std_msgs::String state;
    state.data = m_speed > 0 ? "on" : "off";
    m_pubState.publish(state);
}

}  // namespace drive

int main(int argc, char **argv) {
    ros::init(argc, argv, "driver");
    drive::Driver driver(ros::NodeHandle(), ros::NodeHandle("~"));
    ros::spin();
}
=== x.hpp
#ifndef DRIVE_DRIVER_HPP
#define DRIVE_DRIVER_HPP

#include <ros/ros.h>
#include <std_msgs/Float64.h>
#include <std_msgs/String.h>

namespace drive
{

class Driver {
public:
    Driver(ros::NodeHandle nh, ros::NodeHandle pnh);

private:
    void onSpeed(const std_msgs::Float64ConstPtr &speed);
    void onTimer(const ros::TimerEvent &);

    ros::NodeHandle m_nh;
    ros::NodeHandle m_pnh;
    ros::Publisher m_pubState;
    ros::Subscriber m_subSpeed;
    ros::Timer m_timer;
    double m_speed = 0.0;
};

}  // namespace drive

#endif
""",
    "nodelet": """
#include <nodelet/nodelet.h>
#include <pluginlib/class_list_macros.hpp>
#include <ros/ros.h>
#include <std_msgs/Bool.h>

namespace lamps {

class LampNodelet : public nodelet::Nodelet {
 private:
  void onInit() override {
    ros::NodeHandle& nh = getNodeHandle();
    ros::NodeHandle& private_nh = getPrivateNodeHandle();
    private_nh.param("dim", dim_, 0.5);
    switch_sub_ = nh.subscribe("switch", 1, &LampNodelet::SwitchCb, this);
  }

  void SwitchCb(const std_msgs::BoolConstPtr& msg) {
    NODELET_INFO("switch: %d", msg->data);
  }

  double dim_;
  ros::Subscriber switch_sub_;
};

}  // namespace lamps

PLUGINLIB_EXPORT_CLASS(lamps::LampNodelet, nodelet::Nodelet)
""",
    "variables of the file": """
#include <ros/ros.h>
#include <std_msgs/Int32.h>

ros::Publisher count_pub;
int count = 0;

void inCb(const std_msgs::Int32& msg) {
	count += msg.data;
	std_msgs::Int32 out;
	out.data = count;
	count_pub.publish(out);
}

int main(int argc, char** argv) {
	ros::init(argc, argv, "counter");
	ros::NodeHandle nh;
	count_pub = nh.advertise<std_msgs::Int32>("count", 5);
	ros::Subscriber in_sub = nh.subscribe("in", 5, inCb);
	ros::spin();
}
""",
    "initializers and services": """
#include <ros/ros.h>
#include <std_srvs/Trigger.h>

class Gate {
 public:
  explicit Gate(ros::NodeHandle* nh)
      : nh_(*nh), open_server_(nh_.advertiseService("open", &Gate::HandleOpen, this)) {}

 private:
  bool HandleOpen(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response) {
    response.success = true;
    (void)request;
    return true;
  }

  ros::NodeHandle nh_;
  ros::ServiceServer open_server_;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "gate");
  ros::NodeHandle nh("~");
  Gate gate(&nh);
  ros::spin();
}
""",
    "a pointer to a handle": """
#include <ros/ros.h>
#include <std_msgs/String.h>

class Speaker
{
    boost::shared_ptr<ros::NodeHandle> nh;
    ros::Publisher word_pub;

  public:
    Speaker() : nh(new ros::NodeHandle)
    {
        setup();
    }

    void setup()
    {
        word_pub = nh->advertise<std_msgs::String>("word", 1, true);
    }
};

int main(int argc, char **argv)
{
    ros::init(argc, argv, "speaker");
    Speaker speaker;
    ros::spin();
}
""",
    "nothing yet": """
#include <ros/ros.h>

int main(int argc, char** argv)
{
  ros::init(argc, argv, "empty");
  ros::NodeHandle nh;
  ros::spin();
  return 0;
}
""",
}
"""Nodes of ROS 1."""
