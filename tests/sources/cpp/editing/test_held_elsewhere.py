"""Endpoints that containers, local variables and other classes hold."""

from __future__ import annotations

import pytest
from additions import publish
from patches import check, edit, refusal, sides

from plastron_tui.diagnostics import Span
from plastron_tui.model.kinds import Subscription
from plastron_tui.model.source import EndpointKind, Remove, Update
from plastron_tui.ros.interfaces import InterfaceName

K = EndpointKind

FLEET = """
 #include <rclcpp/rclcpp.hpp>
 #include <std_msgs/msg/string.hpp>

 class Fleet : public rclcpp::Node
 {
 public:
   Fleet() : Node("fleet")
   {
-    pubs_.push_back(create_publisher<std_msgs::msg::String>("left", 10));
     pubs_.push_back(create_publisher<std_msgs::msg::String>("right", 10));
   }

   void send(const std_msgs::msg::String & text)
   {
     USES
   }

 private:
   std::vector<rclcpp::Publisher<std_msgs::msg::String>::SharedPtr> pubs_;
 };
"""

RELAY = """
 #include <ros/ros.h>
 #include <std_msgs/String.h>

 class Relay {
  public:
   Relay() { sub_ = nh_.subscribe("in", 1, &Relay::heard, this); }

   void heard(const std_msgs::String& msg) {
     static ros::Publisher pub = nh_.advertise<std_msgs::String>("out", 1);
     pub.publish(msg);
   }

  private:
   ros::NodeHandle nh_;
   ros::Subscriber sub_;
 };
"""

HIDDEN = """
 #include <ros/ros.h>
 #include <std_msgs/Bool.h>

 class Teleop {
  public:
   explicit Teleop(ros::NodeHandle* nh) {
     impl_ = new Impl;
     pub_ = nh->advertise<std_msgs::Bool>("out", 1);
     impl_->sub = nh->subscribe<std_msgs::Bool>("in", 1, &Teleop::Impl::heard, impl_);
   }

  private:
   struct Impl {
     void heard(const std_msgs::Bool::ConstPtr& msg) { use(msg->data); }
     ros::Subscriber sub;
   };
   Impl* impl_;
   ros::Publisher pub_;
 };
"""


@pytest.mark.parametrize(
    "uses",
    [
        "for (auto & each : pubs_) {each->publish(text);}",
        "for (auto & each : this->pubs_) {each->publish(text);}",
        "pubs_.clear();",
    ],
)
def test_one_of_those_that_all_get_the_same_goes(uses: str) -> None:
    check(FLEET.replace("USES", uses), Remove(K.PUBLISHER, "left"))


def test_one_that_has_a_number_stays() -> None:
    text = FLEET.replace("USES", "pubs_[0]->publish(text);")
    assert refusal(text, Remove(K.PUBLISHER, "left")) == (
        "endpoint-in-use: the publisher `left` is used in line 15"
    )


def test_what_is_handed_to_something_else_stays() -> None:
    text = FLEET.replace("pubs_.push_back(", "keep(").replace("USES", "use(text);")
    assert "line 9" in refusal(text, Remove(K.PUBLISHER, "left"))


def test_nothing_is_sent_through_a_variable_of_a_callback() -> None:
    assert "no variable of the file holds `out`" in refusal(RELAY, publish("out", data="hi"))


def test_a_callback_of_another_class_is_not_written_into_this_one() -> None:
    string = InterfaceName("std_msgs", "String")
    change = Update(K.SUBSCRIPTION, "in", Subscription("in", string, None, Span(0, 0)))
    files, told = edit(sides(HIDDEN)[0], change)
    assert files is not None, told
    text = files.main
    # A method that `&Teleop::Impl::` names is one of `Impl`.
    for name in (b"heard_2", b"heard2"):
        assert b"&Teleop::Impl::" + name not in text


PARTS = """
 #include <rclcpp/rclcpp.hpp>
 #include <std_msgs/msg/string.hpp>

 class Images
 {
 public:
   explicit Images(rclcpp::Node * node) : node_(node)
   {
     pub_ = node_->create_publisher<std_msgs::msg::String>("image", 10);
   }

 private:
   rclcpp::Node * node_;
   rclcpp::Publisher<std_msgs::msg::String>::SharedPtr pub_;
 };

 class Scans
 {
 public:
   explicit Scans(rclcpp::Node * node) : node_(node)
   {
     pub_ = node_->create_publisher<std_msgs::msg::String>("scan", 10);
   }

 private:
   rclcpp::Node * node_;
   rclcpp::Publisher<std_msgs::msg::String>::SharedPtr pub_;
 };
"""


@pytest.mark.parametrize(("topic", "own"), [("image", b"Images"), ("scan", b"Scans")])
def test_what_a_class_holds_is_sent_by_that_class(topic: str, own: bytes) -> None:
    files, told = edit(sides(PARTS)[0], publish(topic, rate=2.0, data="hi"))
    assert files is not None, told
    classes = files.main.split(b"\nclass ")
    found = [each.partition(b"\n")[0] for each in classes if b"pub_->publish(" in each]
    assert found == [own]
