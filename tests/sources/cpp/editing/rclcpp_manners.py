"""Small nodes of ROS 2 in C++, each in a manner of its own, that endpoints are added to."""

from __future__ import annotations

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
    "two constructors": """
#include <string>

#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/string.hpp>

class Sonar : public rclcpp::Node
{
public:
  explicit Sonar(const rclcpp::NodeOptions & options)
  : Node("sonar", options)
  {
    initialize();
  }

  Sonar(const std::string & name, const rclcpp::NodeOptions & options)
  : Node(name, options)
  {
    initialize();
  }

private:
  void initialize()
  {
    range_pub_ = create_publisher<std_msgs::msg::String>("range", 1);
  }

  rclcpp::Publisher<std_msgs::msg::String>::SharedPtr range_pub_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Sonar>(rclcpp::NodeOptions()));
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
