"""What edits write fits the types, scopes and lines of the files that it goes into.

Each case was one that a compiler did not take.
"""

from __future__ import annotations

import pytest
from additions import AT, interface, publish, repeat, send_goal, subscribe
from manners import files
from patches import edit, shown

from plastron_tui.model.kinds import Parameter, Service
from plastron_tui.model.source import Add, EndpointKind, Remove, Update
from plastron_tui.model.values import Computed, MessageValue, OfParameter
from plastron_tui.ros.interfaces import FieldType
from plastron_tui.ros.parameters import ParameterType
from plastron_tui.sources.cpp.editing.plans import with_splices
from plastron_tui.sources.cpp.editing.refusals import RefusedError
from plastron_tui.sources.splices import Splice

K = EndpointKind


def node(body: str, members: str = "", includes: str = "") -> str:
    """Return a node of ROS 1 that is a class, whose constructor does something."""
    return f"""\
#include <ros/ros.h>
{includes}
class A
{{
public:
  A()
  {{
    {body}
  }}

private:
  ros::NodeHandle nh_;
{members}}};
"""


def program(body: str, before: str = "") -> str:
    """Return a node of ROS 1 that is a function."""
    return f"""\
#include <ros/ros.h>
#include <std_msgs/Empty.h>
{before}
int main(int argc, char ** argv)
{{
  ros::init(argc, argv, "a");
  ros::NodeHandle nh, pnh("~");
  {body}
  ros::spin();
}}
"""


WALL = node(
    "wall_ = nh_.createWallTimer(ros::WallDuration(1), &A::look, this);",
    "  void look(const ros::WallTimerEvent &) {}\n  ros::WallTimer wall_;\n",
)
FILTER = node(
    'scans_ = std::make_shared<Scans>(nh_, "scan", 2);',
    "  using Scans = message_filters::Subscriber<sensor_msgs::LaserScan>;\n"
    "  std::shared_ptr<Scans> scans_;\n",
    "#include <message_filters/subscriber.h>\n#include <sensor_msgs/LaserScan.h>\n",
)
GAIN = Computed(OfParameter("~/gain"), (), FieldType("float32"))
ALIAS = """\
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/string.hpp>
template<class T>
using Pub = typename rclcpp::Publisher<T>::SharedPtr;
class A : public rclcpp::Node
{
public:
  A() : Node("a") {a_ = create_publisher<std_msgs::msg::String>("a", 1);}
  Pub<std_msgs::msg::String> a_;
};
"""
EMPTY = interface("std_srvs/Empty")
LIMIT = program('float limit; pnh.param("limit", limit, 0.5f); use(limit);')


def of_limit(holds: str, default: object) -> Update:
    new = Parameter("~/limit", None, ParameterType(holds), default, span=AT)
    return Update(K.PARAMETER, "~/limit", new, AT)


