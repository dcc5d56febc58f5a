"""Which fields of messages nodes in C++ use, what they give them, and what they publish."""

from __future__ import annotations

from pathlib import Path

import pytest

from plastron_tui.model.code_facts import CodeFacts, Part
from plastron_tui.model.source import FileSet
from plastron_tui.sources.cpp.facts import code_facts
from plastron_tui.sources.cpp.reader import read_cpp

ROS2 = """\
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_action/rclcpp_action.hpp"
#include "geometry_msgs/msg/pose_array.hpp"
#include "geometry_msgs/msg/twist.hpp"
#include "std_srvs/srv/set_bool.hpp"
#include "example_interfaces/action/fibonacci.hpp"
using Twist = geometry_msgs::msg::Twist;
using Fibonacci = example_interfaces::action::Fibonacci;
class N : public rclcpp::Node {
public:
  N() : Node("n") {
    create_subscription<Twist>("a", 1, [](const auto & given) { (void)given->inner; });
  }
  void f(const Twist::SharedPtr heard, const geometry_msgs::msg::PoseArray & listed) {
    BODY
  }
  void serve(const std::shared_ptr<std_srvs::srv::SetBool::Request> request,
             std_srvs::srv::SetBool::Response::SharedPtr response) { SERVED }
  Twist kept_;
  rclcpp::Publisher<Twist>::SharedPtr pub_;
};
"""
ROS1 = """\
#include <ros/ros.h>
#include <geometry_msgs/PoseArray.h>
#include <std_srvs/SetBool.h>
#include <move_base_msgs/MoveBaseAction.h>
void f(const geometry_msgs::PoseArray::ConstPtr& heard, std_srvs::SetBool::Request &req,
       std_srvs::SetBoolResponse &res) {
  BODY
}
"""


def facts(text: str) -> CodeFacts:
    source = read_cpp(Path("/ws/src/n.cpp"), FileSet.single(".cpp", text.encode())).source
    assert source is not None
    return code_facts(source)


def used(text: str) -> list[str]:
    """Return the fields that a text uses, but for the one of the lambda."""
    found = [f"{each.type.name.name} {'.'.join(each.path)}" for each in facts(text).fields]
    return [each for each in found if not each.endswith("inner")]


@pytest.mark.parametrize(
    ("body", "fields"),
    [
        ("heard->linear.x = 1.0;", ["Twist linear.x"]),
        ("double v = (*heard).linear.w;", ["Twist linear.w"]),
        ("Twist msg; msg.linear.w = 1;", ["Twist linear.w"]),
        ("auto msg = Twist(); msg.angular.q++;", ["Twist angular.q"]),
        ("auto msg = std::make_unique<Twist>(); msg->foo = 1;", ["Twist foo"]),
        ("geometry_msgs::msg::Twist msg{}; msg.foo = 1;", ["Twist foo"]),
        ("auto & v = heard->linear; v.w = 1;", ["Twist linear", "Twist linear.w"]),
        ("kept_.a = 1; this->kept_.b = 2;", ["Twist a", "Twist b"]),
        ("listed.poses[0].position.x;", ["PoseArray poses.position.x"]),
        (
            "for (const auto & p : listed.poses) { p.position.q; }",
            ["PoseArray poses", "PoseArray poses.position.q"],
        ),
        ("listed.poses.front().foo;", ["PoseArray poses.foo"]),
        ("listed.poses.size();", ["PoseArray poses"]),
        ("std::vector<Twist> all; all[0].foo; all.at(1).bar;", ["Twist foo", "Twist bar"]),
        ("auto run = [msg = Twist()]() { }; other.foo = 1;", []),
        ("Own own; own.foo = 1; auto x = make(); x.foo = 2;", []),
        (
            "std::shared_ptr<rclcpp_action::ServerGoalHandle<Fibonacci>> h; h->get_goal()->foo;",
            ["Fibonacci foo"],
        ),
        ("auto r = std::make_shared<Fibonacci::Result>(); r->foo = 1;", ["Fibonacci foo"]),
        ("#ifdef OLD\n heard->foo = 1;\n#endif\n", []),
        # What a block declares ends with it.
        (
            "{ geometry_msgs::msg::PoseArray heard; heard.poses; } heard->linear;",
            ["PoseArray poses", "Twist linear"],
        ),
        (
            "for (auto & kept_ : listed.poses) kept_.position; kept_.linear;",
            ["PoseArray poses", "PoseArray poses.position", "Twist linear"],
        ),
        ("if (geometry_msgs::msg::PoseArray kept_; true) { kept_.a; }", ["PoseArray a"]),
        (
            "geometry_msgs::msg::PoseArray kept_; { kept_.a; } kept_.b;",
            ["PoseArray a", "PoseArray b"],
        ),
        ("int a = Twist::STOPPED;", ["Twist STOPPED"]),
        ("if (a == geometry_msgs::msg::Twist::STOPPED_1) {}", ["Twist STOPPED_1"]),
        ("switch (a) { case Twist::STOPPED: break; }", ["Twist STOPPED"]),
        ("auto a = std_srvs::srv::SetBool::Request::ON;", ["SetBool ON"]),
        # Types, functions and what is of no message.
        ("Twist::SharedPtr a; Twist::MAKE(); Other::STOPPED; rclcpp::Time::MAX;", []),
        ("#ifdef OLD\n int a = Twist::STOPPED;\n#endif\n", []),
    ],
)
def test_fields_of_messages_of_ros2(body: str, fields: list[str]) -> None:
    assert used(ROS2.replace("BODY", body).replace("SERVED", "")) == fields


