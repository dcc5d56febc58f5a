"""What is sent once comes once, to each that listens, however late."""

from __future__ import annotations

from pathlib import Path

import pytest
from graph import Graph
from machine import mostly_long
from processes import generate_one, own_tracebacks

pytestmark = pytest.mark.live

GOAL = {"/goal_pose": "geometry_msgs/PoseStamped"}


@pytest.mark.parametrize("qos", mostly_long(["", "best_effort", "transient_local"], [""]))
def test_the_first_that_listens_gets_it_once_whatever_it_asks_for(
    graph: Graph, tmp_path: Path, qos: str
) -> None:
    node = graph.run_and_wait(generate_one("navigator", tmp_path, graph.target))
    [goal] = graph.listen(GOAL, 2, [qos])["/goal_pose"]
    assert goal.message["header"]["frame_id"] == "map"
    assert goal.message["header"]["stamp"]["sec"] > 1e9
    assert node.interrupt() == 0
    assert not own_tracebacks(node.output)


@pytest.mark.long
def test_who_comes_later_gets_what_was_sent_then(graph: Graph, tmp_path: Path) -> None:
    node = graph.run_and_wait(generate_one("navigator", tmp_path, graph.target))
    [first] = graph.listen(GOAL, 1)["/goal_pose"]
    for _ in range(2):
        [later] = graph.listen(GOAL, 1, ["transient_local"])["/goal_pose"]
        assert later.message["header"]["stamp"] == first.message["header"]["stamp"]
    assert node.interrupt() == 0
    assert not own_tracebacks(node.output)


@pytest.mark.long
def test_a_warning_says_that_nobody_listens(graph: Graph, tmp_path: Path) -> None:
    node = graph.run_and_wait(generate_one("navigator", tmp_path, graph.target))
    node.wait_to_print("goal_pose: nobody listens yet", count=2)
    graph.listen(GOAL, 0)
    said = node.output.count("nobody listens")
    node.interrupt()
    assert node.output.count("nobody listens") in (said, said + 1)
    assert not own_tracebacks(node.output)
