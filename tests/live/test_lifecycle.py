"""A managed node passes the official transitions: its endpoints live and die with them."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from graph import Graph, is_rate, rate
from processes import own_tracebacks
from prototypes import prototype

import plastron_tui.runtime.observers as observers

pytestmark = pytest.mark.live

NAME = "lamp_keeper"
NOTHING: dict[str, int] = {}
THERE = {
    "publishers /state": 1,
    "publishers /count": 1,
    "subscriptions /mood": 1,
    "services /switch": 1,
    "clients /set_lamp": 1,
}
COUNT = {"/count": "std_msgs/Int32"}

# Each official transition, so often as the state allows (design.ros2.org, node_lifecycle).
TWICE = [
    ("configure", "inactive", THERE),
    ("activate", "active", THERE),
    ("deactivate", "inactive", THERE),
    ("activate", "active", THERE),
    ("deactivate", "inactive", THERE),
    ("cleanup", "unconfigured", NOTHING),
    ("configure", "inactive", THERE),
    ("cleanup", "unconfigured", NOTHING),
]
ENDS = {
    "unconfigured": [],
    "inactive": [("configure", "inactive", THERE)],
    "active": [("configure", "inactive", THERE), ("activate", "active", THERE)],
}


def pass_all(graph: Graph, steps: list[tuple[str, str, dict[str, int]]]) -> None:
    passed = graph.lifecycle(NAME, [(label, expected) for label, _, expected in steps])
    assert passed == [[label, True, state, expected] for label, state, expected in steps]


def test_every_transition_twice_leaves_nothing_behind(ros2: Graph) -> None:
    node = ros2.run_and_wait(prototype(ros2, NAME))
    pass_all(ros2, TWICE)
    assert node.interrupt() == 0
    assert not own_tracebacks(node.output)


@pytest.mark.parametrize("steps", ENDS.values(), ids=ENDS)
def test_a_node_is_shut_down_in_any_state(
    ros2: Graph, steps: list[tuple[str, str, dict[str, int]]]
) -> None:
    node = ros2.run_and_wait(prototype(ros2, NAME))
    pass_all(ros2, [*steps, ("shutdown", "finalized", NOTHING)])
    assert node.interrupt() == 0
    assert not own_tracebacks(node.output)


def test_a_transition_that_fails_leaves_nothing_behind(ros2: Graph, tmp_path: Path) -> None:
    text = prototype(ros2, NAME).read_text()
    failing = tmp_path / "failing.py"
    started = "        self.look_around_timer = self.create_timer("
    assert text.count(started) == 1
    failing.write_text(text.replace(started, "        raise ValueError\n" + started))
    node = ros2.run_and_wait(failing)
    for _ in range(2):
        pass_all(ros2, TWICE[:1])
        [passed] = ros2.lifecycle(NAME, [("activate", NOTHING)])
        assert passed == ["activate", False, "unconfigured", NOTHING]
    assert node.interrupt() == 0
    assert not own_tracebacks(node.output)


def test_it_publishes_only_while_it_is_active_and_at_its_rate(ros2: Graph) -> None:
    node = ros2.run_and_wait(prototype(ros2, NAME))
    pass_all(ros2, TWICE[:2])
    assert is_rate(rate(ros2.listen(COUNT, 2)["/count"]), 20)
    pass_all(ros2, TWICE[2:3])
    assert ros2.set_parameter(NAME, "rate", 40.0) is None
    looked = node.output.count("look_around")
    assert ros2.listen(COUNT, 2, silent=COUNT) == {"/count": []}
    assert node.output.count("look_around") == looked
    pass_all(ros2, TWICE[3:4])
    assert is_rate(rate(ros2.listen(COUNT, 2)["/count"]), 40)
    assert ros2.set_parameter(NAME, "rate", 10.0) is None
    assert is_rate(rate(ros2.listen(COUNT, 2)["/count"]), 10)
    assert node.interrupt() == 0
    assert not own_tracebacks(node.output)


def test_managed_nodes_are_brought_up(ros2: Graph) -> None:
    """Those that start late too; one that never comes is told."""
    script = Path(observers.__file__).with_name("lifecycle.py")
    bringing = ros2.run_with(script, "30", f"/{NAME}", "/nobody")
    node = ros2.run_and_wait(prototype(ros2, NAME))
    node.wait_to_print("look_around")
    assert bringing.wait(120) == 1
    told = [json.loads(line) for line in bringing.output.splitlines() if line.startswith("{")]
    assert told == [
        {"node": f"/{NAME}", "error": None},
        {"node": "/nobody", "error": "it does not answer"},
    ]
    again = ros2.run_with(script, "30", f"/{NAME}")
    assert again.wait(120) == 0, again.output
    assert node.interrupt() == 0
    assert not own_tracebacks(node.output)
