"""What is written for each part of a node of ROS 1 in C++, and what is refused."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import given, settings
from machine import examples
from random_programs import random_programs

from plastron_tui.diagnostics import codes
from plastron_tui.ros.catalog import Catalog
from plastron_tui.session import Session
from plastron_tui.sources.base import Rendered
from plastron_tui.targets import find_target
from plastron_tui.targets.cpp.target import CppTarget

LIBRARIES = ["roscpp", "nodelet"]
FOLDERS = (Path(__file__).parents[1] / "programs", Path(__file__).parents[2] / "examples")
PROGRAMS = [
    file
    for folder in FOLDERS
    for file in sorted(folder.glob("*.plastron"))
    # The catalog of a distribution has no types of a program.
    if "create_message_type" not in file.read_text()
]


def rendered(statements: str, library: str, layout: str = "") -> list[Rendered]:
    """Write the nodes of a program, as a front end does; what is loaded is left out."""
    target = find_target(library)
    assert isinstance(target, CppTarget)
    target.set_layouts({"cpp": layout} if layout else {})
    nodes = Session(statements.encode()).workspace.nodes.values()
    catalog = Catalog("noetic")
    return [target.render(node, catalog) for node in nodes if target.unwritable(node) is None]


def text(statements: str, library: str) -> str:
    """Write the one node `n`, on one line: where lines are broken is the layout's."""
    [made] = rendered(f"create_node 'robot' as n\n{statements}", library)
    assert made.files is not None, made.diagnostics
    return " ".join(made.files.main.decode().split()).replace("( ", "(")


HELLO = 'create_message m of message_type String and input "hello"\n'
HEARD = "subscribe n to 'heard' of message_type Point\n"
ECHO = f"{HEARD}create_message m of message_type Point and input x=received.y + 1\n"
OFTEN = "n has_parameter 'often' of parameter_type float with default 5 between 1 and 9\n"
STAMPED = "geometry_msgs/PointStamped"

