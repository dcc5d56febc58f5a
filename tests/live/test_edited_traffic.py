"""Nodes that a person wrote do after an edit what they did before, but for what was asked."""

from __future__ import annotations

from collections.abc import Collection
from pathlib import Path

import pytest
from graph import Graph
from machine import mostly_long
from played_nodes import NODES, Case
from processes import edit
from rclpy_edits import RCLPY_EDITS
from rospy_edits import ROSPY_EDITS
from traffic import KINDS, Fields, Traffic, differences, record, renamed, without

pytestmark = pytest.mark.live

CASES = ROSPY_EDITS + RCLPY_EDITS
QUICK = {"rclpy/mode_keeper.py"}


@pytest.mark.parametrize("case", mostly_long(CASES, QUICK, lambda case: case.file))
def test_an_edit_changes_only_what_it_names(
    case: Case, request: pytest.FixtureRequest, tmp_path: Path
) -> None:
    library = case.file.split("/")[0]
    graph: Graph = request.getfixturevalue({"rospy": "ros1", "rclpy": "ros2"}[library])
    edited = edit(NODES / case.file, case.statements, tmp_path, node=case.node)
    steps = without(case.steps, case.gone)
    before = record(graph, NODES / case.file, steps, case.serves)
    serves = {case.renames.get(name, name): each for name, each in case.serves.items()}
    after = record(graph, edited, [*renamed(steps, case.renames), *case.new], serves)

    new = {step.name for step in case.new}
    for kind in KINDS:
        kept = {
            name: each for name, each in before.endpoints[kind].items() if name not in case.gone
        }
        found = {name: each for name, each in after.endpoints[kind].items() if name not in new}
        assert found == {case.renames.get(name, name): each for name, each in kept.items()}
    heard = {topic: each for topic, each in before.heard.items() if topic not in {*case.gone, *new}}
    assert not differences(heard, _caused_by_both(case, after, heard), steps)
    added = [step.answer for step in case.new if step.kind == "call"]
    assert after.answers == [*before.answers, *added]
    logs = [log for log in after.logs if not case.new or log in before.logs]
    assert set(logs) == set(before.logs)


def _caused_by_both(case: Case, after: Traffic, topics: Collection[str]) -> dict[str, list[Fields]]:
    """Return what was heard of the edited node, by the original's names, without what is new."""
    heard = {topic: after.heard[case.renames.get(topic, topic)] for topic in topics}
    more = [topic for step in case.new for topic in step.causes]
    return {
        topic: each[: len(each) - more.count(case.renames.get(topic, topic))]
        for topic, each in heard.items()
    }
