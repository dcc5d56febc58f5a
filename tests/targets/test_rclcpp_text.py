"""What is written for each part of a node of ROS 2 in C++, and what is refused."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from hypothesis import given, settings
from machine import examples
from random_programs import random_programs

from plastron_tui.diagnostics import codes
from plastron_tui.model.workspace import Home
from plastron_tui.ros.catalog import Catalog
from plastron_tui.session import Options, Session
from plastron_tui.sources.base import Rendered
from plastron_tui.targets import find_target

LIBRARIES = ["rclcpp", "component"]
FOLDERS = (Path(__file__).parents[1] / "programs", Path(__file__).parents[2] / "examples")
PROGRAMS = [
    file
    for folder in FOLDERS
    for file in sorted(folder.glob("*.plastron"))
    # The catalog of a distribution has no types of a program.
    if "create_message_type" not in file.read_text()
]


def rendered(statements: str, library: str) -> list[Rendered]:
    """Write the nodes of a program, as a front end does; what is loaded is left out."""
    target = find_target(library)
    assert target is not None
    nodes = Session(statements.encode(), options=Options("rclpy")).workspace.nodes.values()
    catalog = Catalog("kilted")
    return [target.render(node, catalog) for node in nodes if target.unwritable(node) is None]


def files(statements: str, library: str, managed: str = "") -> dict[str, str]:
    """Write the one node `n`, each file on one line: where lines are broken is the layout's."""
    [made] = rendered(f"create_node 'robot' as n {managed}\n{statements}", library)
    assert made.files is not None, made.diagnostics
    texts = ((name, " ".join(text.decode().split())) for name, text in made.files.texts)
    # Lists of templates, and bodies of functions, keep their space.
    return {name: re.sub(r"([(]) ", r"\1", text) for name, text in texts}


HELLO = 'create_message m of message_type String and input "hello"\n'
HEARD = "subscribe n to 'heard' of message_type Point\n"
ECHO = f"{HEARD}create_message m of message_type Point and input x=received.y + 1\n"
OFTEN = "n has_parameter 'often' of parameter_type float with default 5 between 1 and 9\n"
STAMPED = "geometry_msgs/PointStamped"
FIBONACCI = "example_interfaces::action::Fibonacci"

SPIN = "rclcpp::spin(std::make_shared<RobotNode>());"
QUIET = (
    "catch (const std::exception &) { "
    "// Ctrl-C ends ROS at once: what fails after that is no mistake. "
    "if (rclcpp::ok()) { throw; } } rclcpp::shutdown();"
)

