"""What is published changes in the lines that publish; what was worked out, and goes, is told."""

from __future__ import annotations

import pytest
from patches import edit, sides

from plastron_tui.diagnostics import Diagnostic, Span
from plastron_tui.model.kinds import Message, Publication, Publisher
from plastron_tui.model.source import EndpointKind, FileSet, Update
from plastron_tui.model.values import MessageValue, Value
from plastron_tui.ros.interfaces import InterfaceName

K, AT = EndpointKind, Span(0, 0)
STRING, INT = InterfaceName("std_msgs", "String"), InterfaceName("std_msgs", "Int32")
POINT = InterfaceName("geometry_msgs", "PointStamped")


def publisher(
    name: str, type_: InterfaceName, *sent: tuple[dict[str, Value], float | None]
) -> Publisher:
    """Return a publisher of messages at rates; a rate of None is an open one."""
    publications = tuple(
        Publication(Message("m", MessageValue(type_, fields), AT), rate or 10.0, AT, rate is None)
        for fields, rate in sent
    )
    return Publisher(name, type_, publications, AT)


def updated(text: str, new: Publisher) -> tuple[list[str], list[Diagnostic]]:
    """Return the lines of a file with another publisher for `out`, and what is told."""
    files: FileSet = sides("".join(f" {line}\n" for line in text.strip().split("\n")))[0]
    after, told = edit(files, Update(K.PUBLISHER, "out", new, AT))
    assert after is not None, told
    return after.main.decode().rstrip("\n").split("\n"), list(told)


ROS2 = """#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/string.hpp>
class N : public rclcpp::Node {
 public:
  N() : Node("n") {
    out_ = create_publisher<std_msgs::msg::String>("out", rclcpp::QoS(3).best_effort());
    timer_ = create_wall_timer(500ms, std::bind(&N::tick, this));
  }
  void tick() {
BODY
  }
 private:
  rclcpp::Publisher<std_msgs::msg::String>::SharedPtr out_;
  rclcpp::TimerBase::SharedPtr timer_;
  std::string text_;
  int count_;
};
"""
ROS1 = """#include <ros/ros.h>
#include <std_msgs/String.h>
class N {
 public:
  N() {
    out_ = nh_.advertise<std_msgs::String>("out", 3, true);
    timer_ = nh_.createTimer(ros::Duration(0.5), &N::tick, this);
  }
  void tick(const ros::TimerEvent&) {
BODY
  }
 private:
  ros::NodeHandle nh_;
  ros::Publisher out_;
  ros::Timer timer_;
  std::string text_;
  int count_;
};
"""
S, N = "std_msgs::msg::String", "std_msgs::msg::Int32"
# How a message is made; how one of the same type with another value is, and one of another type.
MANNERS: dict[str, tuple[str, str, str]] = {
    "a local variable": (
        f'{S} m;\nm.data = "a";\nout_->publish(m);',
        f'{S} m;\nm.data = "b";\nout_->publish(m);',
        f"{N} m;\nm.data = 3;\nout_->publish(m);",
    ),
    "auto": (
        f'auto m = {S}();\nm.data = "a";\nout_->publish(m);',
        f'auto m = {S}();\nm.data = "b";\nout_->publish(m);',
        f"auto m = {N}();\nm.data = 3;\nout_->publish(m);",
    ),
    "braces": (
        f'{S} m{{}};\nm.data = "a";\nout_->publish(m);',
        f'{S} m{{}};\nm.data = "b";\nout_->publish(m);',
        f"{N} m{{}};\nm.data = 3;\nout_->publish(m);",
    ),
    "a unique pointer that is moved": (
        f'auto m = std::make_unique<{S}>();\nm->data = "a";\nout_->publish(std::move(m));',
        f'auto m = std::make_unique<{S}>();\nm->data = "b";\nout_->publish(std::move(m));',
        f"auto m = std::make_unique<{N}>();\nm->data = 3;\nout_->publish(std::move(m));",
    ),
    "a shared pointer": (
        f'auto m = std::make_shared<{S}>();\nm->data = "a";\nout_->publish(*m);',
        f'auto m = std::make_shared<{S}>();\nm->data = "b";\nout_->publish(*m);',
        f"auto m = std::make_shared<{N}>();\nm->data = 3;\nout_->publish(*m);",
    ),
    "a comment between": (
        f'{S} m;  // what\n// it is\nm.data = "a";  // this\n\nout_->publish(m);',
        f'{S} m;  // what\n// it is\nm.data = "b";  // this\n\nout_->publish(m);',
        f"{N} m;  // what\n// it is\nm.data = 3;  // this\n\nout_->publish(m);",
    ),
    "nothing that is set": (
        f"{S} m;\nout_->publish(m);",
        f'{S} m;\nm.data = "b";\nout_->publish(m);',
        f"{N} m;\nm.data = 3;\nout_->publish(m);",
    ),
    "an expression": (
        f"out_->publish({S}());",
        f'{S} out_message;\nout_message.data = "b";\nout_->publish(out_message);',
        f"{N} out_message;\nout_message.data = 3;\nout_->publish(out_message);",
    ),
    "a value under a condition": (
        f'{S} m;\nif (count_ > 3) {{\n  m.data = "a";\n}}\nout_->publish(m);',
        f'{S} out_message;\nout_message.data = "b";\nout_->publish(out_message);',
        f"{N} out_message;\nout_message.data = 3;\nout_->publish(out_message);",
    ),
    "a value that is already so": (
        f'{S} m;\nm.data = "b";\nout_->publish(m);',
        f'{S} m;\nm.data = "b";\nout_->publish(m);',
        f"{N} m;\nm.data = 3;\nout_->publish(m);",
    ),
}


