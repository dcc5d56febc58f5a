"""A managed node passes the official transitions: its endpoints live and die with them."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from graph import Graph, is_rate, rate
from processes import generate, own_tracebacks

import plastron_tui.runtime.observers as observers

pytestmark = pytest.mark.live

NAME = "lamp_keeper"
NOTHING: dict[str, int] = {}
THERE = {
    "publishers /state": 1,
    "publishers /count": 1,
    "publishers /greeting": 1,
    "publishers /echo": 1,
    "subscriptions /mood": 1,
    "services /switch": 1,
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


@pytest.fixture
def keeper(ros2: Graph, tmp_path: Path) -> Path:
    """The file of a managed node, as it is generated."""
    return generate(NAME, tmp_path / "output", ros2.target)[f"{NAME}_node.py"]


def pass_all(graph: Graph, steps: list[tuple[str, str, dict[str, int]]]) -> None:
    passed = graph.lifecycle(NAME, [(label, expected) for label, _, expected in steps])
    assert passed == [[label, True, state, expected] for label, state, expected in steps]


def test_every_transition_twice_leaves_nothing_behind(ros2: Graph, keeper: Path) -> None:
    node = ros2.run_and_wait(keeper)
    pass_all(ros2, TWICE)
    assert node.interrupt() == 0
    assert not own_tracebacks(node.output)


@pytest.mark.long
@pytest.mark.parametrize("steps", ENDS.values(), ids=ENDS)
def test_a_node_is_shut_down_in_any_state(
    ros2: Graph, keeper: Path, steps: list[tuple[str, str, dict[str, int]]]
) -> None:
    node = ros2.run_and_wait(keeper)
    pass_all(ros2, [*steps, ("shutdown", "finalized", NOTHING)])
    assert node.interrupt() == 0
    assert not own_tracebacks(node.output)


@pytest.mark.long
def test_a_transition_that_fails_leaves_nothing_behind(
    ros2: Graph, keeper: Path, tmp_path: Path
) -> None:
    text = keeper.read_text()
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


@pytest.mark.long
def test_it_publishes_only_while_it_is_active_and_at_its_rate(ros2: Graph, keeper: Path) -> None:
    node = ros2.run_and_wait(keeper)
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


@pytest.mark.long
def test_it_answers_and_sends_once_while_it_is_active(ros2: Graph, keeper: Path) -> None:
    node = ros2.run_and_wait(keeper)
    pass_all(ros2, TWICE[:2])
    [greeting] = ros2.listen({"/greeting": "std_msgs/String"}, 2)["/greeting"]
    assert greeting.message == {"data": "here I am"}
    answer = ros2.call("/switch", "std_srvs/SetBool", {"data": True})
    assert answer == {"success": True, "message": "switched"}
    assert node.interrupt() == 0
    assert not own_tracebacks(node.output)


@pytest.mark.long
def test_managed_nodes_are_brought_up(ros2: Graph, keeper: Path) -> None:
    """Those that start late too; one that never comes is told."""
    script = Path(observers.__file__).with_name("lifecycle.py")
    bringing = ros2.run_with(script, "30", f"/{NAME}", "/nobody")
    node = ros2.run_and_wait(keeper)
    node.wait_to_print("look_around")
    assert bringing.wait(120) == 0, bringing.output
    told = [json.loads(line) for line in bringing.output.splitlines() if line.startswith("{")]
    assert told == [
        {"node": f"/{NAME}", "passed": ["configure", "activate"], "error": None},
        {"node": "/nobody", "passed": [], "error": "it does not answer"},
    ]
    again = ros2.run_with(script, "30", f"/{NAME}")
    assert again.wait(120) == 0, again.output
    assert json.loads(again.output) == {"node": f"/{NAME}", "passed": [], "error": None}
    assert node.interrupt() == 0
    assert not own_tracebacks(node.output)