WRITTEN = {
    "rate": (
        f"{HELLO}n publish m to 'out' of message_type String at 2 hz",
        'out_publisher_ = create_publisher<std_msgs::msg::String>("out", 10);',
        "rclcpp::create_timer(this, get_clock(), std::chrono::milliseconds(500), "
        "std::bind(&RobotNode::publish_out, this));",
        'std_msgs::msg::String message; message.data = "hello"; out_publisher_->publish(message);',
    ),
    "rate of no whole milliseconds": (
        f"{HELLO}n publish m to 'out' of message_type String at 3 hz",
        "rclcpp::create_timer(this, get_clock(), std::chrono::duration<double>(1.0 / 3.0), ",
    ),
    "quality": (
        f"{HELLO}n publish m to 'out' of message_type String at 2 hz "
        "with qos latched, deadline 0.5",
        '("out", rclcpp::QoS(1).transient_local().deadline(rclcpp::Duration::from_seconds(0.5)));',
    ),
    "once": (
        f"{HELLO}n publish m to 'out' of message_type String once",
        "create_wall_timer(std::chrono::milliseconds(200), std::bind(&RobotNode::publish_out, this)"
        ");",
        "const bool was_heard = out_is_heard_; "
        "out_is_heard_ = out_publisher_->get_subscription_count() > 0;",
        "} else if (was_heard) {",
        "out_timer_->cancel(); std_msgs::msg::String message;",
    ),
    "stamped": (
        f"create_message m of message_type {STAMPED} and input point.x=1\n"
        f"n publish m to 'out' of message_type {STAMPED} at 2 hz",
        "message.point.x = 1.0; message.header.stamp = now(); out_publisher_->publish",
    ),
    "several messages": (
        f"{HELLO}n publish m to 'out' of message_type String at 2 hz\n"
        'create_message b of message_type String and input "b"\n'
        "n publish b to 'out' of message_type String at 2 hz",
        'message.data = "hello"; out_publisher_->publish(message); } { std_msgs::msg::String',
    ),
    "for each": (
        f"{ECHO}n publish m to 'out' of message_type Point for_each 'heard' when received.x < 2",
        "publish_out(const geometry_msgs::msg::Point & received) { if (received.x < 2.0) {",
        "on_heard(const geometry_msgs::msg::Point & message) { publish_out(message); }",
    ),
    "for each, whatever it is": (
        f"{HEARD}{HELLO}n publish m to 'out' of message_type String for_each 'heard'",
        "publish_out(const geometry_msgs::msg::Point &) {",
    ),
    "unsure": (
        "subscribe n to 'joy' of message_type sensor_msgs/Joy\n"
        "create_message m of message_type Float64 and input received.axes[1]\n"
        "n publish m to 'out' of message_type Float64 for_each 'joy'",
        "try { std_msgs::msg::Float64 message; message.data = received.axes.at(1);",
        "} catch (const std::out_of_range & error) { RCLCPP_WARN_THROTTLE(get_logger(), "
        '*get_clock(), 5000, "out, of received.axes[1]: %s", error.what());',
    ),
    "subscription": (
        "subscribe n to 'in' of message_type String with qos sensor_data",
        "in_subscription_ = create_subscription<std_msgs::msg::String>("
        '"in", rclcpp::SensorDataQoS(), '
        "std::bind(&RobotNode::on_in, this, std::placeholders::_1));",
        'RCLCPP_INFO_STREAM(get_logger(), "in: " << to_yaml(message, true));',
    ),
    "one callback for two types": (
        "subscribe n to 'a' of message_type String calling hear\n"
        "subscribe n to 'b' of message_type Int32 calling hear",
        '"b", 10, [this](const std_msgs::msg::Int32 & message) {hear(message);});',
    ),
    "service": (
        "n provides_service 'ask' of service_type Trigger",
        'ask_service_ = create_service<std_srvs::srv::Trigger>("ask", std::bind('
        "&RobotNode::handle_ask, this, std::placeholders::_1, std::placeholders::_2));",
        "handle_ask(const std_srvs::srv::Trigger::Request::SharedPtr request, "
        "std_srvs::srv::Trigger::Response::SharedPtr response)",
        "(void)response;",
    ),
    "answer": (
        "n provides_service 'sum' of service_type AddTwoInts answering sum=request.a * 2".replace(
            "request.a", "received.a"
        ),
        "try { response->sum = in_range<int64_t>(",
        "*response = example_interfaces::srv::AddTwoInts::Response(); }",
    ),
    "calls beside other work": (
        f"{HEARD}n client_requests 'on' of service_type SetBool with input True",
        'on_client_ = create_client<std_srvs::srv::SetBool>("on");',
        "on_calls_ = start([this]() {call_on();});",
        'if (wait_until_served("on", [this]() {return on_client_->service_is_ready();})) { '
        "auto request = std::make_shared<std_srvs::srv::SetBool::Request>(); "
        'request->data = true; call("on", on_client_, request); }',
        "is_ending_ = true;",
    ),
    "calls at a rate": (
        "n client_requests 'on' of service_type SetBool with input True at 5 hz",
        "std::chrono::milliseconds(200), std::bind(&RobotNode::repeat_on, this));",
        "if (is_done(on_calls_)) { on_calls_ = start([this]() {call_on();}); }",
    ),
    "timer": (
        "n repeats look at 4 hz",
        "std::chrono::milliseconds(250), std::bind(&RobotNode::look, this));",
        'RCLCPP_INFO_THROTTLE(get_logger(), *get_clock(), 1000, "look");',
    ),
    "parameter": (
        f"{OFTEN}{HELLO}n publish m to 'out' of message_type String at parameter 'often' hz",
        "descriptor.floating_point_range[0].from_value = 1.0;",
        'declare_parameter<double>("often", 5.0, descriptor);',
        'std::chrono::duration<double>(1.0 / get_parameter("often").as_double())',
        "is_nan && !describe_parameter(parameter.get_name()).floating_point_range.empty()) {",
        'if (parameter.get_name() == "often" && out_timer_) { out_timer_ = rclcpp::create_timer('
        "this, get_clock(), std::chrono::duration<double>(1.0 / parameter.as_double()), ",
    ),
    "described": (
        "n has_parameter 'count' of parameter_type int with default 3 described_as \"how many\"",
        'descriptor.description = "how many"; declare_parameter<int64_t>("count", 3, descriptor);',
    ),
    "list": (
        "n has_parameter 'ports' of parameter_type int_list with default [80, 443]",
        'declare_parameter("ports", std::vector<int64_t>{80, 443});',
    ),
    "action": (
        "n provides_action 'count' of action_type Fibonacci calling work_on",
        f"using CountGoalHandle = rclcpp_action::ServerGoalHandle<{FIBONACCI}>;",
        f'count_server_ = rclcpp_action::create_server<{FIBONACCI}>(this, "count", ',
        "[this](const auto & goal_handle) {accept_count_goal(goal_handle);});",
        "work_on(const std::shared_ptr<CountGoalHandle> goal_handle)",
        "count_server_.reset(); end_goals(); if (count_goal_thread_.joinable()) {",
    ),
    "goal": (
        f"{HEARD}n sends_goal to 'count' of action_type Fibonacci with input order=5",
        f'count_client_ = rclcpp_action::create_client<{FIBONACCI}>(this, "count");',
        f'{FIBONACCI}::Goal goal; goal.order = 5; send_goal("count", count_client_, goal);',
    ),
}


