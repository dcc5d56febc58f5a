"""What is added beside what a conditional of the preprocessor may switch off."""

from __future__ import annotations

import pytest
from patches import check

from plastron_tui.diagnostics import Span
from plastron_tui.model.kinds import Subscription
from plastron_tui.model.source import Add
from plastron_tui.ros.interfaces import InterfaceName

ADD = Add(Subscription("b", InterfaceName("std_msgs", "String"), span=Span(0, 0)))
HEAD = """
 #include <ros/ros.h>
 #include <std_msgs/String.h>
"""
NODE = """
 class A {
  public:
   A() {
 #ifdef FAST
     sub_ = nh_.subscribe("a", 1, &A::onA, this);
 #else
     sub_ = nh_.subscribe("a", 10, &A::onA, this);
 #endif  // FAST
+    b_sub_ = nh_.subscribe("b", 10, &A::onB, this);
   }

  private:
   ros::NodeHandle nh_;
 #ifdef FAST
   ros::Subscriber sub_;
 #endif
+  ros::Subscriber b_sub_;
 #if 1
   void onA(const std_msgs::String& msg) {}
 #endif
+
+  void onB(const std_msgs::String& msg) {
+    ROS_INFO_STREAM("b: " << msg);
+  }
 };
"""
LOCAL = """
 void onA(const std_msgs::String& msg) {}
+void onB(const std_msgs::String& msg) {
+  ROS_INFO_STREAM("b: " << msg);
+}
 int main(int c, char** v) {
   ros::init(c, v, "n");
 #ifdef FAST
   ros::NodeHandle nh;
   auto a = nh.subscribe("a", 1, onA);
+  auto b = nh.subscribe("b", 1, onB);
 #endif
   ros::spin();
 }
"""


@pytest.mark.parametrize("node", [NODE, LOCAL], ids=["class", "what it declares"])
def test_conditionals_do_not_switch_off_what_is_added(node: str) -> None:
    check(HEAD + node[1:], ADD)


def test_conditionals_around_the_whole_switch_it_off_as_before() -> None:
    check(f"{HEAD} #ifndef B\n{NODE[1:]} #endif\n", ADD)
