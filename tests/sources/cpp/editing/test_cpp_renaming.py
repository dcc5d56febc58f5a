"""What decides the name of an endpoint, and says another one."""

from __future__ import annotations

import pytest
from patches import check, refusal

from plastron_tui.model.source import EndpointKind, Rename

K = EndpointKind

# What stands before the node's class, in it, what makes the publisher, and what changes.
IN_NODE = [
    ("", "", '"a"', [('"a"', '"b"')]),
    ("", "", 'std::string("a")', [('"a"', '"b"')]),
    ('const char * kTopic = "a";', "", "kTopic", [('"a"', '"b"')]),
    ('#define TOPIC "a"', "", "TOPIC", [('"a"', '"b"')]),
    ('constexpr auto kTopic{"a"};', "", "kTopic", [('"a"', '"b"')]),
    ('namespace names { const std::string B("a"); }', "", "names::B", [('"a"', '"b"')]),
    ("", 'std::string topic_ = "a";', "topic_", [('"a"', '"b"')]),
    ("", 'std::string topic_{"a"};', "this->topic_", [('"a"', '"b"')]),
    ("", 'static constexpr const char * TOPIC = "a";', "A::TOPIC", [('"a"', '"b"')]),
    ("", "", 'declare_parameter<std::string>("topic", "a")', [('"a"', '"b"')]),
    ("", "", 'R"(a)"', [('R"(a)"', '"b"')]),
    ("", "", '"a"  /* where */', [('"a"', '"b"')]),
]


def _node(head: str, members: str, name: str) -> str:
    return f"""
 #include <rclcpp/rclcpp.hpp>
 #include <std_msgs/msg/string.hpp>
 {head}
 class A : public rclcpp::Node {{
  public:
   A() : Node("node") {{
     pub_ = create_publisher<std_msgs::msg::String>({name}, 1);
     RCLCPP_INFO(get_logger(), "a");
   }}
   rclcpp::Publisher<std_msgs::msg::String>::SharedPtr pub_;
   {members}
 }};
"""


def _patch(text: str, old: str, new: str) -> str:
    """Return a patch that writes something else in the one line that has a text."""
    lines = text.split("\n")
    at = [n for n, line in enumerate(lines) if old in line and "RCLCPP_INFO" not in line]
    assert len(at) == 1, at
    line = lines[at[0]]
    lines[at[0] : at[0] + 1] = [f"-{line[1:]}", f"+{line[1:].replace(old, new)}"]
    return "\n".join(lines)


@pytest.mark.parametrize(("head", "members", "name", "edits"), IN_NODE)
def test_what_decides_a_name_says_the_new_one(
    head: str, members: str, name: str, edits: list[tuple[str, str]]
) -> None:
    check(_patch(_node(head, members, name), *edits[0]), Rename(K.PUBLISHER, "a", "b"))


def test_a_constant_that_serves_more_stays() -> None:
    text = """
 #include <rclcpp/rclcpp.hpp>
 #include <std_msgs/msg/string.hpp>
 const char * kName = "a";
 int main(int c, char ** v)
 {
   rclcpp::init(c, v);
   auto node = std::make_shared<rclcpp::Node>(kName);
-  auto pub = node->create_publisher<std_msgs::msg::String>(kName, 1);
+  auto pub = node->create_publisher<std_msgs::msg::String>("b", 1);
 }
"""
    check(text, Rename(K.PUBLISHER, "a", "b"))


def test_two_change_places() -> None:
    text = """
 #include <ros/ros.h>
 #include <std_msgs/String.h>
-#define FIRST "a"
+#define FIRST "b"
 int main(int c, char ** v)
 {
   ros::init(c, v, "n");
   ros::NodeHandle nh;
   auto one = nh.advertise<std_msgs::String>(FIRST, 1);
-  auto two = nh.advertise<std_msgs::String>("b", 1);
+  auto two = nh.advertise<std_msgs::String>("a", 1);
 }
"""
    check(text, Rename(K.PUBLISHER, "a", "b"), Rename(K.PUBLISHER, "b", "a"))


def test_a_macro_that_says_something_else_as_well_stays() -> None:
    text = """
 #include <ros/ros.h>
 #include <std_msgs/String.h>
 #define NAME "a"
 int main(int c, char ** v)
 {
   ros::init(c, v, "n");
   ros::NodeHandle nh;
-  auto one = nh.advertise<std_msgs::String>(NAME, 1);
+  auto one = nh.advertise<std_msgs::String>("b", 1);
   std_msgs::String said;
   said.data = NAME;
   one.publish(said);
 }
"""
    check(text, Rename(K.PUBLISHER, "a", "b"))


def test_a_name_comes_from_who_makes_the_node() -> None:
    text = """
 #include "x.hpp"
 Talker::Talker(const std::string & topic)
 : Node("talker")
 {
   pub_ = create_publisher<std_msgs::msg::String>(topic, 1);
 }
 int main(int c, char ** v)
 {
   rclcpp::init(c, v);
-  rclcpp::spin(std::make_shared<Talker>("a"));
+  rclcpp::spin(std::make_shared<Talker>("b"));
 }
=== x.hpp
 #include <rclcpp/rclcpp.hpp>
 #include <std_msgs/msg/string.hpp>
 class Talker : public rclcpp::Node
 {
 public:
   explicit Talker(const std::string & topic = "other");
   rclcpp::Publisher<std_msgs::msg::String>::SharedPtr pub_;
 };
"""
    check(text, Rename(K.PUBLISHER, "a", "b"))