@pytest.mark.parametrize("case", WRITTEN)
def test_what_is_written_in_a_node(case: str) -> None:
    statements, *parts = WRITTEN[case]
    [source] = files(statements, "rclcpp").values()
    for part in parts:
        assert part in source
    assert "namespace" not in source
    assert "RobotNode() : Node(" in source
    assert source.endswith(f"{{ rclcpp::init(argc, argv); try {{ {SPIN} }} {QUIET} return 0; }}")


@pytest.mark.parametrize("case", WRITTEN)
def test_what_is_written_in_a_component(case: str) -> None:
    statements, *parts = WRITTEN[case]
    made = files(statements, "component")
    assert list(made) == ["{}.cpp", "../include/robot/{}.hpp"]
    source, header = made.values()
    for part in parts:
        assert part in source or part in header
    assert '#include "robot/robot_' in source
    assert "#ifndef ROBOT__ROBOT_" in header
    assert "explicit RobotNode(const rclcpp::NodeOptions & options = rclcpp::NodeOptions());" in (
        header
    )
    assert source.endswith("RCLCPP_COMPONENTS_REGISTER_NODE(robot::RobotNode)")
    # What ends a component is its process, or who unloads it.
    assert not any(word in source for word in ("main(", "rclcpp::shutdown", "exit_status"))


CALLS = "n client_requests 'on' of service_type SetBool with input True\n"


def test_a_node_ends_after_its_calls_and_a_component_stays() -> None:
    [source] = files(CALLS, "rclcpp").values()
    assert 'if (is_served("on", [this]() {return on_client_->service_is_ready();})) {' in source
    assert "if (goes_on() && has_failed_) { exit_status_ = 1; } rclcpp::shutdown(); }" in source
    assert "rclcpp::spin(node); status = node->exit_status(); }" in source
    assert source.endswith(f"{QUIET} return status; }}")
    assert "exit_status" not in files(CALLS, "component")["{}.cpp"]


MANAGED = (
    f"{HEARD}{OFTEN}{HELLO}{CALLS}"
    "n publish m to 'out' of message_type String at parameter 'often' hz\n"
    "n provides_action 'count' of action_type Fibonacci\n"
    "n sends_goal to 'other' of action_type Fibonacci with input order=5\n"
)


@pytest.mark.parametrize("library", LIBRARIES)
def test_what_the_transitions_of_a_managed_node_do(library: str) -> None:
    made = files(MANAGED, library, "managed")
    source = made["{}.cpp"]
    text = "".join(made.values())
    assert "class RobotNode : public rclcpp_lifecycle::LifecycleNode" in text
    assert "rclcpp_lifecycle::LifecyclePublisher<std_msgs::msg::String>::SharedPtr out" in text
    state = r"\(const rclcpp_lifecycle::State &(?: state)?\)"
    methods = dict(re.findall(rf"\b(on_\w+){state}(?: override)? \{{(.*?) return ", source))
    assert "out_publisher_ = create_publisher" in methods["on_configure"]
    assert "is_active_ = true; out_timer_ = rclcpp::create_timer(" in methods["on_activate"]
    for transition in ("on_deactivate", "on_shutdown", "on_error"):
        assert "destroy_timers(); end_tasks();" in methods[transition]
    for transition in ("on_cleanup", "on_shutdown", "on_error"):
        assert "destroy_endpoints();" in methods[transition]
    assert "is_active_ ? GoalResponse::ACCEPT_AND_EXECUTE : GoalResponse::REJECT" in source
    assert "sender->async_cancel_goal(goal_handle);" in source
    assert 'if (parameter.get_name() == "often" && out_timer_) {' in source


