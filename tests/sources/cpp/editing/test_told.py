"""What is told of lines that a change leaves behind."""

from __future__ import annotations

import pytest
from additions import publish
from patches import edit, sides

from plastron_tui.diagnostics import Span
from plastron_tui.model.kinds import Message, Publication, Publisher, Subscription
from plastron_tui.model.source import Add, EndpointKind, FileSet, Remove, Rename, Update
from plastron_tui.model.values import MessageValue
from plastron_tui.ros.interfaces import InterfaceName

K = EndpointKind
AT = Span(0, 0)

SAID = [
    ("// publishes on the topic speed", ["line 10 still says `speed`"]),
    ("// the speed is high", []),
    ("// publishes /speed", ["line 10 still says `speed`"]),
    ('// pub_ = f("/speed");', []),
    ('RCLCPP_INFO(get_logger(), "sent to /speed");', ["line 10 still says `speed`"]),
    ('RCLCPP_INFO(get_logger(), "speed is %f", 1.0);', []),
    ('f("speed");', ["line 10 still says `speed`"]),
    ('frame_id = "speed";', []),
    ('f("speed_limit");', []),
]


@pytest.mark.parametrize(("line", "expected"), SAID)
def test_lines_that_still_say_a_name_are_told(line: str, expected: list[str]) -> None:
    text = f"""
 #include <rclcpp/rclcpp.hpp>
 #include <std_msgs/msg/string.hpp>
 class A : public rclcpp::Node {{
  public:
   A() : Node("a") {{
     pub_ = create_publisher<std_msgs::msg::String>("speed", 1);
   }}

   void f() {{
     {line}
   }}
   rclcpp::Publisher<std_msgs::msg::String>::SharedPtr pub_;
 }};
"""
    before, _ = sides(text)
    files, told = edit(before, Rename(K.PUBLISHER, "speed", "pace"))
    assert files is not None
    assert [each.message for each in told] == expected


def test_functions_that_nothing_calls_any_more_are_told() -> None:
    text = """
 #include <ros/ros.h>
 #include <std_msgs/String.h>
 int count = 0;
 void add() { count++; }
 void heard(const std_msgs::String& msg) { add(); }
 void unused() { count = 0; }
 int main(int c, char** v) {
   ros::init(c, v, "n");
   ros::NodeHandle nh;
   auto sub = nh.subscribe("in", 1, heard);
 }
"""
    before, _ = sides(text)
    files, told = edit(before, Remove(K.SUBSCRIPTION, "in"))
    assert files is not None
    assert [each.message for each in told] == [
        "nothing in the file calls `heard` (line 5) any more"
    ]


@pytest.mark.parametrize(
    "change", [Remove(K.PUBLISHER, "speed"), Rename(K.PUBLISHER, "speed", "b")]
)
def test_a_name_that_others_may_give_otherwise_is_told(change: Remove | Rename) -> None:
    text = """
 #include <rclcpp/rclcpp.hpp>
 #include <std_msgs/msg/string.hpp>
 class A : public rclcpp::Node {
  public:
   A() : Node("a") {
     auto topic = declare_parameter<std::string>("topic", "speed");
     pub_ = create_publisher<std_msgs::msg::String>(topic, 1);
   }
   rclcpp::Publisher<std_msgs::msg::String>::SharedPtr pub_;
 };
"""
    before, _ = sides(text)
    files, told = edit(before, change)
    assert files is not None
    assert "the name `speed` in line 7 is a default, for which others may give another name" in [
        each.message for each in told
    ]


LISTENER = "auto listener = std::make_shared<tf2_ros::TransformListener>(*buffer);"
SENDER = "tf2_ros::TransformBroadcaster sender(node);"
STRING = InterfaceName("std_msgs", "String")
REMAP = "remap it where the node is started: `starts … remapping '/tf' to '/tg'`"
BY_HAND = "change the line by hand"
PARTS: list[tuple[str, Remove | Rename | Update, str]] = [
    (LISTENER, Rename(K.SUBSCRIPTION, "/tf", "/tg"), REMAP),
    (LISTENER, Remove(K.SUBSCRIPTION, "/tf"), BY_HAND),
    (LISTENER, Update(K.SUBSCRIPTION, "/tf", Subscription("/tf", STRING, None, AT)), BY_HAND),
    (SENDER, Rename(K.PUBLISHER, "/tf", "/tg"), REMAP),
    (SENDER, Update(K.PUBLISHER, "/tf", Publisher("/tf", STRING, (), AT)), BY_HAND),
    (SENDER, Update(K.PUBLISHER, "/tf", Publisher("/tg", STRING, (), AT)), REMAP),
]


@pytest.mark.parametrize(("line", "change", "help_"), PARTS)
def test_what_an_object_of_a_library_names_is_not_changed(
    line: str, change: Remove | Rename | Update, help_: str
) -> None:
    text = f"""
 #include <rclcpp/rclcpp.hpp>
 #include <tf2_ros/transform_broadcaster.h>
 #include <tf2_ros/transform_listener.h>
 int main(int c, char** v) {{
   rclcpp::init(c, v);
   auto node = std::make_shared<rclcpp::Node>("n");
   {line}
   rclcpp::spin(node);
 }}
"""
    before, _ = sides(text)
    files, (found,) = edit(before, change)
    assert files is None
    what = "Listener" if line is LISTENER else "Broadcaster"
    word = change.kind.word
    assert found.message == f"the {word} `/tf` is a part of `tf2_ros::Transform{what}` in line 7"
    assert found.help == help_


def test_a_message_of_transforms_gets_a_publisher_of_its_own() -> None:
    text = """
 #include <rclcpp/rclcpp.hpp>
 #include <tf2_msgs/msg/tf_message.hpp>
 #include <tf2_ros/transform_broadcaster.h>
 class A : public rclcpp::Node {
  public:
   A() : Node("a") {
     sender_ = std::make_shared<tf2_ros::TransformBroadcaster>(this);
   }
   std::shared_ptr<tf2_ros::TransformBroadcaster> sender_;
 };
"""
    before, _ = sides(text)
    type_ = InterfaceName("tf2_msgs", "TFMessage")
    sent = Publication(Message("m", MessageValue(type_, {}), AT), 10.0, AT)
    files, _ = edit(before, Add(Publisher("/tf", type_, (sent,), AT)))
    assert files is not None
    assert b'create_publisher<tf2_msgs::msg::TFMessage>("/tf", 10)' in files.main
    assert b"sender_->publish" not in files.main


STATIC = """
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/string.hpp>
struct Ear : rclcpp::Node {
  Ear() : Node("ear") {
    in_ = create_subscription<std_msgs::msg::String>("in", 1, &Ear::heard);
  }
  STORAGE void heard(const std_msgs::msg::String &) {}
  rclcpp::Subscription<std_msgs::msg::String>::SharedPtr in_;
};
"""


@pytest.mark.parametrize("storage", ["static", "static inline", "inline static"])
def test_a_static_method_that_hears_sees_no_publisher(storage: str) -> None:
    text = STATIC.replace("STORAGE", storage).encode()
    files, told = edit(FileSet.single(".cpp", text), publish("out", heard="in", data="x"))
    assert files is None
    assert "`heard` does not see `out_pub_`" in told[0].message
