"""Who is matched with whom, by ROS 2's own rules."""

from __future__ import annotations

from pathlib import Path

import pytest
from graph import Graph
from machine import mostly_long
from processes import generate_one, own_tracebacks

pytestmark = pytest.mark.live

# `/usual` is not among them: it is as the middleware likes.
TOPICS = dict.fromkeys(("/scan", "/map", "/image", "/log", "/pulse"), "std_msgs/Int32")

# What is asked for, and whom it is matched with (docs.ros.org, About Quality of Service settings).
MATCHED = {
    "": {"/map", "/log", "/pulse"},
    "best_effort": set(TOPICS),
    "transient_local": {"/map"},
    "deadline": {"/pulse"},
    "manual_by_topic": {"/pulse"},
}


@pytest.mark.parametrize("word", mostly_long(MATCHED, [""]))
def test_only_what_is_offered_is_heard(ros2: Graph, tmp_path: Path, word: str) -> None:
    matched = MATCHED[word]
    node = ros2.run_and_wait(generate_one("qualities", tmp_path, ros2.target))
    heard = ros2.listen(TOPICS, 1, [word], silent=TOPICS.keys() - matched)
    assert {topic for topic, received in heard.items() if received} == matched
    assert node.interrupt() == 0
    assert not own_tracebacks(node.output)