def test_the_name_stays_in_the_namespace_of_its_handle() -> None:
    text = """
 #include <ros/ros.h>
 #include <std_msgs/String.h>
 int main(int c, char ** v)
 {
   ros::init(c, v, "n");
   ros::NodeHandle nh("arm"), pnh("~");
-  auto one = nh.advertise<std_msgs::String>("a", 1);
+  auto one = nh.advertise<std_msgs::String>("b", 1);
   auto two = pnh.advertise<std_msgs::String>("a", 1);
 }
"""
    check(text, Rename(K.PUBLISHER, "arm/a", "arm/b"))
    assert refusal(text, Rename(K.PUBLISHER, "arm/b", "b"))


def test_a_constant_of_a_header_that_others_include_stays() -> None:
    text = """
 #include <names.hpp>
 #include "x.hpp"
 Talker::Talker() : Node("talker") {
-  a_ = create_publisher<std_msgs::msg::String>(kTopic, 1);
+  a_ = create_publisher<std_msgs::msg::String>("b", 1);
   c_ = create_publisher<std_msgs::msg::String>(TOPIC, 1);
 }
=== {}.hpp
 #include <rclcpp/rclcpp.hpp>
 #include <std_msgs/msg/string.hpp>
-#define TOPIC "c"
+#define TOPIC "d"
 class Talker : public rclcpp::Node {
   Talker();
   rclcpp::Publisher<std_msgs::msg::String>::SharedPtr a_, c_;
 };
=== names.hpp
 const char * const kTopic = "a";
"""
    check(text, Rename(K.PUBLISHER, "a", "b"), Rename(K.PUBLISHER, "c", "d"))


KINDS = [
    (K.SUBSCRIPTION, 'create_subscription<std_msgs::msg::String>("a", 1, std::bind(f));'),
    (K.SERVICE, 'create_service<std_srvs::srv::Empty>("a", f);'),
    (K.CLIENT, 'create_client<std_srvs::srv::Empty>("a");'),
    (K.ACTION_CLIENT, 'rclcpp_action::create_client<a_msgs::action::Foo>(this, "a");'),
    (K.ACTION_SERVER, 'rclcpp_action::create_server<a_msgs::action::Foo>(this, "a", g, h, i);'),
    (K.PARAMETER, 'declare_parameter("a", 1);'),
]


@pytest.mark.parametrize(("kind", "call"), KINDS)
def test_each_kind_is_renamed(kind: EndpointKind, call: str) -> None:
    text = f"""
 #include <rclcpp/rclcpp.hpp>
 class A : public rclcpp::Node {{
  public:
   A() : Node("node") {{
     {call}
   }}
 }};
"""
    check(_patch(text, '"a"', '"b"'), Rename(kind, "a", "b"))


def test_a_parameter_is_renamed_wherever_it_is_read() -> None:
    text = """
 #include <rclcpp/rclcpp.hpp>
 class A : public rclcpp::Node {
  public:
   A() : Node("node") {
-    declare_parameter("a", 1.0);
-    rate_ = get_parameter("a").as_double();
+    declare_parameter("b", 1.0);
+    rate_ = get_parameter("b").as_double();
   }
   double rate_;
 };
"""
    check(text, Rename(K.PARAMETER, "a", "b"))


def test_each_call_of_a_function_gives_its_own_name() -> None:
    text = """
 #include <ros/ros.h>
 #include <std_msgs/String.h>
 void make(ros::NodeHandle & nh, const std::string & name)
 {
   nh.advertise<std_msgs::String>(name, 1);
 }
 int main(int c, char ** v)
 {
   ros::init(c, v, "n");
   ros::NodeHandle nh;
-  make(nh, "a");
+  make(nh, "b");
   make(nh, "c");
 }
"""
    check(text, Rename(K.PUBLISHER, "a", "b"))


def test_what_callers_elsewhere_decide_stays() -> None:
    text = """
 #include <ros/ros.h>
 #include <std_msgs/String.h>
 void make(ros::NodeHandle & nh, const std::string & name)
 {
   nh.advertise<std_msgs::String>(name + "/a", 1);
 }
 int main(int c, char ** v)
 {
   ros::init(c, v, "n");
   ros::NodeHandle nh;
   make(nh, "arm");
 }
"""
    assert "does not say the name" in refusal(text, Rename(K.PUBLISHER, "arm/a", "b"))


@pytest.mark.parametrize("newline", ["\n", "\r\n"])
def test_bytes_around_a_name_stay(newline: str) -> None:
    text = _patch(_node("// \xfc\xf1", "\tint x;", '"a"'), '"a"', '"b"')
    check(text.replace("\n", newline).removeprefix("\r"), Rename(K.PUBLISHER, "a", "b"))
