"""What becomes of the code that serves an endpoint when its type or its rate changes."""

from __future__ import annotations

import pytest
from patches import check, edit
from updated_nodes import ROS1, patched

from plastron_tui.diagnostics import Span
from plastron_tui.model.kinds import (
    Client,
    Rate,
    Subscription,
    Timer,
    kind_of,
)
from plastron_tui.model.source import EndpointKind, FileSet, Update
from plastron_tui.ros.interfaces import InterfaceName

K = EndpointKind
AT = Span(0, 0)
INT = InterfaceName("std_msgs", "Int32")
SET_BOOL = InterfaceName("std_srvs", "SetBool")


PERIODS = [
    ("500ms", 10.0, "100ms"),
    ("1s", 1000.0, "1ms"),
    ("100ms", 1.0, "1s"),
    ("std::chrono::milliseconds(500)", 4.0, "std::chrono::milliseconds(250)"),
    ("std::chrono::seconds{2}", 0.25, "std::chrono::seconds{4}"),
    (
        "std::chrono::duration<double>(0.5)",
        3.0,
        "std::chrono::duration<double>(1.0 / 3.0)",
    ),
    ("rclcpp::Duration::from_seconds(0.5)", 4.0, "rclcpp::Duration::from_seconds(0.25)"),
]


@pytest.mark.parametrize(("written", "hertz", "expected"), PERIODS)
def test_a_period_is_written_as_the_file_writes_it(
    written: str, hertz: float, expected: str
) -> None:
    before = f"    timer_ = create_timer({written}, [this]() {{ tick(); }});"
    text = f"""
 #include <rclcpp/rclcpp.hpp>
 using namespace std::chrono_literals;
 class A : public rclcpp::Node {{
  public:
   A() : Node("a") {{
 {before.replace("[this]() { tick(); }", "std::bind(&A::tick, this)")}
   }}
   void tick() {{ count_++; }}
   rclcpp::TimerBase::SharedPtr timer_;
   int count_;
 }};
"""
    old = before.replace("[this]() { tick(); }", "std::bind(&A::tick, this)")
    patch = patched(text, (old, old.replace(written, expected)))
    check(patch, Update(kind_of(Timer), "tick", Timer("tick", None, Rate(hertz), AT), AT))


def test_code_that_cannot_do_with_a_type_is_called_no_longer() -> None:
    text = patched(
        ROS1,
        (
            '    goal_ = nh_.subscribe("goal", 3, &Robot::onGoal, this);',
            '    goal_ = nh_.subscribe("goal", 3, &Robot::onGoal_2, this);',
        ),
        (
            "#include <std_msgs/String.h>",
            "#include <std_msgs/String.h>\n#include <std_msgs/Int32.h>",
        ),
        (
            "  void onGoal(const std_msgs::StringConstPtr& msg) { goal_text_ = msg->data; }",
            "  void onGoal(const std_msgs::StringConstPtr& msg) { goal_text_ = msg->data; }\n"
            "\n"
            "  void onGoal_2(const std_msgs::Int32ConstPtr& msg) {\n"
            '    ROS_INFO_STREAM("goal: " << *msg);\n'
            "  }",
        ),
    )
    told = check(text, Update(K.SUBSCRIPTION, "goal", Subscription("goal", INT, None, AT), AT))
    message = "nothing in the file calls `onGoal` (line 17) any more"
    assert message in [each.message for each in told]


def test_a_number_stays_a_number() -> None:
    text = """
 #include <ros/ros.h>
-#include <std_msgs/Int32.h>
+#include <std_msgs/Float64.h>
-void heard(const std_msgs::Int32& msg) { ROS_INFO("%d", int(msg.data)); }
+void heard(const std_msgs::Float64& msg) { ROS_INFO("%d", int(msg.data)); }
 double last;
-void kept(const std_msgs::Int32::ConstPtr& msg) { last = msg->data; }
+void kept(const std_msgs::Float64::ConstPtr& msg) { last = msg->data; }
 int main(int c, char** v) {
   ros::init(c, v, "n");
   ros::NodeHandle nh;
   auto a = nh.subscribe("a", 1, heard);
   auto b = nh.subscribe("b", 1, kept);
 }
"""
    real = InterfaceName("std_msgs", "Float64")
    check(
        text,
        Update(kind_of(Subscription), "a", Subscription("a", real, None, AT), AT),
        Update(kind_of(Subscription), "b", Subscription("b", real, None, AT), AT),
    )


def test_a_client_that_nothing_calls_gets_another_type() -> None:
    patch = """
 #include <rclcpp/rclcpp.hpp>
-#include "std_srvs/srv/trigger.hpp"
+#include "std_srvs/srv/set_bool.hpp"
 int main(int c, char** v) {
   rclcpp::init(c, v);
   auto node = std::make_shared<rclcpp::Node>("n");
-  auto client = node->create_client<std_srvs::srv::Trigger>("go");
+  auto client = node->create_client<std_srvs::srv::SetBool>("go");
   rclcpp::spin(node);
 }
"""
    check(patch, Update(kind_of(Client), "go", Client("go", SET_BOOL, (), AT), AT))


FUNCTOR = """
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/string.hpp>
struct Ear : rclcpp::Node {
  struct Handler {
    Ear * owner;
    void operator()(const std_msgs::msg::String &) const {}
  };
  Ear() : Node("ear") {
    in_ = create_subscription<std_msgs::msg::String>("in", 1, Handler{this});
  }
  rclcpp::Subscription<std_msgs::msg::String>::SharedPtr in_;
};
"""


def other_type(text: str) -> bytes:
    new = Subscription("in", INT, None, AT)
    files, told = edit(FileSet.single(".cpp", text.encode()), Update(K.SUBSCRIPTION, "in", new, AT))
    assert files is not None, told
    return files.main


def test_an_object_that_is_called_gets_no_other_type() -> None:
    changed = other_type(FUNCTOR)
    assert b"std::bind(&Ear::on_in, this" in changed
    assert b"Handler{this}" not in changed


def test_what_a_name_of_the_file_says_holds_no_other_type() -> None:
    text = FUNCTOR.replace("  rclcpp::Subscription<std", "  using In = rclcpp::Subscription<std")
    text = text.replace("::SharedPtr in_;", ";\n  In::SharedPtr in_;")
    text = text.replace("Handler{this}", "[this](std_msgs::msg::String::SharedPtr) {}")
    assert "  using In = rclcpp::Subscription<std_msgs::msg::String>;\n  In::SharedPtr in_;" in text
    changed = other_type(text)
    assert b"In::SharedPtr" not in changed
    assert b"rclcpp::Subscription<std_msgs::msg::Int32>::SharedPtr" in changed
