"""`plastron run` brings managed nodes up: they do nothing before they are active."""

from __future__ import annotations

from pathlib import Path

import pytest
from ros_runs import Ros, make_ros, said_by

PROGRAM = """\
create_node 'lamp' as lamp managed
lamp repeats glow at 4 hz
generate_node lamp
create_node 'plain' as plain
plain repeats beat at 4 hz
generate_node plain
"""
# Written by hand: it cannot be activated.
BROKEN = """\
#!/usr/bin/env python3
import rclpy
from rclpy.lifecycle import LifecycleNode
from std_msgs.msg import String


class Broken(LifecycleNode):
    def __init__(self):
        super().__init__("broken")

    def on_activate(self, state):
        raise ValueError


def main():
    rclpy.init()
    node = Broken()
    node.create_publisher(String, "chatter", 10)
    rclpy.spin(node)


if __name__ == "__main__":
    main()
"""


@pytest.fixture
def ros(tmp_path: Path) -> Ros:
    return make_ros("rclpy", tmp_path)


@pytest.mark.live
def test_a_managed_node_is_brought_up_and_that_is_said(ros: Ros) -> None:
    ros.write("p.plastron", PROGRAM)
    said = ros.run_until(lambda said: "]: glow" in said, "p.plastron", "--namespace", "/robot1")
    told = [line for line in said_by(said, "plastron") if "lifecycle" in line]
    assert told == ["configured and activated robot1/lamp by its lifecycle services"]
    assert ros.processes() == []


@pytest.mark.long
@pytest.mark.live
def test_why_a_managed_node_is_not_active_is_said(ros: Ros) -> None:
    ros.write("broken.py", BROKEN)
    load = "load 'broken.py' as broken\ngenerate_node broken\n"
    ros.write("p.plastron", PROGRAM + load)
    said = ros.run_until(
        lambda said: "not active" in said and "]: glow" in said, "p.plastron", status=1
    )
    assert "broken is not active: it did not activate" in said_by(said, "plastron")
    assert "configured and activated lamp by its lifecycle services" in said_by(said, "plastron")
    assert ros.processes() == []
