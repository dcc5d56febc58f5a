"""Parameters of a node that runs: each new value is used or refused, whoever sets it."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from graph import Graph, Received, is_rate, rate
from machine import wait_until
from processes import generate_one, own_tracebacks

pytestmark = pytest.mark.live

TYPES = {
    "/cmd_vel": "geometry_msgs/TwistStamped",
    "/gear": "std_msgs/Int32",
    "/power": "std_msgs/Bool",
    "/gains": "std_msgs/Float32MultiArray",
    "/ports": "std_msgs/Int32MultiArray",
    "/level": "std_msgs/UInt8",
}

# What is taken, and what is not: by parameter.
GOOD: dict[str, Any] = {
    "speed": 0.875, "gear": -1, "is_on": False, "frame": "odom", "gains": [2.5],
    "ports": [1, 2, 3], "level": 26,
}  # fmt: skip
BAD: dict[str, list[Any]] = {
    "speed": [1.5, -0.25, float("nan"), "fast", True, [0.5]],
    "gear": [6, -2, 1.5, "R"],
    "rate": [0.0, -1.0, "often"],
    "is_on": [1, "yes"],
    "frame": [3, ["map"]],
    "gains": [["a"], 2.5],
    "ports": [[1.5], "80"],
    # What goes into a `uint8`, ten times and less five.
    "level": [0, 27, -(2**31)],
}


def values(received: dict[str, list[Received]]) -> dict[str, Any]:
    """Return what each parameter was, by the last messages."""
    last = {topic: each[-1].message for topic, each in received.items()}
    return {
        "speed": last["/cmd_vel"]["twist"]["linear"]["x"],
        "frame": last["/cmd_vel"]["header"]["frame_id"],
        "gear": last["/gear"]["data"],
        "is_on": last["/power"]["data"],
        "gains": last["/gains"]["data"],
        "ports": last["/ports"]["data"],
        "level": (last["/level"]["data"] + 5) // 10,
    }


@pytest.mark.long
def test_a_parameter_is_used_by_the_next_message(graph: Graph, tmp_path: Path) -> None:
    node = graph.run_and_wait(generate_one("cruiser", tmp_path, graph.target))
    default = values(graph.listen(TYPES, 0.1))
    assert default == {
        "speed": 0.5, "gear": 1, "is_on": True, "frame": "map", "gains": [1.0, 0.5],
        "ports": [80, 443], "level": 3,
    }  # fmt: skip
    for name, value in GOOD.items():
        assert graph.set_parameter("cruiser", name, value) is None
    # ROS 1's master tells the node of it some time later.
    wait_until(lambda: values(graph.listen(TYPES, 0.1)) == GOOD, "the new values", 60)
    for name, bad in BAD.items():
        for value in bad:
            reason = graph.set_parameter("cruiser", name, value)
            assert graph.target == "rospy" or reason, (name, value)
    if graph.target == "rospy":
        # Nobody is told of it but who reads the log.
        node.wait_to_print("gear: 'R' is not an integer from -1 to 5")
    assert values(graph.listen(TYPES, 0.5)) == GOOD
    assert node.interrupt() == 0
    assert not own_tracebacks(node.output)


@pytest.mark.long
def test_what_no_field_can_hold_is_not_sent(graph: Graph, tmp_path: Path) -> None:
    node = graph.run_and_wait(generate_one("cruiser", tmp_path, graph.target))
    # The master of ROS 1 has integers of 32 bits.
    large: list[Any] = [2**31] if graph.target == "rclpy" else [2**31 - 1, "no number"]
    assert graph.set_parameter("cruiser", "ports", large) is None
    node.wait_to_print("ports, of " if graph.target == "rclpy" else "ports: ")
    assert graph.set_parameter("cruiser", "ports", [7]) is None
    wait_until(lambda: values(graph.listen(TYPES, 0.1))["ports"] == [7], "the new value", 60)
    assert graph.set_parameter("cruiser", "gains", [1e39]) is None
    wait_until(
        lambda: values(graph.listen(TYPES, 0.1))["gains"] == [float("inf")], "the new value", 60
    )
    assert node.interrupt() == 0
    assert not own_tracebacks(node.output)


@pytest.mark.long
def test_a_timer_follows_the_parameter_that_is_its_rate(graph: Graph, tmp_path: Path) -> None:
    node = graph.run_and_wait(generate_one("cruiser", tmp_path, graph.target))
    topics = {"/cmd_vel": TYPES["/cmd_vel"]}
    assert is_rate(rate(graph.listen(topics, 2)["/cmd_vel"]), 10)
    for hertz in (0.001, 50.0):
        # What takes a quarter of an hour does not keep what comes after it waiting.
        assert graph.set_parameter("cruiser", "rate", hertz) is None
    wait_until(lambda: is_rate(rate(graph.listen(topics, 2)["/cmd_vel"]), 50), "the new rate", 60)
    assert node.interrupt() == 0
    assert not own_tracebacks(node.output)


@pytest.mark.long
def test_a_function_is_repeated(graph: Graph, tmp_path: Path) -> None:
    node = graph.run_and_wait(generate_one("cruiser", tmp_path, graph.target))
    node.wait_to_print("look_around", count=2)
    assert node.interrupt() == 0
    assert not own_tracebacks(node.output)
