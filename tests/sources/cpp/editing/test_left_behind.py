"""What an edit leaves behind is told: what nothing sets, calls, reads, or gives anything to do."""

from __future__ import annotations

import pytest
from patches import edit, sides

from plastron_tui.diagnostics import Span
from plastron_tui.model.kinds import Subscription
from plastron_tui.model.source import Change, EndpointKind, FileSet, Remove, Update
from plastron_tui.ros.interfaces import InterfaceName

K, AT = EndpointKind, Span(0, 0)
STOP = Remove(K.SUBSCRIPTION, "in", AT)


def told(text: str, code: str, *changes: Change) -> list[str]:
    """Return what changes tell with a code."""
    files: FileSet = sides("\n".join(f" {line}" for line in text.split("\n")))[0]
    after, found = edit(files, *changes)
    assert after is not None, found
    assert all(each.span is not None for each in found if each.code == code)
    return [each.message for each in found if each.code == code]


CLASS = """#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/string.hpp>
class N : public rclcpp::Node {
 public:
  N() : Node("n") {
    {init}
    in_ = create_subscription<std_msgs::msg::String>("in", 1, std::bind(&N::hear, this, _1));
    more_ = create_subscription<std_msgs::msg::String>("more", 1, std::bind(&N::work, this, _1));
    timer_ = create_wall_timer(1s, std::bind(&N::tick, this));
  }
  void hear(const std_msgs::msg::String & msg) { {hear} }
  void tick() { {tick} }
  void work(const std_msgs::msg::String & msg) { {work} }
  void store(const std::string & text) { last_ = text; }
  void keep(std::string & text) { text = "x"; }
  rclcpp::Subscription<std_msgs::msg::String>::SharedPtr in_, more_;
  rclcpp::TimerBase::SharedPtr timer_;
  std::mutex mutex_;
  std::vector<std::string> list_;
  std::string last_ = "none";
  geometry_msgs::msg::Twist twist_;
  bool is_there_ = false;
  int count_;
};
"""
SET, READ = "last_ = msg.data;", 'RCLCPP_INFO(get_logger(), "%s", last_.c_str());'
LAST = "`last_` (read by `tick` in line 11)"
# What the constructor and the functions do, and what is told.
MEMBERS: dict[str, tuple[str, str, str, str, str | None]] = {
    "a member": ("", SET, READ, "", LAST),
    "one that nobody reads": ("", SET, "", "", None),
    "one that others set": ("", SET, READ, SET, None),
    "one that others set to nothing": ("", SET, READ, 'last_ = "";', LAST),
    "one that others set as at first": ("", SET, READ, 'last_ = "none";', LAST),
    "one that others clear": ("", SET, READ, "last_.clear();", LAST),
    "one that is set by a function": ("", "store(msg.data);", READ, "", LAST),
    "one that another function sets too": ("", SET, READ, "store(msg.data);", None),
    "one that others may set": ("", SET, READ, "keep(last_);", None),
    "one that others hand on": ("", SET, READ, "store(last_);", None),
    "one that unknown code may set": ("", SET, READ, 'get_parameter("x", last_);', None),
    "one through this": ("", "this->last_ = msg.data;", READ, "", LAST),
    "one that is set at first too": ('last_ = "x";', SET, READ, "", LAST),
    "one that is read at first": ("store(last_);", SET, "", "", None),
    "a list": ("", "list_.push_back(msg.data);", "if (list_.empty()) { return; }", "",
               "`list_` (read by `tick` in line 11)"),
    "a list that others fill": ("", "list_.push_back(msg.data);", "list_.front();",
                                "list_.push_back(msg.data);", None),
    "a flag": ("", "is_there_ = true;", "while (!is_there_) { rest(); }", "",
               "`is_there_` (waited for by `tick` in line 11)"),
    "a counter": ("", "++count_;", "use(count_ + 1);", "", "`count_` (read by `tick` in line 11)"),
    "a counter that others count": ("", "++count_;", "use(count_ + 1);", "count_ += 2;", None),
    "a part": ("", "twist_.linear.x = 1.0;", "use(twist_.linear.x + 1);", "twist_.angular.z = 2.0;",
               "`twist_` (read by `tick` in line 11)"),
    "a part of which others are read": ("", "twist_.linear.x = 1.0;", "use(twist_.angular.x + 1);",
                                        "", None),
    "a part of what others set": ("", "twist_.linear.x = 1.0;", "use(twist_.linear.x + 1);",
                                  "twist_ = next();", None),
    "a lock": ("", "std::lock_guard<std::mutex> lock(mutex_);",
               "std::lock_guard<std::mutex> lock(mutex_);", "", None),
    "a local variable": ("", "auto last = msg.data; last = msg.data;", READ, "", None),
}  # fmt: skip


def in_class(init: str, hear: str, tick: str, work: str) -> str:
    """Return the class with something in its functions."""
    text = CLASS
    for name, body in (("init", init), ("hear", hear), ("tick", tick), ("work", work)):
        text = text.replace(f"{{{name}}}", body)
    used = " ".join((init, hear, tick, work))
    lines = text.split("\n")
    return "\n".join(x for x in lines if "void store" not in x or "store(" in used)


