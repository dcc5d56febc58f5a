"""What changes of an endpoint where it stands; what no change names stays as it is."""

from __future__ import annotations

import pytest
from patches import check
from updated_nodes import PAIR, ROS1, patched

from plastron_tui.diagnostics import Span
from plastron_tui.model.kinds import (
    Endpoint,
    Message,
    Parameter,
    Publication,
    Publisher,
    Rate,
    Service,
    Subscription,
    Timer,
    kind_of,
)
from plastron_tui.model.source import EndpointKind, Update
from plastron_tui.model.values import MessageValue, Value
from plastron_tui.ros.interfaces import InterfaceName
from plastron_tui.ros.parameters import ParameterType
from plastron_tui.ros.qos import Qos
from plastron_tui.ros.qos_words import WORDS

K = EndpointKind
AT = Span(0, 0)
STRING, INT = InterfaceName("std_msgs", "String"), InterfaceName("std_msgs", "Int32")
POSE = InterfaceName("geometry_msgs", "PoseStamped")
TRIGGER, SET_BOOL = InterfaceName("std_srvs", "Trigger"), InterfaceName("std_srvs", "SetBool")


def sent(rate: float | None = None, **fields: Value) -> tuple[Publication, ...]:
    value = MessageValue(STRING, fields)
    return (Publication(Message("m", value, AT), rate or 10.0, AT, rate is None),)