CASES = {
    "a timer beside one of another clock": (
        WALL,
        [repeat("tick", 4.0)],
        ["ros::Timer tick_;"],
    ),
    "a subscription beside one of a filter": (
        FILTER,
        [subscribe("imu")],
        ["ros::Subscriber imu_;"],
    ),
    "a handle that a lambda reads of": (
        program(
            'double gain = pnh.param("gain", 1.0); use(gain);\n'
            '  ros::Publisher a = nh.advertise<std_msgs::Empty>("a", 1);'
        ),
        [publish("b", "std_msgs/Float32", rate=2.0, data=GAIN)],
        [", pnh](const ros::TimerEvent", 'message.data = pnh.param<double>("gain", 1.0);'],
    ),
    "a publisher of an inner block": (
        program(
            'if (argc > 1) {\n    ros::Publisher a = nh.advertise<std_msgs::String>("a", 1);\n'
            "    ros::spin();\n  }"
        ),
        [publish("a", rate=2.0, data="x")],
        ['("a", 1);\n    ros::Timer a_timer = nh.createTimer('],
    ),
    "a variable of the file in a lambda": (
        program('a = nh.advertise<std_msgs::String>("a", 1);', "static ros::Publisher a;\n"),
        [publish("a", rate=2.0, data="x")],
        ["[](const ros::TimerEvent"],
    ),
    "a timer that may be called as its function": (
        program("ros::Timer first = nh.createTimer(ros::Duration(1), look);"),
        [repeat("blink", 4.0)],
        ["ros::Timer blink_2 = nh.createTimer(ros::Duration(0.25), blink);"],
    ),
    "a handle that does not change": (
        """\
#include <ros/ros.h>
class A
{
public:
  explicit A(const ros::NodeHandle & nh) : nh_(nh) {a_ = nh_.advertise<std_msgs::Empty>("a", 1);}
  const ros::NodeHandle nh_;
  ros::Publisher a_;
};
""",
        [send_goal("seek", 1)],
        ["ros::NodeHandle action_nh(nh_);", '(action_nh, "seek", true)'],
    ),
    "a number of another type than `double`": (
        LIMIT,
        [of_limit("float", 0.25)],
        ['pnh.param("limit", limit, 0.25f);'],
    ),
    "a pointer that another name hides": (
        ALIAS,
        [publish("a", rate=2.0, data="x")],
        ["a_->publish(message);"],
    ),
    "all names of a declaration": (
        node(
            "fast_ = nh_.createTimer(ros::Duration(1), &A::tick, this);\n"
            "    late_ = nh_.createTimer(ros::Duration(2), &A::tick, this);",
            "  void tick(const ros::TimerEvent &) {use(nh_);}\n  ros::Timer fast_, late_;\n",
        ),
        [Remove(K.TIMER, "tick")],
        ["  void tick(const ros::TimerEvent &) {use(nh_);}\n};"],
    ),
    "the first two names of a declaration": (
        node(
            "\n    ".join(
                f'{each}_ = nh_.advertise<std_msgs::Empty>("{each}", 1);' for each in "abc"
            ),
            "  ros::Publisher a_, b_, c_;\n",
        ),
        [Remove(K.PUBLISHER, "a"), Remove(K.PUBLISHER, "b")],
        ["  ros::Publisher c_;\n"],
    ),
    "a semicolon behind a function": (
        node(
            'a_ = nh_.subscribe("a", 1, &A::hear, this);',
            "  void hear(const std_msgs::Empty &) {};\n  ros::Subscriber a_;\n",
        ),
        [Remove(K.SUBSCRIPTION, "a")],
        ["  ros::NodeHandle nh_;\n};"],
    ),
    "an answer that fills nothing": (
        node('a_ = nh_.advertise<std_msgs::Empty>("a", 1);', "  ros::Publisher a_;\n"),
        [Add(Service("go", EMPTY, None, span=AT, answer=MessageValue(EMPTY, {})))],
        ["    (void)res;\n    return true;"],
    ),
}


@pytest.mark.parametrize("case", CASES)
def test_what_is_written_fits(case):
    text, changes, wanted = CASES[case]
    current = files(text)
    for change in changes:
        changed, told = edit(current, change)
        assert changed is not None, [each.message for each in told]
        current = changed
    for part in wanted:
        assert part in shown(current), shown(current)


def test_a_parameter_keeps_the_type_that_its_call_has():
    changed, _ = edit(files(LIMIT), of_limit("string", "x"))
    assert 'pnh.param("limit", limit' not in shown(changed)
    assert 'pnh.param<std::string>("limit", "x")' in shown(changed)


def test_a_publisher_of_a_condition_is_sent_through_there_alone():
    text = program('if (ros::Publisher a = nh.advertise<std_msgs::String>("a", 1); a)\n    go();')
    changed, told = edit(files(text), publish("a", rate=2.0, data="x"))
    assert changed is None
    assert "no variable of the file holds `a`" in told[0].message


def test_a_callback_that_logs_a_field_of_the_old_type():
    text = node(
        'a_ = nh_.subscribe("a", 1, &A::hear, this);',
        '  void hear(const std_msgs::Int32 & m) {ROS_INFO("%d", m.data);}\n  ros::Subscriber a_;\n',
        "#include <std_msgs/Int32.h>\n",
    )
    new = subscribe("a", "sensor_msgs/Imu").endpoint
    changed, _ = edit(files(text), Update(K.SUBSCRIPTION, "a", new, AT))
    assert "void hear(const sensor_msgs::Imu" not in shown(changed)
    assert interface("sensor_msgs/Imu") == new.type


def test_what_is_in_a_file_of_another_node_is_not_changed():
    with pytest.raises(RefusedError, match="a file of another node"):
        with_splices(files(ALIAS), {"other.cpp": [Splice(0, 0, b"x")]})