@pytest.mark.parametrize("name", MEMBERS)
def test_what_is_no_longer_set_is_told(name: str) -> None:
    *bodies, expected = MEMBERS[name]
    found = told(in_class(*map(str, bodies)), "still-read", STOP)
    assert found == ([] if expected is None else [f"no longer set: {expected}"])


HEAD = "#include <ros/ros.h>\n#include <std_msgs/String.h>\n"
MAIN = """int main(int c, char** v) {
  ros::init(c, v, "n");
  ros::NodeHandle nh;
  BODY
}
"""
LAMBDA = (
    'ros::Subscriber in = nh.subscribe<std_msgs::String>("in", 1, '
    "[&](const std_msgs::StringConstPtr& m) { last = m->data; });"
)
LOOP = 'while (ros::ok()) { ROS_INFO("%s", last.c_str()); ros::spinOnce(); }'
LOOSE = {
    "a lambda that sets a variable of its function": (
        HEAD + MAIN.replace("BODY", f"std::string last;\n  {LAMBDA}\n  {LOOP}"),
        "`last` (read by `main` in line 6)",
    ),
    "a lambda that sets a global": (
        f"{HEAD}std::string last;\n" + MAIN.replace("BODY", f"{LAMBDA}\n  {LOOP}"),
        "`last` (read by `main` in line 6)",
    ),
    "a function that sets a global": (
        f"{HEAD}std::string last;\nvoid hear(const std_msgs::String& m) {{ last = m.data; }}\n"
        + MAIN.replace("BODY", f'auto in = nh.subscribe("in", 1, hear);\n  {LOOP}'),
        "`last` (read by `main` in line 8)",
    ),
}


@pytest.mark.parametrize("name", LOOSE)
def test_what_is_no_longer_set_outside_of_classes_is_told(name: str) -> None:
    text, expected = LOOSE[name]
    assert told(text, "still-read", STOP) == [f"no longer set: {expected}"]


def test_what_another_callback_sets_is_not_told() -> None:
    other = Subscription("in", InterfaceName("std_msgs", "String"), "work", AT)
    text = in_class("", SET, READ, SET)
    assert told(text, "still-read", Update(K.SUBSCRIPTION, "in", other, AT)) == []


PUB = 'ros::Publisher out = nh.advertise<std_msgs::String>("out", 1);'
RATE = "ros::Rate rate(5);"
SENT = "std_msgs::String m;\n    out.publish(m);"
KICK = "void kick() {{\n    std_msgs::String m;\n    out.publish(m);{}\n}}\n"
GLOBAL = f"{HEAD}ros::Publisher out;\n"
MADE = 'out = nh.advertise<std_msgs::String>("out", 1);\n  thing.on_kick = kick;'
IDLE = {
    "a loop": (
        HEAD
        + MAIN.replace(
            "BODY", f"{PUB}\n  {RATE}\n  while (ros::ok()) {{\n    {SENT}\n    rate.sleep();\n  }}"
        ),
        ["nothing is left to do for the loop in line 6"],
    ),
    "a loop that lets others work": (
        HEAD
        + MAIN.replace(
            "BODY",
            f"{PUB}\n  {RATE}\n  while (ros::ok()) {{\n    {SENT}\n    ros::spinOnce();\n"
            "    rate.sleep();\n  }",
        ),
        [],
    ),
    "a loop that was idle": (
        HEAD + MAIN.replace("BODY", f"{PUB}\n  {RATE}\n  while (wait()) {{ rate.sleep(); }}"),
        [],
    ),
    "a function that others call": (
        GLOBAL + KICK.format("") + MAIN.replace("BODY", MADE),
        ["nothing is left to do for `kick` (line 2)"],
    ),
    "a function with more in it": (
        GLOBAL + KICK.format(" work();") + MAIN.replace("BODY", MADE),
        [],
    ),
    "a callback that hears": (
        GLOBAL
        + "void hear(const std_msgs::String& m) { out.publish(m); }\n"
        + MAIN.replace("BODY", f'{MADE}\n  auto in = nh.subscribe("in", 1, hear);').replace(
            "thing.on_kick = kick;", ""
        ),
        ["nothing is left to do for `hear` (line 3)"],
    ),
}


@pytest.mark.parametrize("name", IDLE)
def test_what_does_nothing_any_more_is_told(name: str) -> None:
    text, expected = IDLE[name]
    assert told(text, "idle-code", Remove(K.PUBLISHER, "out", AT)) == expected


READS = 'std_msgs::String m;\n  m.data = nh.param<std::string>("x", "a");\n  out.publish(m);'


@pytest.mark.parametrize(
    ("sending", "rest", "expected"),
    [
        (READS, "", ["no longer read: `x`"]),
        (READS, 'use(nh.param<std::string>("x", "a"));', []),
        (READS.replace("m.data = ", 'm.data = nh.param<std::string>("y", "") + '), "",
         ["no longer read: `y`, `x`"]),
        ("std_msgs::String m;\n  out.publish(m);", "", []),
    ],
)  # fmt: skip
def test_parameters_that_nothing_reads_any_more(
    sending: str, rest: str, expected: list[str]
) -> None:
    text = HEAD + MAIN.replace("BODY", f"{PUB}\n  {sending}\n  {rest}")
    assert told(text, "unread-parameter", Remove(K.PUBLISHER, "out", AT)) == expected
