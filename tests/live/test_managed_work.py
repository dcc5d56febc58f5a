"""Managed nodes that ask others and work for them: they do so while they are active, only then.

What they talk to (`peer_rclpy.py`, `probe_ros2.py`) knows nothing of Plastron.
"""

from __future__ import annotations

from collections.abc import Mapping
from itertools import product
from pathlib import Path

import pytest
from graph import Graph
from machine import wait_until
from processes import Process, generate_one
from test_goals import ENDLESS, UNTIL_ENDED, end, outcomes, peer, send, serve, told

pytestmark = [pytest.mark.live, pytest.mark.long]

NAME = "worker"
STATEMENTS = {
    "once": "client_requests 'enable_motor' of service_type SetBool with input True",
    "again": "client_requests 'ready' of service_type Trigger with input none at 5 hz",
    "goal": "sends_goal to 'count' of action_type Fibonacci with input order=5",
    "server": "provides_action 'count' of action_type Fibonacci",
}
ACTION_SERVICES = ("send_goal", "cancel_goal", "get_result")
NOTHING: dict[str, int] = {}
THERE = {
    "once": {"clients /enable_motor": 1},
    "again": {"clients /ready": 1},
    "goal": {
        **{f"clients /count/_action/{each}": 1 for each in ACTION_SERVICES},
        **{f"subscriptions /count/_action/{each}": 1 for each in ("feedback", "status")},
    },
    "server": {
        **{f"services /count/_action/{each}": 1 for each in ACTION_SERVICES},
        **{f"publishers /count/_action/{each}": 1 for each in ("feedback", "status")},
    },
}
# A goal of its own would be worked on, and not by the one who is asked in the other tests.
STATEMENTS_OF_ALL = "\nnode ".join(
    each.replace("sends_goal to 'count'", "sends_goal to 'tally'") for each in STATEMENTS.values()
)
THERE_OF_ALL = {
    name.replace("/count", "/tally") if part == "goal" else name: number
    for part, there in THERE.items()
    for name, number in there.items()
}
STATES = {
    "configure": "inactive",
    "activate": "active",
    "deactivate": "inactive",
    "cleanup": "unconfigured",
    "shutdown": "finalized",
}


class Managed:
    """A generated node with one thing to do, or with all of them, and its transitions."""

    def __init__(
        self, graph: Graph, folder: Path, part: str, changes: Mapping[str, str] | None = None
    ) -> None:
        program = folder / f"{NAME}.plastron"
        statements = STATEMENTS.get(part, STATEMENTS_OF_ALL)
        program.write_text(
            f"create_node '{NAME}' as node managed\nnode {statements}\ngenerate_node node\n"
        )
        file = generate_one(str(program.with_suffix("")), folder / "output", graph.target)
        for old, new in (changes or {}).items():
            text = file.read_text()
            assert text.count(old) == 1
            file.write_text(text.replace(old, new))
        self._graph = graph
        self._there = THERE.get(part, THERE_OF_ALL)
        self.process: Process = graph.run_and_wait(file)

    def go(self, *transitions: str) -> None:
        """Pass transitions; after each, what the node has is there, and nothing else."""
        gone = ("cleanup", "shutdown")
        steps = [(each, NOTHING if each in gone else self._there) for each in transitions]
        passed = self._graph.lifecycle(NAME, steps)
        assert passed == [[label, True, STATES[label], has] for label, has in steps], (
            self.process.output
        )


@pytest.fixture
def ros(ros2_with_services: Graph) -> Graph:
    return ros2_with_services


def check_each_activation(node: Managed, text: str) -> None:
    """It prints a text once each time that it is activated, in two rounds of the transitions."""
    for turn in (0, 2):
        node.go("configure", "activate")
        node.process.wait_to_print(text, count=turn + 1)
        node.go("deactivate", "activate")
        node.process.wait_to_print(text, count=turn + 2)
        node.go("deactivate", "cleanup")


def test_a_service_is_called_once_each_time(ros: Graph, tmp_path: Path) -> None:
    server = peer(ros, "answer", 0.0)
    node = Managed(ros, tmp_path, "once")
    check_each_activation(node, "enable_motor: ")
    assert len(told(server, "request", service="enable_motor")) == 4
    end(node.process)
    server.interrupt()


def test_a_service_is_called_again_while_the_node_is_active(ros: Graph, tmp_path: Path) -> None:
    server = peer(ros, "answer", 0.0)
    node = Managed(ros, tmp_path, "again")

    def calls() -> int:
        return len(told(server, "request", service="ready"))

    for _ in range(2):
        for way, back in [(("configure", "activate"), "activate"), ((), "cleanup")]:
            before = calls()
            node.go(*way)
            wait_until(lambda before=before: calls() > before + 5, "calls")
            node.go("deactivate")
            before = calls()
            node.go(back)
            # One may have been on its way; and the node that is active again goes on.
            assert back == "activate" or calls() <= before + 1
    end(node.process)
    server.interrupt()


def test_a_goal_is_sent_each_time(ros: Graph, tmp_path: Path) -> None:
    server = serve(ros, "succeed")
    node = Managed(ros, tmp_path, "goal")
    check_each_activation(node, "count: succeeded: ")
    assert len(told(server, "goal")) == 4
    assert not told(server, "cancel")
    end(node.process)
    server.interrupt()


