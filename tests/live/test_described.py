"""What `plastron describe` says of actions and parameters of nodes that it did not start."""

from __future__ import annotations

from pathlib import Path

import pytest
from graph import Graph
from machine import find_ros, wait_until
from prototypes import prototype

from plastron_tui.runtime.describe import describe
from plastron_tui.runtime.program import to_program

pytestmark = pytest.mark.live

NODES = Path(__file__).parents[1] / "nodes"
ACTION = {"rospy": "actionlib/Test", "rclpy": "example_interfaces/Fibonacci"}
SPEED = "cruiser has_parameter 'speed' of parameter_type float with default 0.5"


def test_actions_and_parameters_are_described(service_graph: Graph) -> None:
    target = service_graph.target
    for name in ("action_server", "action_client_busy"):
        service_graph.run(NODES / target / f"{name}.py")
    service_graph.run(prototype(service_graph, "cruiser"))
    environment = find_ros(1 if target == "rospy" else 2, service_graph.python)
    type_ = ACTION[target]
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
