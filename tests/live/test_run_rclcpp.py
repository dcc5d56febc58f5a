"""`plastron run` of a node for rclcpp, or for what stands in for it: built with colcon, started."""

from __future__ import annotations

import signal
import sys
from pathlib import Path

import pytest
from cpp_builds import find_rclcpp
from graph import Graph
from processes import Process

pytestmark = [pytest.mark.live, pytest.mark.long(0.5)]

PROGRAM = """\
create_node 'talker' as talker using rclcpp
create_message greeting of message_type String and input "hello"
talker publish greeting to 'chatter' of message_type String at 10 hz
generate_node talker
create_node 'echo' as echo using rclpy
subscribe echo to 'chatter' of message_type String
generate_node echo
"""


def test_a_program_is_built_and_started(
    ros2: Graph, tmp_path: Path, tmp_path_factory: pytest.TempPathFactory
) -> None:
    rclcpp = find_rclcpp(tmp_path_factory)
    program = tmp_path / "robot.plastron"
    program.write_text(PROGRAM, encoding="utf-8")
    environ = rclcpp.building({**ros2.env, "XDG_CACHE_HOME": str(tmp_path / "cache")})
    if not rclcpp.is_real:
        # The Python packages are no ROS that is sourced.
        environ.pop("AMENT_PREFIX_PATH")
    command = [sys.executable, "-m", "plastron_tui", "run", program, "-o", tmp_path / "robot"]
    run = Process(command, environ, tmp_path / "run.log")
    ros2.started.append(run)
    # What the node in Python hears of the one in C++.
    run.wait_to_print("(data='hello')", 240)
    heard = ros2.listen({"chatter": "std_msgs/String"}, 0.5)
    assert {each.message["data"] for each in heard["chatter"]} == {"hello"}
    assert run.interrupt() == 128 + signal.SIGINT, run.output
