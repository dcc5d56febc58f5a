"""Files that Plastron wrote and nobody touched: each thing that they do is taken out whole."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path

import pytest

from plastron_tui.session import Options, Session

PROGRAM = """\
create_node 'n' as n
n has_parameter 'rate' of parameter_type float with default 2 between 1 and 20
subscribe n to 'scan' of message_type sensor_msgs/LaserScan
create_message m of message_type String and input "x"
n publish m to 'paced' of message_type String at parameter 'rate' hz
n publish m to 'fixed' of message_type String at 2 hz
n publish m to 'kept' of message_type String once
n publish m to 'halt' of message_type String for_each 'scan' when any received.ranges < 1
n client_requests 'rdy' of service_type Trigger with input none at 1 hz
n client_requests 'erl' of service_type Trigger with input none
n sends_goal to 'fibo' of action_type Fibonacci with input 3
n provides_action 'dock' of action_type Fibonacci
n provides_action 'trn' of action_type Fibonacci
n provides_service 'query' of service_type Trigger
n repeats tick at 5 hz
generate_node n
"""
# What takes it out, and what is told of what it leaves.
ENDS: dict[str, set[str]] = {
    "stop_publishing to 'fixed'": set(),
    "stop_publishing to 'kept'": set(),
    "stop_publishing to 'halt'": {"idle-code"},
    "stop_request 'rdy'": set(),
    "stop_request 'erl'": set(),
    "stop_goal to 'fibo'": {"uncalled-function"},
    "stop_action 'dock'": set(),
    "stop_action 'trn'": set(),
    "stop_action 'dock'\nn stop_action 'trn'": set(),
    "stop_service 'query'": set(),
    "stop_repeating tick": set(),
}


@cache
def written(library: str) -> str:
    plan, diagnostics = Session(PROGRAM.encode(), None, Options(library), environ={}).plan()
    assert not diagnostics
    return plan.files[0].text.decode()


def test_an_older_version_s_way_to_end_goals_goes_too(tmp_path: Path) -> None:
    older, waits = re.subn(r" +# rospy sends in .*\n.*wallsleep.*\n", "", written("rospy"))
    assert waits == 1
    (tmp_path / "own.py").write_text(older)
    program = "load own as n\nn stop_action 'dock'\nn stop_action 'trn'\ngenerate_node n\n"
    session = Session(program.encode(), tmp_path / "p.plastron", Options("rospy"), environ={})
    plan, diagnostics = session.plan()
    assert (diagnostics, b"end_goals" in plan.files[0].text) == ((), False)


def test_a_function_with_somebody_s_comment_is_nobody_else_s(tmp_path: Path) -> None:
    commented = written("rospy").replace("# rospy sends in", "# mine: rospy sends in")
    (tmp_path / "own.py").write_text(commented)
    program = "load own as n\nn stop_action 'dock'\nn stop_action 'trn'\ngenerate_node n\n"
    session = Session(program.encode(), tmp_path / "p.plastron", Options("rospy"), environ={})
    plan, diagnostics = session.plan()
    assert ([each.code for each in diagnostics], plan.files) == (["endpoint-in-use"], ())


@pytest.mark.parametrize("library", ["rospy", "rclpy"])
@pytest.mark.parametrize("ends", ENDS)
def test_what_goes_leaves_no_trace(tmp_path: Path, ends: str, library: str) -> None:
    (tmp_path / "own.py").write_text(written(library))
    program = f"load own as n\nn {ends}\ngenerate_node n\n"
    session = Session(program.encode(), tmp_path / "p.plastron", Options(library), environ={})
    plan, diagnostics = session.plan()
    assert {each.code for each in diagnostics} == ENDS[ends]
    text = plan.files[0].text.decode()
    compile(text, "own.py", "exec")
    names = re.findall(r"'(\w+)'|repeating (\w+)", ends)
    for name in filter(None, (word for pair in names for word in pair)):
        assert re.search(rf"(\b|_){name}(\b|_)", written(library))
        assert not re.search(rf"(\b|_){name}(\b|_)", text)
