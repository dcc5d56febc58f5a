"""What `plastron describe` says of actions and parameters of nodes that it did not start."""

from __future__ import annotations

from pathlib import Path

import pytest
from graph import Graph
from machine import find_ros, wait_until
from processes import generate

from plastron_tui.runtime.describe import describe
from plastron_tui.runtime.program import to_program

pytestmark = pytest.mark.live

PROGRAM = """\
create_node 'calculator' as calculator
calculator provides_action 'count' of action_type {type}
generate_node calculator
create_node 'driver' as driver
subscribe driver to 'chatter' of message_type String
driver sends_goal to 'count' of action_type {type} with input {values}
generate_node driver
create_node 'cruiser' as cruiser
cruiser has_parameter 'speed' of parameter_type float with default 0.5
cruiser repeats look at 1 hz
generate_node cruiser
"""
VALUES = {"rospy": "goal=5", "rclpy": "order=5"}
ACTION = {"rospy": "actionlib/Test", "rclpy": "example_interfaces/Fibonacci"}
SPEED = "cruiser has_parameter 'speed' of parameter_type float with default 0.5"


def test_actions_and_parameters_are_described(service_graph: Graph, tmp_path: Path) -> None:
    target = service_graph.target
    type_ = ACTION[target]
    values = VALUES[target]
    program_file = tmp_path / "several.plastron"
    program_file.write_text(PROGRAM.format(type=type_, values=values))
    for file in generate(str(program_file.with_suffix("")), tmp_path / "output", target).values():
        service_graph.run(file)
    environment = find_ros(1 if target == "rospy" else 2, service_graph.python)
    wanted = [
        f"calculator provides_action '/count' of action_type {type_}",
        f"driver sends_goal to '/count' of action_type {type_} with input none",
        SPEED,
    ]
    program = ""

    def is_described() -> bool:
        nonlocal program
        found = describe(environment, environ=service_graph.env).nodes
        program = to_program(found or (), target, environment.ros_version)
        return all(any(line.startswith(each) for line in program.splitlines()) for each in wanted)

    try:
        wait_until(is_described, "the graph is described", 60)
    except BaseException:
        print(program)
        raise
    for part in ("/_action", "/count/", "GoalID", "use_sim_time", "list_parameters"):
        assert part not in program
