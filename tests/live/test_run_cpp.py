"""`plastron run` of nodes in C++: built with catkin, started, loaded into a manager."""

from __future__ import annotations

import signal
import sys
from pathlib import Path

import pytest
from graph import Graph
from processes import Process
from ros_workspaces import SYSTEM, skip_without

pytestmark = [pytest.mark.live, pytest.mark.long(0.5)]

PROGRAM = """\
create_node 'talker' as talker using roscpp
create_message greeting of message_type String and input "hello"
talker publish greeting to 'chatter' of message_type String at 10 hz
generate_node talker
create_node 'speaker' as speaker using nodelet
create_message words of message_type String and input "words"
speaker publish words to 'words' of message_type String at 10 hz
generate_node speaker
create_node 'ears' as ears using nodelet
subscribe ears to 'chatter' of message_type String
generate_node ears
create_node 'echo' as echo using rospy
subscribe echo to 'words' of message_type String
generate_node echo
"""


def test_a_program_is_built_started_and_loaded(ros1: Graph, tmp_path: Path) -> None:
    skip_without("catkin_make", path=SYSTEM)
    program = tmp_path / "robot.plastron"
    program.write_text(PROGRAM, encoding="utf-8")
    environ = {**ros1.env, "XDG_CACHE_HOME": str(tmp_path / "cache"), "PATH": SYSTEM}
    command = [sys.executable, "-m", "plastron_tui", "run", program, "-o", tmp_path / "robot"]
    run = Process(command, environ, tmp_path / "run.log")
    ros1.started.append(run)
    run.wait_to_print("Loading nodelet /ears of type robot/EarsNode", 240)
    heard = ros1.listen({"chatter": "std_msgs/String", "words": "std_msgs/String"}, 0.5)
    assert {each.message["data"] for each in heard["chatter"]} == {"hello"}
    assert {each.message["data"] for each in heard["words"]} == {"words"}
    run.wait_to_print("robot_manager | ")
    # What nodelets have is that of the node whose process they are in.
    manager = ros1.endpoints("robot_manager")
    assert "/words" in manager["publishers"]
    assert "/chatter" in manager["subscriptions"]
    assert "/words" in ros1.endpoints("echo")["subscriptions"]
    assert run.interrupt() == 128 + signal.SIGINT, run.output
    lines = run.output.splitlines()
    said = " ".join(lines)
    assert "chatter: data: hello" in said
    # Neither what a message's text ends in, nor an end that somebody has to be told of.
    assert "robot_manager | " not in lines
    assert "abort" not in said and "SIG" not in said