def test_a_goal_that_was_sent_is_canceled(ros: Graph, tmp_path: Path) -> None:
    server = serve(ros, "hold")
    node = Managed(ros, tmp_path, "goal")
    for turn in range(2):
        node.go("configure", "activate")
        wait_until(lambda turn=turn: len(told(server, "goal")) == turn + 1, "a goal")
        node.process.wait_to_print("count: ", count=node.process.output.count("count: ") + 1)
        node.go("deactivate")
        wait_until(lambda turn=turn: len(told(server, "cancel")) == turn + 1, "a cancel")
        node.go("cleanup")
    # What is destroyed at once may be gone before its cancel is out.
    node.go("configure", "activate")
    wait_until(lambda: len(told(server, "goal")) == 3, "a goal")
    node.go("shutdown")
    end(node.process)
    assert "[ERROR]" not in node.process.output
    server.interrupt()


def test_a_goal_that_is_not_yet_accepted_is_canceled(ros: Graph, tmp_path: Path) -> None:
    server = serve(ros, "late")
    node = Managed(ros, tmp_path, "goal")
    node.go("configure", "activate")
    wait_until(lambda: told(server, "goal"), "a goal")
    node.go("deactivate", "activate")
    # The new goal has nothing to do with the old one.
    wait_until(lambda: len(told(server, "goal")) == 2, "a goal")
    wait_until(lambda: len(told(server, "cancel")) == 1, "a cancel")
    node.process.wait_to_print("count: ")
    node.go("deactivate")
    wait_until(lambda: len(told(server, "cancel")) == 2, "a cancel")
    end(node.process)
    assert "[ERROR]" not in node.process.output
    server.interrupt()


def test_goals_are_worked_on_while_the_node_is_active(ros: Graph, tmp_path: Path) -> None:
    node = Managed(ros, tmp_path, "server", {"range(10)": UNTIL_ENDED["rclpy"]})
    for _ in range(2):
        node.go("configure")
        assert outcomes(send(ros)) == {0: "rejected"}, node.process.output
        node.go("activate")
        assert outcomes(send(ros)) == {0: "succeeded"}, node.process.output
        node.go("deactivate")
        assert outcomes(send(ros)) == {0: "rejected"}, node.process.output
        node.go("activate")
        sender = send(ros, order=ENDLESS)
        sender.wait_to_print('"feedback"')
        node.go("deactivate")
        # What is destroyed at once may be gone before its last message is out.
        assert outcomes(sender) == {0: "aborted"}, node.process.output
        node.go("cleanup")
    end(node.process)


def test_a_goal_that_is_worked_on_ends_with_the_node(ros: Graph, tmp_path: Path) -> None:
    node = Managed(ros, tmp_path, "server", {"range(10)": UNTIL_ENDED["rclpy"]})
    node.go("configure", "activate")
    sender = send(ros, order=ENDLESS)
    sender.wait_to_print('"feedback"')
    node.go("shutdown")
    end(node.process)


BUSY = {
    "once": "enable_motor: nobody serves it yet",
    "again": "ready: nobody serves it yet",
    "goal": "count: nobody serves it yet",
}


@pytest.mark.parametrize("part", BUSY)
def test_what_waits_for_a_server_ends(ros: Graph, tmp_path: Path, part: str) -> None:
    often = {"WARNING_PERIOD = 10.0": "WARNING_PERIOD = 0.2"}
    node = Managed(ros, tmp_path, part, often)
    for _ in range(2):
        node.go("configure", "activate")
        node.process.wait_to_print(BUSY[part], count=node.process.output.count(BUSY[part]) + 2)
        node.go("deactivate")
        warned = node.process.output.count(BUSY[part])
        node.go("cleanup")
        assert node.process.output.count(BUSY[part]) == warned
    node.go("configure", "activate", "shutdown")
    end(node.process)


@pytest.mark.parametrize("part", ["once", "again"])
def test_what_waits_for_an_answer_ends(ros: Graph, tmp_path: Path, part: str) -> None:
    server = peer(ros, "answer", 1000.0)
    node = Managed(ros, tmp_path, part)
    for turn in range(2):
        node.go("configure", "activate")
        wait_until(lambda turn=turn: len(told(server, "request")) > turn, "a request")
        node.go("deactivate", "cleanup")
    node.go("configure", "activate")
    wait_until(lambda: len(told(server, "request")) > 2, "a request")
    node.go("shutdown")
    end(node.process)
    assert "[ERROR]" not in node.process.output
    server.kill()


@pytest.mark.parametrize("part", STATEMENTS)
def test_an_activation_that_fails_leaves_nothing_behind(
    ros: Graph, tmp_path: Path, part: str
) -> None:
    end_of = "        return super().on_activate(state)\n"
    node = Managed(ros, tmp_path, part, {end_of: "        raise ValueError\n" + end_of})
    for _ in range(2):
        node.go("configure")
        [passed] = ros.lifecycle(NAME, [("activate", NOTHING)])
        assert passed == ["activate", False, "unconfigured", NOTHING], node.process.output
    end(node.process)


WAYS: dict[str, tuple[str, ...]] = {
    "unconfigured": (),
    "inactive": ("configure",),
    "active": ("configure", "activate"),
    "deactivated": ("configure", "activate", "deactivate"),
    "cleaned up": ("configure", "activate", "deactivate", "cleanup"),
}


@pytest.mark.parametrize(
    ("part", "way"), [*product(["all"], WAYS), *product(STATEMENTS, ["active"])]
)
def test_ctrl_c_in_each_state(ros: Graph, tmp_path: Path, part: str, way: str) -> None:
    node = Managed(ros, tmp_path, part)
    node.go(*WAYS[way])
    end(node.process)