def in_ros1(text: str) -> str:
    """Return code of ROS 2 as ROS 1 has it."""
    return text.replace("::msg::", "::").replace("out_->", "out_.").replace("make_unique", "x")


def body(text: str) -> list[str]:
    return [f"    {line}" if line else "" for line in text.split("\n")]


def whole(frame: str, text: str) -> list[str]:
    """Return the lines of a file with a body of its function."""
    head, tail = frame.strip().split("BODY\n")
    return [*head.rstrip("\n").split("\n"), *body(text), *tail.split("\n")]


# roscpp moves no messages.
@pytest.mark.parametrize(
    ("name", "ros"),
    [(name, ros) for name in MANNERS for ros in (1, 2) if ros == 2 or "moved" not in name],
)
def test_another_value_is_one_splice(name: str, ros: int) -> None:
    before, after, _ = MANNERS[name]
    frame = ROS2 if ros == 2 else ROS1
    if ros == 1:
        before, after = in_ros1(before), in_ros1(after)
    text = "\n".join(whole(frame, before))
    found, told = updated(text, publisher("out", STRING, ({"data": "b"}, None)))
    assert (found, told) == (whole(frame, after), [])


@pytest.mark.parametrize("name", MANNERS)
def test_another_type_changes_publisher_message_and_include(name: str) -> None:
    before, _, after = MANNERS[name]
    text = "\n".join(whole(ROS2, before))
    found, told = updated(text, publisher("out", INT, ({"data": 3}, None)))
    frame = ROS2.replace("msg::String", "msg::Int32").replace("msg/string", "msg/int32")
    assert (found, told) == (whole(frame, after), [])


def test_rate_and_name_change_with_it() -> None:
    before, _, after = MANNERS["a local variable"]
    text = "\n".join(whole(ROS2, before))
    found, _ = updated(text, publisher("number", INT, ({"data": 3}, 4.0)))
    frame = ROS2.replace("msg::String", "msg::Int32").replace("msg/string", "msg/int32")
    frame = frame.replace("500ms", "250ms").replace('"out"', '"number"')
    assert found == whole(frame, after)


LOOP = """#include <ros/ros.h>
#include <std_msgs/String.h>
int main(int argc, char** argv) {
  ros::init(argc, argv, "n");
  ros::NodeHandle nh;
  ros::Publisher out = nh.advertise<std_msgs::String>("out", 3);
  ros::Rate rate(RATE);
  while (ros::ok()) {
    std_msgs::String m;
    m.data = "a";
    out.publish(m);
    ros::spinOnce();
    rate.sleep();
  }
}"""


@pytest.mark.parametrize(("written", "hertz", "expected"), [("10", 20.0, "20"), ("5", 2.5, "2.5")])
def test_a_loop_gets_another_rate(written: str, hertz: float, expected: str) -> None:
    new = publisher("out", STRING, ({"data": "a"}, hertz))
    found, told = updated(LOOP.replace("RATE", written), new)
    assert (found, told) == (LOOP.replace("RATE", expected).split("\n"), [])


def test_a_loop_that_does_more_keeps_its_rate() -> None:
    text = LOOP.replace("RATE", "10").replace("    ros::spinOnce", "    work();\n    ros::spinOnce")
    found, told = updated(text, publisher("out", STRING, ({"data": "b"}, 20.0)))
    assert "  ros::Rate rate(10);" in found
    assert "    work();" in found
    assert not any("out.publish(m)" in line for line in found)
    assert [each.message for each in told] == [
        "line 11 no longer decides when `out` is sent: that is 20 times a second"
    ]


