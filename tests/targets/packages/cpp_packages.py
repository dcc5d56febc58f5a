"""Packages of nodes in C++ that were written by hand, of each way to start one."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from made_packages import ADA, nodes_of, packages_of, with_types

from plastron_tui.diagnostics import Span
from plastron_tui.model.kinds.publisher import Publisher
from plastron_tui.model.workspace import Node
from plastron_tui.ros.interfaces import InterfaceName
from plastron_tui.sources import find_language
from plastron_tui.targets.packages import PackagedNode, PackageSpec

PYTHON = """\
create_node 'echo' as echo
subscribe echo to 'chatter' of message_type String
generate_node echo
"""

VALUE = ("value", "std_msgs/Float64")

_HEADER = """\
#ifndef {guard}
#define {guard}

#include {client}

namespace demo
{{

class Talker
{{
public:
  Talker();

private:
  void on_timer(const ros::TimerEvent &);

  ros::NodeHandle nh_;
  ros::Publisher publisher_;
  ros::Timer timer_;
}};

}}  // namespace demo

#endif  // {guard}
"""

_TALKER_1 = """\
#include "demo/talker.hpp"

#include <demo/Level.h>

namespace demo
{

Talker::Talker()
: publisher_(nh_.advertise<demo::Level>("level", 10)),
  timer_(nh_.createTimer(ros::Duration(0.1), &Talker::on_timer, this))
{
}

void Talker::on_timer(const ros::TimerEvent &)
{
  demo::Level message;
  message.value = 1.5;
  publisher_.publish(message);
}

}  // namespace demo

int main(int argc, char ** argv)
{
  ros::init(argc, argv, "talker");
  demo::Talker node;
  ros::spin();
  return 0;
}
"""

_RELAY_1 = """\
#include <demo/Level.h>
#include <nodelet/nodelet.h>
#include <pluginlib/class_list_macros.hpp>
#include <ros/ros.h>
#include <std_msgs/Float64.h>

namespace demo
{

class Relay : public nodelet::Nodelet
{
private:
  void onInit() override
  {
    publisher_ = getNodeHandle().advertise<std_msgs::Float64>("value", 10);
    subscription_ = getNodeHandle().subscribe("level", 10, &Relay::on_level, this);
  }

  void on_level(const demo::Level::ConstPtr & message)
  {
    std_msgs::Float64 value;
    value.data = message->value;
    publisher_.publish(value);
  }

  ros::Publisher publisher_;
  ros::Subscriber subscription_;
};

}  // namespace demo

PLUGINLIB_EXPORT_CLASS(demo::Relay, nodelet::Nodelet)
"""

_HEADER_2 = """\
#ifndef DEMO__TALKER_HPP_
#define DEMO__TALKER_HPP_

#include "demo/msg/level.hpp"
#include "rclcpp/rclcpp.hpp"

namespace demo
{

class Talker : public rclcpp::Node
{
public:
  Talker();

private:
  void on_timer();

  rclcpp::Publisher<demo::msg::Level>::SharedPtr publisher_;
  rclcpp::TimerBase::SharedPtr timer_;
};

}  // namespace demo

#endif  // DEMO__TALKER_HPP_
"""

_TALKER_2 = """\
#include "demo/talker.hpp"

#include <chrono>
#include <memory>

namespace demo
{

Talker::Talker()
: Node("talker")
{
  publisher_ = create_publisher<demo::msg::Level>("level", 10);
  timer_ = create_wall_timer(std::chrono::milliseconds(100), [this]() {on_timer();});
}

void Talker::on_timer()
{
  demo::msg::Level message;
  message.value = 1.5;
  publisher_->publish(message);
}

}  // namespace demo

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<demo::Talker>());
  rclcpp::shutdown();
  return 0;
}
"""

_RELAY_HEADER_2 = """\
#ifndef DEMO__RELAY_HPP_
#define DEMO__RELAY_HPP_

