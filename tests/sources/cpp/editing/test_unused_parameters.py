"""Parameters that nothing uses any more lose their names, and get them again."""

from __future__ import annotations

import pytest
from additions import publish
from patches import check, edit, sides

from plastron_tui.model.source import EndpointKind, Remove
from plastron_tui.model.values import Computed, OfReceived
from plastron_tui.ros.interfaces import FieldType

K = EndpointKind

ROS1 = """
 #include <ros/ros.h>
 #include <std_msgs/String.h>

-ros::Publisher pub;
 int heard = 0;
{}
 int main(int c, char ** v) {{
   ros::init(c, v, "n");
   ros::NodeHandle nh;
-  pub = nh.advertise<std_msgs::String>("out", 1);
   ros::Subscriber sub = nh.subscribe("in", 1, on_in);
   ros::spin();
 }}
"""
CASES = {
    "a reference": """
-void on_in(const std_msgs::String & msg) {
+void on_in(const std_msgs::String & /*msg*/) {
   heard++;
-  pub.publish(msg);
 }
""",
    "a pointer, as a comment with blanks as the file has them": """
 void other(int /* unused */) {}
-void on_in(const std_msgs::String::ConstPtr& message) {
+void on_in(const std_msgs::String::ConstPtr& /* message */) {
   heard++;
-  pub.publish(*message);
 }
""",
    "without a name, as another one": """
 void other(int) {}
-void on_in(const std_msgs::String::ConstPtr& msg) {
+void on_in(const std_msgs::String::ConstPtr&) {
   heard++;
-  pub.publish(msg);
 }
""",
    "what sets a message": """
-void on_in(const std_msgs::String::ConstPtr& msg) {
+void on_in(const std_msgs::String::ConstPtr& /*msg*/) {
   heard++;
-  std_msgs::String out;
-  out.data = msg->data;
-  pub.publish(out);
 }
""",
    "one that is still used": """
 void on_in(const std_msgs::String::ConstPtr& msg) {
   heard += msg->data.size();
-  pub.publish(msg);
 }
""",
    "one that never was used": """
 void on_in(const std_msgs::String::ConstPtr& msg) {
   heard++;
-  pub.publish(std_msgs::String());
 }
""",
    "one that a macro uses": """
 #define TELL() ROS_INFO("%s", msg->data.c_str())
 void on_in(const std_msgs::String::ConstPtr& msg) {
   TELL();
-  pub.publish(msg);
 }
""",
}


@pytest.mark.parametrize("code", CASES.values(), ids=CASES)
def test_parameters_that_only_the_endpoint_used(code: str) -> None:
    check(ROS1.format(code.strip("\n")), Remove(K.PUBLISHER, "out"))


def test_the_parameter_of_a_lambda() -> None:
    text = """
 #include <rclcpp/rclcpp.hpp>
 #include <std_msgs/msg/string.hpp>
 class A : public rclcpp::Node {
  public:
   A() : Node("a") {
-    pub_ = create_publisher<std_msgs::msg::String>("out", 1);
     sub_ = create_subscription<std_msgs::msg::String>(
-      "in", 1, [this](const std_msgs::msg::String & msg) {
+      "in", 1, [this](const std_msgs::msg::String & /*msg*/) {
         heard_++;
-        pub_->publish(msg);
       });
   }
   int heard_ = 0;
-  rclcpp::Publisher<std_msgs::msg::String>::SharedPtr pub_;
   rclcpp::Subscription<std_msgs::msg::String>::SharedPtr sub_;
 };
"""
    check(text, Remove(K.PUBLISHER, "out"))


NAMES = {
    "const std_msgs::String& /*heard*/": "const std_msgs::String& heard",
    "const std_msgs::String &": "const std_msgs::String & msg",
    "const std_msgs::String::ConstPtr & /* it */": "const std_msgs::String::ConstPtr & it",
}


@pytest.mark.parametrize(("before", "after"), NAMES.items())
@pytest.mark.parametrize("is_read", [True, False])
def test_a_reaction_names_what_it_reads(before: str, after: str, is_read: bool) -> None:
    code = f" void on_in({before}) {{\n   heard++;\n }}"
    text = "\n".join(x for x in ROS1.format(code).split("\n") if not x.startswith("-"))
    start, _ = sides(text)
    value = Computed(OfReceived(("data",)), (), FieldType("string")) if is_read else "x"
    changed, told = edit(start, publish("out", heard="in", data=value))
    assert changed is not None, told
    assert f"void on_in({after if is_read else before}) {{".encode() in changed.main
    back, _ = edit(changed, Remove(K.PUBLISHER, "out"))
    assert back is not None
    assert b"out" not in back.main