STAMPED = {
    "a stamp that it has": (
        "geometry_msgs::msg::PointStamped m;\nm.header.stamp = now();\nm.point.x = 1.0;\n"
        "out_->publish(m);",
        "geometry_msgs::msg::PointStamped m;\nm.header.stamp = now();\nm.point.x = 2.0;\n"
        "out_->publish(m);",
        [],
    ),
    "one that it has not": (
        "geometry_msgs::msg::PointStamped m;\nm.point.x = 1.0;\nout_->publish(m);",
        "geometry_msgs::msg::PointStamped m;\nm.point.x = 2.0;\nm.header.stamp = now();\n"
        "out_->publish(m);",
        [],
    ),
    "a field that goes": (
        "geometry_msgs::msg::PointStamped m;\nm.header.stamp = now();\nm.point.x = 1.0;\n"
        "m.point.y = 1.0;\nout_->publish(m);",
        "geometry_msgs::msg::PointStamped m;\nm.header.stamp = now();\nm.point.x = 2.0;\n"
        "out_->publish(m);",
        [],
    ),
    "one that goes with the type": (
        "geometry_msgs::msg::PointStamped m;\nm.header.stamp = stamp_;\nm.point.x = 2.0;\n"
        "out_->publish(m);",
        "geometry_msgs::msg::PointStamped m;\nm.header.stamp = stamp_;\nm.point.x = 2.0;\n"
        "out_->publish(m);",
        [],
    ),
    "a field that is worked out and goes": (
        "geometry_msgs::msg::PointStamped m;\nm.header.stamp = now();\nm.point.x = 1.0;\n"
        "m.point.y = high(count_);\nout_->publish(m);",
        "geometry_msgs::msg::PointStamped m;\nm.header.stamp = now();\nm.point.x = 2.0;\n"
        "out_->publish(m);",
        ["`out` no longer sends `high(count_)`, which the node works out"],
    ),
}


@pytest.mark.parametrize("name", STAMPED)
def test_fields_come_and_go(name: str) -> None:
    before, after, expected = STAMPED[name]
    frame = ROS2.replace("std_msgs::msg::String", "geometry_msgs::msg::PointStamped")
    frame = frame.replace("std_msgs/msg/string", "geometry_msgs/msg/point_stamped")
    point = MessageValue(InterfaceName("geometry_msgs", "Point"), {"x": 2.0})
    text = "\n".join(whole(frame, before))
    found, told = updated(text, publisher("out", POINT, ({"point": point}, None)))
    assert found == whole(frame, after)
    assert [each.message for each in told] == expected


WORKED_OUT = {
    f'{S} m;\nm.data = text_ + "x";\nout_->publish(m);': 'text_ + "x"',
    f"{S} m;\nm.data = text_;\nout_->publish(m);": "text_",
    "auto m = make(count_);\nm.data = std::to_string(count_++);\nout_->publish(m);": (
        "std::to_string(count_++)"
    ),
    "out_->publish(make(count_));": "make(count_)",
}


@pytest.mark.parametrize("before", WORKED_OUT)
def test_what_the_node_works_out_is_told(before: str) -> None:
    text = "\n".join(whole(ROS2, before))
    _, told = updated(text, publisher("other", STRING, ({"data": "b"}, None)))
    expected = f"`other` no longer sends `{WORKED_OUT[before]}`, which the node works out"
    assert [(each.code, each.message) for each in told] == [("written-anew", expected)]
    assert told[0].help == "`renames topic 'out' to 'other'` keeps it"


def test_more_messages_than_before_are_sent_anew_by_the_same_publisher() -> None:
    before, _, _ = MANNERS["a local variable"]
    text = "\n".join(whole(ROS2, before))
    new = publisher("out", STRING, ({"data": "x"}, None), ({"data": "y"}, None))
    found, told = updated(text, new)
    assert ROS2.split("\n")[5] in found
    assert sum("out_->publish(" in line for line in found) == 2
    assert [each.message for each in told] == ["line 12 no longer decides when `out` is sent"]


def test_a_publisher_that_keeps_nothing_is_made_anew_for_what_is_sent_once() -> None:
    text = "\n".join(whole(ROS2, MANNERS["a local variable"][0]))
    once = publisher("out", STRING, ({"data": "x"}, None))
    sent = tuple(each._replace(is_once=True, rate=0.0) for each in once.publications)
    found, _ = updated(text, once._replace(publications=sent))
    assert any("transient_local" in line for line in found)