UPDATES: list[tuple[str, str, str, Endpoint, list[tuple[str, str | None]]]] = [
    (
        "another type of a subscription in two files, with a stub",
        PAIR,
        "goal",
        Subscription("goal", INT, None, AT),
        [
            (
                "  goal_ = create_subscription<std_msgs::msg::String>(",
                "  goal_ = create_subscription<std_msgs::msg::Int32>(",
            ),
            (
                "void Robot::on_goal(const std_msgs::msg::String::SharedPtr msg)",
                "void Robot::on_goal(const std_msgs::msg::Int32::SharedPtr msg)",
            ),
            (
                "  void on_goal(const std_msgs::msg::String::SharedPtr msg);",
                "  void on_goal(const std_msgs::msg::Int32::SharedPtr msg);",
            ),
            (
                "  rclcpp::Subscription<std_msgs::msg::String>::SharedPtr goal_;",
                "  rclcpp::Subscription<std_msgs::msg::Int32>::SharedPtr goal_;",
            ),
            (
                "#include <std_msgs/msg/string.hpp>",
                "#include <std_msgs/msg/string.hpp>\n#include <std_msgs/msg/int32.hpp>",
            ),
        ],
    ),
    (
        "another type of a publisher that nothing publishes on, whose include is there",
        PAIR,
        "out",
        Publisher("out", STRING, (), AT),
        [
            (
                '  out_ = create_publisher<geometry_msgs::msg::PoseStamped>("out", 1);',
                '  out_ = create_publisher<std_msgs::msg::String>("out", 1);',
            ),
            (
                "  rclcpp::Publisher<geometry_msgs::msg::PoseStamped>::SharedPtr out_;",
                "  rclcpp::Publisher<std_msgs::msg::String>::SharedPtr out_;",
            ),
            ("#include <geometry_msgs/msg/pose_stamped.hpp>", None),
        ],
    ),
    (
        "another name, and a quality of service",
        PAIR,
        "out",
        Publisher("pose", POSE, (), AT, Qos(depth=6, reliability="best_effort")),
        [
            (
                '  out_ = create_publisher<geometry_msgs::msg::PoseStamped>("out", 1);',
                "  out_ = create_publisher<geometry_msgs::msg::PoseStamped>"
                '("pose", rclcpp::QoS(6).best_effort());',
            ),
        ],
    ),
    (
        "another function that the file has",
        PAIR,
        "goal",
        Subscription("goal", STRING, "on_other", AT),
        [
            (
                '    "goal", 3, std::bind(&Robot::on_goal, this, std::placeholders::_1));'
                "  // where to go",
                '    "goal", 3, std::bind(&Robot::on_other, this, std::placeholders::_1));'
                "  // where to go",
            ),
        ],
    ),
    (
        "a new name for a stub",
        PAIR,
        "goal",
        Subscription("goal", STRING, "arrive", AT),
        [
            (
                '    "goal", 3, std::bind(&Robot::on_goal, this, std::placeholders::_1));'
                "  // where to go",
                '    "goal", 3, std::bind(&Robot::arrive, this, std::placeholders::_1));'
                "  // where to go",
            ),
            (
                "void Robot::on_goal(const std_msgs::msg::String::SharedPtr msg)",
                "void Robot::arrive(const std_msgs::msg::String::SharedPtr msg)",
            ),
            (
                "  void on_goal(const std_msgs::msg::String::SharedPtr msg);",
                "  void arrive(const std_msgs::msg::String::SharedPtr msg);",
            ),
        ],
    ),
    (
        "a function that the file has not, for one with code in it",
        ROS1,
        "goal",
        Subscription("goal", STRING, "arrive", AT),
        [
            (
                '    goal_ = nh_.subscribe("goal", 3, &Robot::onGoal, this);',
                '    goal_ = nh_.subscribe("goal", 3, &Robot::arrive, this);',
            ),
            (
                "  void onGoal(const std_msgs::StringConstPtr& msg) { goal_text_ = msg->data; }",
                "  void onGoal(const std_msgs::StringConstPtr& msg) { goal_text_ = msg->data; }\n"
                "\n"
                "  void arrive(const std_msgs::StringConstPtr& msg) {\n"
                '    ROS_INFO_STREAM("goal: " << *msg);\n'
                "  }",
            ),
        ],
    ),
    (
        "a function that the statement names, with code for the old type",
        ROS1,
        "goal",
        Subscription("goal", INT, "onGoal", AT),
        [
            (
                "  void onGoal(const std_msgs::StringConstPtr& msg) { goal_text_ = msg->data; }",
                "  void onGoal(const std_msgs::Int32ConstPtr& msg) { goal_text_ = msg->data; }",
            ),
            (
                "#include <std_msgs/String.h>",
                "#include <std_msgs/String.h>\n#include <std_msgs/Int32.h>",
            ),
        ],
    ),
    (
        "the size of a queue and a latch of roscpp",
        ROS1,
        "out",
        Publisher("out", STRING, (), AT, WORDS["latched"].says._replace(depth=1)),
        [
            (
                '    out_ = nh_.advertise<std_msgs::String>("out", 5);',
                '    out_ = nh_.advertise<std_msgs::String>("out", 1, true);',
            ),
        ],
    ),
    (
        "the type of a service whose function is a stub",
        ROS1,
        "stop",
        Service("stop", SET_BOOL, None, AT),
        [
            (
                "  bool stop(std_srvs::Trigger::Request& req, std_srvs::Trigger::Response& res) {",
                "  bool stop(std_srvs::SetBool::Request& req, std_srvs::SetBool::Response& res) {",
            ),
            ("#include <std_srvs/Trigger.h>", "#include <std_srvs/SetBool.h>"),
        ],
    ),
    (
        "the rate of a timer",
        ROS1,
        "tick",
        Timer("tick", None, Rate(10.0), AT),
        [
            (
                "    timer_ = nh_.createTimer(ros::Duration(0.5), &Robot::tick, this);",
                "    timer_ = nh_.createTimer(ros::Duration(0.1), &Robot::tick, this);",
            ),
        ],
    ),
    (
        "what is published, and how often",
        ROS1,
        "out",
        Publisher("out", STRING, sent(4.0, data="there"), AT),
        [
            ('    text.data = "here";', '    text.data = "there";'),
            (
                "    timer_ = nh_.createTimer(ros::Duration(0.5), &Robot::tick, this);",
                "    timer_ = nh_.createTimer(ros::Duration(0.25), &Robot::tick, this);",
            ),
        ],
    ),
    (
        "the default of a parameter that is read into a variable",
        ROS1,
        "frame",
        Parameter("frame", None, ParameterType.STRING, "odom", span=AT),
        [
            (
                '    nh_.param<std::string>("frame", frame_, "map");',
                '    nh_.param<std::string>("frame", frame_, "odom");',
            ),
        ],
    ),
    (
        "the default of a parameter that a call returns",
        ROS1,
        "speed",
        Parameter("speed", None, ParameterType.FLOAT, 2.0, span=AT),
        [
            (
                '    speed_ = nh_.param("speed", 1.5);',
                '    speed_ = nh_.param("speed", 2.0);',
            ),
        ],
    ),
]


@pytest.mark.parametrize(
    ("text", "name", "endpoint", "edits"),
    [each[1:] for each in UPDATES],
    ids=[each[0] for each in UPDATES],
)
def test_an_update_changes_what_differs(
    text: str, name: str, endpoint: Endpoint, edits: list[tuple[str, str | None]]
) -> None:
    check(patched(text, *edits), Update(kind_of(type(endpoint)), name, endpoint, AT))


def test_code_for_the_old_type_is_told() -> None:
    _, text, name, endpoint, edits = next(each for each in UPDATES if "the statement" in each[0])
    told = check(patched(text, *edits), Update(K.SUBSCRIPTION, name, endpoint, AT))
    assert [each.message for each in told] == [
        "`onGoal` was written for `std_msgs/String`, and gets `std_msgs/Int32`, which has another"
        " `data`"
    ]
