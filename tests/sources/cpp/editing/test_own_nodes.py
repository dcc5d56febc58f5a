"""What Plastron writes for an endpoint goes with it, out of nodes that it wrote itself."""

from __future__ import annotations

from pathlib import Path

import pytest

from plastron_tui.diagnostics import Severity
from plastron_tui.output.writer import write
from plastron_tui.session import Options, Session

NODE = """\
create_node 'robot' as n using {library}
create_message hello of message_type String and input "hello"
create_message five of message_type Int32 and input 5
subscribe n to 'heard' of message_type String
n publish hello to 'steady' of message_type String at 5 hz
n publish five to 'fast' of message_type Int32 at 20 hz
n publish hello to 'echo' of message_type String for_each 'heard'
n provides_service 'reset' of service_type Empty
n client_requests 'go' of service_type SetBool with input True at 1 hz
n provides_action 'dock' of action_type Fibonacci
n sends_goal to 'fetch' of action_type Fibonacci with input 5
n has_parameter 'speed' of parameter_type float with default 0.5 between 0 and 2
n has_parameter 'frame' of parameter_type string with default "map"
n repeats blink at 2 hz
generate_node n
"""
ENDS = [
    "n stop_publishing to 'echo'",
    "unsubscribe n from 'heard'",
    "n stop_publishing to 'steady'",
    "n stop_publishing to 'fast'",
    "n stop_service 'reset'",
    "n stop_request 'go'",
    "n stop_action 'dock'",
    "n stop_goal to 'fetch'",
    "n no_longer_has_parameter 'speed'",
    "n no_longer_has_parameter 'frame'",
    "n stop_repeating blink",
]
WORDS = (
    *("heard", "steady_", "fast_", "echo_", "reset_", "go_", "dock", "fetch", "speed", "blink"),
    *('"frame', "String", "Int32", "Empty", "SetBool", "Fibonacci", "send_goal", "ask("),
    *("wait_until_served", "wait_for_action", "is_served", "is_answered", "is_current"),
    *("is_done", "goes_on", "fail(", "start(", "end_goals"),
)


def _generate(folder: Path, program: str, *, in_place: bool = False) -> None:
    options = Options(None, folder / "output", in_place=in_place)
    session = Session(program.encode(), folder / "a.plastron", options, environ={})
    plan, told = session.plan()
    found = [*session.diagnostics, *told]
    assert [each.message for each in found if each.severity is Severity.ERROR] == []
    assert write(plan).diagnostics == ()


@pytest.mark.long
@pytest.mark.parametrize("library", ["roscpp", "nodelet", "rclcpp", "component"])
def test_every_statement_is_taken_back(tmp_path: Path, library: str) -> None:
    _generate(tmp_path, NODE.format(library=library))
    (source,) = tmp_path.rglob("*.cpp")
    load = f"load '{source.relative_to(tmp_path)}' as n\n"
    _generate(tmp_path, f"{load}{chr(10).join(ENDS)}\ngenerate_node n\n", in_place=True)
    texts = [each.read_text() for each in tmp_path.rglob("*.[ch]pp")]
    left = {word for word in WORDS for text in texts if word in text}
    assert left == set()


@pytest.mark.long
def test_the_helpers_of_a_managed_node_are_taken_back(tmp_path: Path) -> None:
    program = NODE.format(library="rclcpp").replace(" using ", " managed using ")
    _generate(tmp_path, program)
    (source,) = tmp_path.rglob("*.cpp")
    helpers = ("accept_goal(", "fail(", "goes_on(", "is_answered(", "send_goal(")
    assert [each for each in helpers if each not in source.read_text()] == []
    load = f"load '{source.relative_to(tmp_path)}' as n\n"
    _generate(tmp_path, f"{load}{chr(10).join(ENDS)}\ngenerate_node n\n", in_place=True)
    assert [each for each in helpers if each in source.read_text()] == []


HAND_WRITTEN = {
    "roscpp": """\
#include <ros/ros.h>
#include <std_srvs/Empty.h>
class A
{
public:
  A() {client_ = nh_.serviceClient<std_srvs::Empty>("go");}

private:
  ros::NodeHandle nh_;
  ros::ServiceClient client_;
};
""",
    "rclcpp": """\
#include <rclcpp/rclcpp.hpp>
#include <std_srvs/srv/empty.hpp>
class A : public rclcpp::Node
{
public:
  A() : Node("a") {client_ = create_client<std_srvs::srv::Empty>("go");}

private:
  rclcpp::Client<std_srvs::srv::Empty>::SharedPtr client_;
};
""",
}
MORE = """\
load 'a.cpp' as n
create_message five of message_type Int32 and input 5
n publish five to 'echo' of message_type Int32 for_each 'heard'
n client_requests 'go' of service_type Empty with input none
generate_node n
"""


@pytest.mark.parametrize("library", HAND_WRITTEN)
def test_what_is_new_may_need_what_is_new(tmp_path: Path, library: str) -> None:
    """A publisher answers to a subscription of the same program, an old client gets a request."""
    source = tmp_path / "a.cpp"
    source.write_text(HAND_WRITTEN[library])
    subscribe = "subscribe n to 'heard' of message_type Int32\n"
    head, publish, *rest = MORE.partition("n publish")
    _generate(tmp_path, "".join([head, subscribe, publish, *rest]), in_place=True)
    text = source.read_text()
    assert text.index("echo_message.data = 5;") > text.index("heard: ")
    assert "call_go(" in text.replace("callGo", "call_go")