WRITTEN = {
    "rate": (
        f"{HELLO}n publish m to 'out' of message_type String at 2 hz",
        'out_publisher_ = nh_.advertise<std_msgs::String>("out", 10);',
        "out_timer_ = nh_.createTimer(ros::Duration(1.0 / 2.0), &RobotNode::publish_out, this);",
        'std_msgs::String message; message.data = "hello"; out_publisher_.publish(message);',
    ),
    "private": (
        f"{HELLO}n publish m to '~/out' of message_type String at 2 hz",
        'private_nh_.advertise<std_msgs::String>("out", 10);',
        'ros::NodeHandle private_nh_{"~"};',
    ),
    "queue and latch": (
        f"{HELLO}n publish m to 'out' of message_type String at 2 hz with qos latched, depth 3",
        'advertise<std_msgs::String>("out", 3, true)',
    ),
    "once": (
        f"{HELLO}n publish m to 'out' of message_type String once",
        'advertise<std_msgs::String>("out", 1, true)',
        "publish_out(); out_timer_ = nh_.createTimer(ros::Duration(5.0)",
        "if (out_publisher_.getNumSubscribers() > 0) { out_timer_.stop(); }",
    ),
    "stamped": (
        f"create_message m of message_type {STAMPED} and input point.x=1\n"
        f"n publish m to 'out' of message_type {STAMPED} at 2 hz",
        "message.point.x = 1.0; message.header.stamp = ros::Time::now(); out_publisher_.publish",
    ),
    "several messages": (
        f"{HELLO}n publish m to 'out' of message_type String at 2 hz\n"
        'create_message b of message_type String and input "b"\n'
        "n publish b to 'out' of message_type String at 2 hz",
        'message.data = "hello"; out_publisher_.publish(message); } { std_msgs::String message;',
    ),
    "for each": (
        f"{ECHO}n publish m to 'out' of message_type Point for_each 'heard' when received.x < 2",
        "void publish_out(const geometry_msgs::Point & received) { if (received.x < 2.0) {",
        "void on_heard(const geometry_msgs::Point & message) { publish_out(message); }",
    ),
    "for each, whatever it is": (
        f"{HEARD}{HELLO}n publish m to 'out' of message_type String for_each 'heard'",
        "void publish_out(const geometry_msgs::Point &) {",
    ),
    "unsure": (
        "subscribe n to 'joy' of message_type sensor_msgs/Joy\n"
        "create_message m of message_type Float64 and input received.axes[1]\n"
        "n publish m to 'out' of message_type Float64 for_each 'joy'",
        "try { std_msgs::Float64 message; message.data = received.axes.at(1);",
        "} catch (const std::exception & error) { "
        'ROS_WARN_STREAM_THROTTLE(5, "out, of received.axes[1]: " << error.what());',
    ),
    "subscription": (
        "subscribe n to 'in' of message_type String with qos depth 3",
        'in_subscription_ = nh_.subscribe("in", 3, &RobotNode::on_in, this);',
        'ROS_INFO_STREAM("in: " << message);',
    ),
    "one callback for two types": (
        "subscribe n to 'a' of message_type String calling hear\n"
        "subscribe n to 'b' of message_type Int32 calling hear",
        'nh_.subscribe<std_msgs::Int32>("b", 0, &RobotNode::hear, this);',
        "void hear(const std_msgs::Int32::ConstPtr & message)",
        'ROS_INFO_STREAM("b: " << *message);',
    ),
    "service": (
        "n provides_service 'ask' of service_type Trigger",
        'ask_service_ = nh_.advertiseService("ask", &RobotNode::handle_ask, this);',
        "bool handle_ask(std_srvs::Trigger::Request & request, "
        "std_srvs::Trigger::Response & response)",
        "(void)response; return true;",
    ),
    "answer": (
        "n provides_service 'sum' of service_type AddTwoInts answering sum=received.a * 2",
        "try { response.sum = in_range<int64_t>(",
        "return false; } return true;",
    ),
    "calls once": (
        "n client_requests 'on' of service_type SetBool with input True",
        'on_client_ = nh_.serviceClient<std_srvs::SetBool>("on");',
        "if (is_served(on_client_)) { std_srvs::SetBool call; call.request.data = true; "
        "ask(on_client_, call); }",
        "int main(int argc, char ** argv) { "
        'ros::init(argc, argv, "robot"); // roscpp handles SIGINT alone. '
        "std::signal(SIGTERM, [](int) {ros::requestShutdown();}); "
        "RobotNode node; return node.run(); }",
        "return ros::ok() ? exit_status_ : 0;",
    ),
    "calls beside other work": (
        f"{HEARD}n client_requests 'on' of service_type SetBool with input True",
        "on_calls_ = std::async(std::launch::async, &RobotNode::call_on, this);",
        "if (wait_until_served(on_client_)) {",
        "RobotNode node; ros::spin(); return 0;",
    ),
    "calls at a rate": (
        "n client_requests 'on' of service_type SetBool with input True at 5 hz",
        "nh_.createTimer(ros::Duration(1.0 / 5.0), &RobotNode::repeat_on, this);",
        "if (!on_calls_.valid() || on_calls_.wait_for(at_once) == std::future_status::ready) {",
    ),
    "timer": (
        "n repeats look at 4 hz",
        "nh_.createTimer(ros::Duration(1.0 / 4.0), &RobotNode::look, this);",
        'void look(const ros::TimerEvent &) { ROS_INFO_STREAM_THROTTLE(1, "look"); }',
    ),
    "parameter": (
        f"{OFTEN}{HELLO}n publish m to 'out' of message_type String at parameter 'often' hz",
        'if (!private_nh_.hasParam("often")) { private_nh_.setParam("often", 5.0); }',
        'private_nh_.getParamCached("often", value); if (is_good && 1.0 <= value && value <= 9.0)',
        "double often_parameter_ = 5.0;",
        "rates_timer_ = nh_.createWallTimer(ros::WallDuration(0.1), &RobotNode::follow_rates",
        "out_timer_.setPeriod(ros::Duration(1.0 / out_timer_rate_));",
    ),
    "integer": (
        "n has_parameter 'count' of parameter_type int with default 3",
        "const bool is_so = found.getType() == Value::TypeInt;",
    ),
    "list": (
        "n has_parameter 'ports' of parameter_type int_list with default [80, 443]",
        "std::vector<int> ports_parameter_ = {80, 443};",
        "is_list(found, {Value::TypeInt})",
    ),
    "action": (
        "n provides_action 'count' of action_type Fibonacci calling work_on",
        'count_server_ = std::make_unique<CountServer>(nh_, "count", '
        "boost::bind(&RobotNode::work_on, this, boost::placeholders::_1), false);",
        "count_server_->setSucceeded(actionlib_tutorials::FibonacciResult());",
        "node.end_goals();",
    ),
    "goal": (
        "n sends_goal to 'count' of action_type Fibonacci with input order=5",
        'count_client_ = std::make_unique<CountClient>(nh_, "count");',
        'if (wait_for_action(*count_client_, "count")) { actionlib_tutorials::FibonacciGoal goal; '
        'goal.order = 5; send_goal(*count_client_, "count", goal); }',
    ),
    "names that only digits tell apart": (
        "n sends_goal to 'a1' of action_type Fibonacci with input order=5\n"
        "n sends_goal to 'a_1' of action_type Fibonacci with input order=5",
        "using A1Client = ",
        "using A_1Client = ",
    ),
    "two names that are one in C++": (
        "n has_parameter 'a_b' of parameter_type int with default 1\n"
        "n has_parameter 'a/b' of parameter_type int with default 2\n"
        "create_message m of message_type Int32 and input parameter 'a/b'\n"
        "n publish m to 'out' of message_type Int32 at 2 hz",
        "message.data = get_a_b_2();",
    ),
}