def test_a_managed_node_that_has_nothing() -> None:
    [source] = files("", "rclcpp", "managed").values()
    assert 'RobotNode() : LifecycleNode("robot") { } private: }' in source
    assert "rclcpp::spin(node->get_node_base_interface());" in source


@pytest.mark.parametrize(
    ("layout", "library", "names"),
    [
        ("split", "rclcpp", ["{}.cpp", "../include/robot/{}.hpp"]),
        ("single", "component", ["{}.cpp"]),
    ],
)
def test_a_project_says_how_many_files_a_node_has(
    layout: str, library: str, names: list[str], tmp_path: Path
) -> None:
    (tmp_path / "plastron.yaml").write_text(f"cpp: {layout}\n")
    program = f"create_node 'robot' as n\n{HEARD}generate_node n using {library}\n"
    session = Session(program.encode(), tmp_path / "robot_program.plastron", environ={})
    [made] = session.generated()
    assert made.files is not None
    found = [name for name, _ in made.files.files.texts]
    assert [re.sub("include/.*/", "include/robot/", name) for name in found] == names


@pytest.mark.parametrize(
    ("package", "namespace"), [("robot_nodes", "robot_nodes"), ("std", "std_nodes")]
)
def test_the_namespace_of_a_component(package: str, namespace: str) -> None:
    target = find_target("component")
    assert target is not None
    [node] = Session(b"create_node 'robot' as n").workspace.nodes.values()
    node.home = Home(package, "robot")
    made = target.render(node, Catalog("kilted")).files
    assert made is not None
    source, header = (text.decode() for _, text in made.texts)
    assert f"namespace {namespace}\n" in source
    assert f"#ifndef {package.upper()}__ROBOT_" in header
    assert f'#include "{package}/robot_' in source
    assert target.plugin_class(node) == f"{namespace}::RobotNode"


def test_a_class_that_is_called_as_its_base() -> None:
    [made] = rendered("create_node 'node' as n", "rclcpp")
    assert made.files is not None
    assert "class Node : public rclcpp::Node" in made.files.main.decode()
    assert ': rclcpp::Node("node")' in made.files.main.decode()


REFUSED = {
    "a keyword": ("n repeats delete at 4 hz", "cannot be a name in C++"),
    "a macro": ("n repeats errno at 4 hz", "cannot be a name in C++"),
    "the compiler's own": ("n repeats _Look at 4 hz", "cannot be a name in C++"),
    "the class": ("n repeats RobotNode at 4 hz", "is a name that every"),
    "a method": ("n repeats get_parameter at 4 hz", "is a name that every"),
    "what is found by its argument": ("n repeats to_yaml at 4 hz", "is a name that every"),
    "an attribute": ("n repeats parameters_callback_ at 4 hz", "is a name that every"),
    "a task": (f"{CALLS}subscribe n to 'a' of message_type String calling fail", "with calls or"),
}


@pytest.mark.parametrize("library", LIBRARIES)
@pytest.mark.parametrize("case", REFUSED)
def test_what_is_refused(library: str, case: str) -> None:
    statements, message = REFUSED[case]
    [made] = rendered(f"create_node 'robot' as n\n{statements}", library)
    [diagnostic] = made.diagnostics
    assert diagnostic.code is codes.INVALID_FUNCTION
    assert message in diagnostic.message


def test_a_managed_node_has_what_its_base_has() -> None:
    for managed, is_written in (("", True), ("managed", False)):
        statements = f"create_node 'robot' as n {managed}\nn repeats activate at 4 hz"
        [made] = rendered(statements, "rclcpp")
        assert (made.files is not None) == is_written


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
@settings(max_examples=examples(12), deadline=None)
@given(program=random_programs("rclpy"))
def test_every_random_program_is_written(library: str, program: str) -> None:
    lines = lines_of(program, library)
    assert [line for line in lines if len(line) > 100] == []