#include "demo/msg/level.hpp"
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/float64.hpp"

namespace demo
{

class Relay : public rclcpp::Node
{
public:
  explicit Relay(const rclcpp::NodeOptions & options);

private:
  void on_level(const demo::msg::Level & message);

  rclcpp::Publisher<std_msgs::msg::Float64>::SharedPtr publisher_;
  rclcpp::Subscription<demo::msg::Level>::SharedPtr subscription_;
};

}  // namespace demo

#endif  // DEMO__RELAY_HPP_
"""

_RELAY_2 = """\
#include "demo/relay.hpp"

#include "rclcpp_components/register_node_macro.hpp"

namespace demo
{

Relay::Relay(const rclcpp::NodeOptions & options)
: Node("relay", options)
{
  publisher_ = create_publisher<std_msgs::msg::Float64>("value", 10);
  subscription_ = create_subscription<demo::msg::Level>(
    "level", 10, [this](const demo::msg::Level & message) {on_level(message);});
}

void Relay::on_level(const demo::msg::Level & message)
{
  std_msgs::msg::Float64 value;
  value.data = message.value;
  publisher_->publish(value);
}

}  // namespace demo

RCLCPP_COMPONENTS_REGISTER_NODE(demo::Relay)
"""


def _node(
    name: str,
    library: str,
    text: str,
    header: str | None = None,
    plugin: str | None = None,
    sends: tuple[str, str] = ("level", "demo/Level"),
) -> PackagedNode:
    """Return a node by its files, and by the topic that it sends to."""
    topic, type_ = sends
    node = Node(name, name, Span(0, 0), library)
    node.put(Publisher(topic, InterfaceName(*type_.split("/"))))
    others = () if header is None else ((f"../include/demo/{name}.hpp", header.encode()),)
    return PackagedNode(
        name,
        name,
        text.encode(),
        node,
        find_language("cpp"),
        library,
        others=others,
        plugin=plugin,
    )


def ros1_package(folder: Path) -> PackageSpec:
    """Return a package with types, a program in two files, a nodelet and a script."""
    header = _HEADER.format(guard="DEMO_TALKER_HPP", client="<ros/ros.h>")
    nodes = (
        _node("talker", "roscpp", _TALKER_1, header),
        _node("relay", "nodelet", _RELAY_1, plugin="demo::Relay", sends=VALUE),
        *nodes_of(PYTHON, "rospy", folder),
    )
    return with_types(_spec(nodes, 1))


def ros2_package(folder: Path) -> PackageSpec:
    """Return a package with types, a program in two files, a script, and a component."""
    nodes = (
        _node("talker", "rclcpp", _TALKER_2, _HEADER_2),
        _node("relay", "component", _RELAY_2, _RELAY_HEADER_2, "demo::Relay", VALUE),
        *nodes_of(PYTHON, "rclpy", folder),
    )
    return replace(with_types(_spec(nodes, 2)), builds_types=True)


def plain_package(folder: Path) -> PackageSpec:
    """Return a package of ROS 2 with a program in two files and a script, and nothing else."""

    def plain(text: str) -> str:
        found = text.replace("demo/msg/level.hpp", "std_msgs/msg/float64.hpp")
        return found.replace("demo::msg::Level", "std_msgs::msg::Float64").replace(
            ".value", ".data"
        )

    sends = ("level", VALUE[1])
    talker = _node("talker", "rclcpp", plain(_TALKER_2), plain(_HEADER_2), sends=sends)
    return _spec((talker, *nodes_of(PYTHON, "rclpy", folder)), 2)


def _spec(nodes: tuple[PackagedNode, ...], version: int) -> PackageSpec:
    return PackageSpec(
        "demo",
        version,
        "Says and hears levels",
        ADA,
        "Apache-2.0",
        "0.1.0",
        nodes=nodes,
        packages=packages_of({1: "rospy", 2: "rclpy"}[version]),
    )