def test_parameter_of_a_lambda_has_the_type_of_its_endpoint() -> None:
    found = facts(ROS2.replace("BODY", "").replace("SERVED", "")).fields
    assert [(str(each.type.name), each.path) for each in found] == [
        ("geometry_msgs/Twist", ("inner",))
    ]


def test_requests_and_responses_are_told_apart() -> None:
    text = ROS2.replace("BODY", "").replace("SERVED", "response->success = request->data;")
    found = [each for each in facts(text).fields if each.path != ("inner",)]
    assert [(each.type.part, each.path) for each in found] == [
        (Part.RESPONSE, ("success",)),
        (Part.REQUEST, ("data",)),
    ]


@pytest.mark.parametrize(
    ("body", "fields"),
    [
        ("heard->poses[0].foo;", ["PoseArray poses.foo"]),
        ("res.done = req.daten;", ["SetBool done", "SetBool daten"]),
        ("std_srvs::SetBool srv; srv.request.x = srv.response.y;", ["SetBool x", "SetBool y"]),
        ("move_base_msgs::MoveBaseGoal goal; goal.foo = 1;", ["MoveBase foo"]),
        ("pcl::PointCloud<pcl::PointXYZ> cloud; cloud.points.size();", []),
    ],
)
def test_fields_of_messages_of_ros1(body: str, fields: list[str]) -> None:
    assert used(ROS1.replace("BODY", body)) == fields


def test_place_of_a_field_is_that_of_its_name() -> None:
    text = ROS2.replace("BODY", "heard->linear.w = 1.0;").replace("SERVED", "")
    (found,) = [each for each in facts(text).fields if each.path != ("inner",)]
    assert [text[span.start : span.end] for span in found.spans] == ["linear", "w"]


@pytest.mark.parametrize(
    ("body", "values"),
    [
        ('heard->linear.x = "fast";', ["linear.x str"]),
        ("heard->linear.x = 1;", ["linear.x int"]),
        ("heard->linear.x = -1.5f;", ["linear.x float"]),
        ("heard->linear.x = nullptr;", ["linear.x None"]),
        ("heard->linear.x = true;", ["linear.x bool"]),
        ("heard->linear.x = std::to_string(5);", ["linear.x str"]),
        ("std::string s; heard->linear.x = s;", ["linear.x str"]),
        ("heard->linear = listed.poses[0].position;", ["linear message"]),
        ("heard->linear.x += 1; heard->linear.x = speed();", []),
    ],
)
def test_values_of_fields(body: str, values: list[str]) -> None:
    found = facts(ROS2.replace("BODY", body).replace("SERVED", "")).values
    assert [f"{'.'.join(each.path)} {each.kind.value}" for each in found] == values


@pytest.mark.parametrize(
    ("body", "paths"),
    [
        ("Twist m; m.linear.x = 1; pub_->publish(m);", {("linear", "x")}),
        ("auto m = std::make_unique<Twist>(); pub_->publish(std::move(m));", set()),
        ("auto m = Twist(); auto & l = m.linear; pub_->publish(m);", {("linear",)}),
        ("kept_.linear.x = 1; pub_->publish(kept_);", {("linear", "x")}),
        ("pub_->publish(Twist());", set()),
        ("Twist m; kept_ = m; v = m.linear; if (m.angular.x > 1) pub_->publish(m);", set()),
        ("auto m = std::make_shared<Twist>(); other = m; pub_->publish(*m);", None),
        # What comes behind is too late, unless it is for the next time.
        ("Twist m; pub_->publish(m); m.linear.x = 1; fill(m);", set()),
        ("Twist m; if (a) { pub_->publish(m); return; } m.linear.x = 1;", set()),
        ("while (a) { Twist m; pub_->publish(m); m.linear.x = 1; }", set()),
        ("Twist m; while (a) { pub_->publish(m); m.linear.x = 1; }", {("linear", "x")}),
        ("static Twist m; pub_->publish(m); m.linear.x = 1;", {("linear", "x")}),
        ("pub_->publish(kept_); kept_.linear.x = 1;", {("linear", "x")}),
        ("Twist m; auto run = [&]() { pub_->publish(m); }; m.linear.x = 1; run();",
         {("linear", "x")}),
        ("Twist m; fill(m); pub_->publish(m);", None),
        ("Twist m; m = *heard; pub_->publish(m);", None),
        ("Twist m(*heard); pub_->publish(m);", None),
        ("pub_->publish(*heard);", None),
    ],
)  # fmt: skip
def test_messages_whose_making_is_known(body: str, paths: set[tuple[str, ...]] | None) -> None:
    found = facts(ROS2.replace("BODY", body).replace("SERVED", "")).sent
    assert [set(each.paths) for each in found] == ([] if paths is None else [paths])


@pytest.mark.parametrize(
    ("body", "is_closed"),
    [
        ("heard->linear.x = 1;", True),
        ("rclcpp::spin_some(shared_from_this());", True),
        ("add_more(shared_from_this());", False),
        ("Helper helper(this);", False),
    ],
)
def test_node_that_is_handed_out_is_not_closed(body: str, is_closed: bool) -> None:
    assert facts(ROS2.replace("BODY", body).replace("SERVED", "")).is_closed is is_closed