@pytest.mark.parametrize("case", WRITTEN)
def test_what_is_written_in_a_node(case: str) -> None:
    statements, *parts = WRITTEN[case]
    source = text(statements, "roscpp")
    for part in parts:
        assert part in source
    assert not any(word in source for word in ("NODELET_", "getNodeHandle", "nodelet"))


@pytest.mark.parametrize("case", WRITTEN)
def test_what_is_written_in_a_nodelet(case: str) -> None:
    statements, *_ = WRITTEN[case]
    source = text(statements, "nodelet")
    assert "namespace robot { " in source
    assert "class RobotNode : public nodelet::Nodelet" in source
    assert "void onInit() override {" in source
    assert source.endswith("PLUGINLIB_EXPORT_CLASS(robot::RobotNode, nodelet::Nodelet)")
    assert not any(word in source for word in ("ROS_INFO", "ros::spin", "nh_.", "main(", "exit_"))
    # What goes on in threads has an end when the nodelet is unloaded, and not only with ROS.
    goes_on = "std::async" in source or "SimpleAction" in source
    for end in ("is_ending_ = true;", "std::atomic<bool> is_ending_{false};", "override { is_end"):
        assert (end in source) == goes_on
    assert source.count("ros::ok()") == source.count("is_running() const")


REFUSED = {
    "a keyword": ("n repeats delete at 4 hz", "cannot be a name in C++"),
    "a macro": ("n repeats errno at 4 hz", "cannot be a name in C++"),
    "the compiler's own": ("n repeats _Look at 4 hz", "cannot be a name in C++"),
    "the class": ("n repeats RobotNode at 4 hz", "is a name that every"),
    "a method": ("n repeats follow_rates at 4 hz", "is a name that every"),
    "an attribute": ("n repeats nh_ at 4 hz", "is a name that every"),
    "a task": (
        "n client_requests 'on' of service_type SetBool with input True\n"
        "subscribe n to 'a' of message_type String calling ask",
        "with calls or actions has",
    ),
}


@pytest.mark.parametrize("library", LIBRARIES)
@pytest.mark.parametrize("case", REFUSED)
def test_what_is_refused(library: str, case: str) -> None:
    statements, message = REFUSED[case]
    [made] = rendered(f"create_node 'robot' as n\n{statements}", library)
    [diagnostic] = made.diagnostics
    assert diagnostic.code is codes.INVALID_FUNCTION
    assert message in diagnostic.message


def test_a_nodelet_has_what_its_base_has() -> None:
    statements = "create_node 'robot' as n\nn repeats getName at 4 hz"
    [made] = rendered(statements, "nodelet")
    assert made.files is None
    [made] = rendered(statements, "roscpp")
    assert made.files is not None


def lines_of(program: str, library: str) -> list[str]:
    made = rendered(program, library)
    assert all(each.files is not None for each in made), [each.diagnostics for each in made]
    texts = [file.decode() for each in made if each.files for _, file in each.files.texts]
    return [line for each in texts for line in each.splitlines()]


@pytest.mark.parametrize("library", LIBRARIES)
@pytest.mark.parametrize("program", PROGRAMS, ids=lambda path: path.stem)
def test_every_program_is_written(program: Path, library: str) -> None:
    lines = lines_of(program.read_text(), library)
    assert [line for line in lines if len(line) > 100] == []


@pytest.mark.parametrize("library", LIBRARIES)
@settings(max_examples=examples(40), deadline=None)
@given(program=random_programs("rospy"))
def test_every_random_program_is_written(library: str, program: str) -> None:
    lines = lines_of(program, library)
    assert [line for line in lines if len(line) > 100] == []
