from __future__ import annotations

from pathlib import Path

import pytest
from machine import TALKING, wait_until
from ros_runs import Ros, make_ros, said_by


@pytest.fixture(params=["rospy", "rclpy"])
def ros(request: pytest.FixtureRequest, tmp_path: Path) -> Ros:
    return make_ros(request.param, tmp_path)


def described(ros: Ros, file: str) -> str:
    """Return the graph of a program that runs as a program, once all of it is there."""
    wait_until(lambda: has_begun(ros, file), "the nodes talk", 120)
    found = ""
    parts = ("talker", "listener", "switcher", "asker", "provides_service", "generate_node asker")

    def is_whole() -> bool:
        nonlocal found
        done = ros.plastron("describe", "--ros", ros.version)
        found = done.stdout
        return all(part in found for part in parts) and found.count("subscribe ") == 2

    wait_until(is_whole, "the graph is there", 60)
    return found


def has_begun(ros: Ros, file: str) -> bool:
    said = ros.said(file)
    return all(said_by(said, node) for node in ("listener", "asker"))


@pytest.mark.live
@pytest.mark.long
def test_a_description_generated_and_run_shows_the_same_graph(ros: Ros) -> None:
    ros.write("first.plastron", TALKING)
    with ros.running("first.plastron"):
        before = described(ros, "first.plastron")
    ros.write("second.plastron", before)
    checked = ros.plastron("check", "second.plastron")
    assert checked.returncode == 0, checked.stderr
    with ros.running("second.plastron", "-o", "second"):
        assert described(ros, "second.plastron") == before


@pytest.mark.live
def test_a_graph_that_is_not_there(tmp_path: Path) -> None:
    done = make_ros("rospy", tmp_path).plastron("describe", "--ros", "1")
    assert done.returncode == 1
    assert done.stdout == ""
    assert "error[no-graph]: no ROS 1 master answers at" in done.stderr
    assert "plastron run FILE" in done.stderr


@pytest.mark.live
@pytest.mark.long
def test_a_graph_without_nodes(tmp_path: Path) -> None:
    done = make_ros("rclpy", tmp_path).plastron("describe", "--ros", "2")
    assert done.returncode == 0, done.stderr
    assert "create_node" not in done.stdout
