"""Robots of packages that are run: who listens is told where their parts are."""

from __future__ import annotations

import signal
import subprocess
import sys
from pathlib import Path

import pytest
from machine import find_ros, graph_environ, skip_or_fail, wait_until

from plastron_tui.runtime.environment import missing_packages

pytestmark = [pytest.mark.live, pytest.mark.long]

STATE_PUBLISHER = Path("/usr/lib/robot_state_publisher/robot_state_publisher")
PROGRAM = """\
create_robot 'rover' as rover
rover has_link 'base'
rover has_link 'wheel' shaped cylinder 0.1, 0.05 weighing 0.5 turned 90, 0, 0 deg
rover has_link 'mast' shaped box 0.05, 0.05, 0.5 weighing 0.5 at 0, 0, 0.25
rover has_joint 'wheel_joint' of joint_type continuous from 'base' to 'wheel' at 0, 0.2, 0 \
with axis 0, 1, 0
rover has_joint 'mast_joint' of joint_type fixed from 'base' to 'mast' at 0, 0, 0.125
create_node 'driver' as driver
driver has_parameter 'joint_names' of parameter_type string_list with default ["none"]
create_message turning of message_type JointState and input name=parameter 'joint_names', \
position=[0.0]
driver publish turning to 'joint_states' of message_type JointState at 10 hz
subscribe driver to '/tf' of message_type tf2_msgs/TFMessage
subscribe driver to '/tf_static' of message_type tf2_msgs/TFMessage
create_package 'rover_demo' as demo maintained_by "Ada <ada@example.com>" licensed_under "MIT"
demo contains driver
demo contains rover
generate_package demo
"""


def test_ros_1_is_told_where_the_parts_of_a_robot_are(tmp_path: Path) -> None:
    environment = find_ros(1)
    if missing_packages(environment, ["roslaunch"]) or not STATE_PUBLISHER.exists():
        skip_or_fail("roslaunch or robot_state_publisher is not installed")
    file = tmp_path / "rover.plastron"
    file.write_text(PROGRAM)
    log = tmp_path / "said.log"
    words = ["run", str(file), "rover", "--target", "rospy", "--for", "60"]

    def is_told() -> bool:
        # The wheel comes by /tf, and only by the name that the launch file gives the driver.
        said = log.read_text()
        return all(f'child_frame_id: "{each}"' in said for each in ("wheel", "mast"))

    with log.open("w") as out:
        run = subprocess.Popen(
            [sys.executable, "-m", "plastron_tui", *words],
            env=graph_environ(tmp_path),
            stdout=out,
            stderr=out,
        )
        try:
            wait_until(lambda: run.poll() is not None or is_told(), "the frames are there")
            assert is_told(), log.read_text()
            assert "0.125" in log.read_text()
        finally:
            run.send_signal(signal.SIGINT)
            status = run.wait(60)
    assert status == 128 + signal.SIGINT, log.read_text()
