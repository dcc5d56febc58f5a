"""Small C++ nodes, each in a manner of its own, that endpoints are added to.

A line `=== x.hpp` begins the header of a node; the first text is its source.
"""

from __future__ import annotations

from plastron_tui.model.source import FileSet

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

RCLCPP = {
    "class with members": """
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"

class Talker : public rclcpp::Node
{
public:
  Talker()
  : Node("talker")
  {
    chatter_pub_ = create_publisher<std_msgs::msg::String>("chatter", 10);
    mode_sub_ = create_subscription<std_msgs::msg::String>(
      "mode", 10, std::bind(&Talker::on_mode, this, std::placeholders::_1));
  }

private:
  void on_mode(const std_msgs::msg::String::SharedPtr msg)
  {
    RCLCPP_INFO(get_logger(), "mode: %s", msg->data.c_str());
  }

  rclcpp::Publisher<std_msgs::msg::String>::SharedPtr chatter_pub_;
  rclcpp::Subscription<std_msgs::msg::String>::SharedPtr mode_sub_;
};

int main(int argc, char * argv[])
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Talker>());
  rclcpp::shutdown();
  return 0;
}
""",
    "this and placeholders": """
#include <chrono>
#include <functional>
#include <memory>
#include <string>

#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/string.hpp>

using namespace std::chrono_literals;
using std::placeholders::_1;

class MinimalNode : public rclcpp::Node
{
  public:
    MinimalNode()
    : Node("minimal_node"), count_(0)
    {
      publisher_ = this->create_publisher<std_msgs::msg::String>("topic", 10);
      subscription_ = this->create_subscription<std_msgs::msg::String>(
      "in", 10, std::bind(&MinimalNode::topic_callback, this, _1));
      timer_ = this->create_wall_timer(
      500ms, std::bind(&MinimalNode::timer_callback, this));
    }

  private:
    void timer_callback()
    {
      auto message = std_msgs::msg::String();
      message.data = "Hello, world! " + std::to_string(count_++);
      publisher_->publish(message);
    }
    void topic_callback(const std_msgs::msg::String & msg) const
    {
      RCLCPP_INFO_STREAM(this->get_logger(), "I heard: " << msg.data);
    }
    rclcpp::TimerBase::SharedPtr timer_;
    rclcpp::Publisher<std_msgs::msg::String>::SharedPtr publisher_;
    rclcpp::Subscription<std_msgs::msg::String>::SharedPtr subscription_;
    size_t count_;
};

int main(int argc, char * argv[])
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<MinimalNode>());
  rclcpp::shutdown();
  return 0;
}
""",
    "header with namespace": """
#include "x.hpp"

namespace drive {

DriveNode::DriveNode(const rclcpp::NodeOptions& options) : rclcpp::Node("drive", options) {
    state_publisher_ = create_publisher<std_msgs::msg::String>("state", rclcpp::QoS(1));
    speed_subscriber_ = create_subscription<std_msgs::msg::Float64>(
        "speed", rclcpp::QoS(1),
        [this](const std_msgs::msg::Float64::ConstSharedPtr msg) { onSpeed(msg); });
}

void DriveNode::onSpeed(const std_msgs::msg::Float64::ConstSharedPtr& msg) {
    RCLCPP_INFO(logger_, "speed: %f", msg->data);
}

}  // namespace drive
=== x.hpp
#pragma once

#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/float64.hpp>
#include <std_msgs/msg/string.hpp>

namespace drive {

class DriveNode : public rclcpp::Node {
public:
    explicit DriveNode(const rclcpp::NodeOptions& options);

private:
    void onSpeed(const std_msgs::msg::Float64::ConstSharedPtr& msg);

    rclcpp::Logger logger_ = get_logger();
    rclcpp::Publisher<std_msgs::msg::String>::SharedPtr state_publisher_;
    rclcpp::Subscription<std_msgs::msg::Float64>::SharedPtr speed_subscriber_;
};

}  // namespace drive
""",
    "functions and main": """
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"

rclcpp::Node::SharedPtr g_node = nullptr;

void topic_callback(const std_msgs::msg::String::SharedPtr msg)
{
  RCLCPP_INFO(g_node->get_logger(), "I heard: '%s'", msg->data.c_str());
}

int main(int argc, char * argv[])
{
  rclcpp::init(argc, argv);
  g_node = rclcpp::Node::make_shared("listener");
  auto subscription =
    g_node->create_subscription<std_msgs::msg::String>("topic", 10, topic_callback);
  rclcpp::spin(g_node);
  rclcpp::shutdown();
  return 0;
}
""",
    "a node of main": """
#include <rclcpp/rclcpp.hpp>

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("lonely");
  rclcpp::spin(node);
  rclcpp::shutdown();
  return 0;
}
""",
    "underscores in front": """
#include <rclcpp/rclcpp.hpp>
#include <std_srvs/srv/trigger.hpp>

class Gate : public rclcpp::Node {
	rclcpp::Service<std_srvs::srv::Trigger>::SharedPtr _openService;

	void handleOpen(
		const std::shared_ptr<std_srvs::srv::Trigger::Request> req,
		std::shared_ptr<std_srvs::srv::Trigger::Response> res)
	{
		(void)req;
		res->success = true;
	}

public:
	Gate() : Node("gate") {
		using namespace std::placeholders;
		_openService = create_service<std_srvs::srv::Trigger>(
			"open", std::bind(&Gate::handleOpen, this, _1, _2));
	}
};

int main(int argc, char** argv) {
	rclcpp::init(argc, argv);
	rclcpp::spin(std::make_shared<Gate>());
	rclcpp::shutdown();
}
""",
    "nothing yet": """
#include <memory>

#include "rclcpp/rclcpp.hpp"

class Empty : public rclcpp::Node
{
public:
  Empty() : Node("empty") {}
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Empty>());
  rclcpp::shutdown();
}
""",
    "parameters and pointers": """
#include <memory>
#include <string>

#include "geometry_msgs/msg/twist.hpp"
#include "rclcpp/rclcpp.hpp"

namespace wheels
{
using geometry_msgs::msg::Twist;

class Wheels final : public rclcpp::Node
{
public:
  explicit Wheels(const rclcpp::NodeOptions & options = rclcpp::NodeOptions())
  : rclcpp::Node("wheels", options)
  {
    gain_ = this->declare_parameter<double>("gain", 1.0);
    sub_twist_ = this->create_subscription<Twist>(
      "cmd_vel", rclcpp::SensorDataQoS(),
      std::bind(&Wheels::onTwist, this, std::placeholders::_1));
  }

private:
  void onTwist(Twist::UniquePtr twist)
  {
    RCLCPP_DEBUG(this->get_logger(), "%f", gain_ * twist->linear.x);
  }

  double gain_;
  rclcpp::Subscription<Twist>::SharedPtr sub_twist_;
};
}  // namespace wheels

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<wheels::Wheels>());
  rclcpp::shutdown();
}
""",
}
"""Nodes of ROS 2."""


def files(text: str) -> FileSet:
    """Return the files of a node."""
    source, *headers = text.removeprefix("\n").split("=== ")
    others = [each.split("\n", 1) for each in headers]
    return FileSet((("{}.cpp", source.encode()), *((n, each.encode()) for n, each in others)))
