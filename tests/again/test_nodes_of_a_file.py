"""A file that holds several nodes: each is loaded by its name, and all are written to one file."""

from __future__ import annotations

from pathlib import Path

import pytest
from file_sets import one

from plastron_tui.model.graph import graph_of
from plastron_tui.output.writer import write
from plastron_tui.session import Options, Session
from plastron_tui.targets import read_source

ARMS = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Left(Node):
    def __init__(self):
        super().__init__("left_arm")
        self.create_subscription(String, "left/command", self.on_command, 10)

    def on_command(self, message):
        self.get_logger().info(message.data)


class Right(Node):
    def __init__(self, name):
        super().__init__(name)
        self.create_subscription(String, "right/command", self.on_command, 10)
        self.out = self.create_publisher(String, "right/state", 10)

    def on_command(self, message):
        self.out.publish(message)


def main():
    rclpy.init()
    rclpy.spin(Left())
"""
LEFT = "load 'arms.py' node 'left_arm' as left\n"
RIGHT = "load 'arms.py' node 'Right' as right\n"
STOP = "subscribe {} to 'stop' of message_type Empty\n"


class Bench:
    """A program beside a file of two nodes."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.written = folder / "output" / "arms.py"
        (folder / "arms.py").write_text(ARMS)

    def session(self, program: str) -> Session:
        return Session(program.encode(), self.folder / "a.plastron", Options(), environ={})

    def generate(self, program: str) -> list[str]:
        """Generate a program that has no mistake, and return the codes of what is told."""
        session = self.session(program)
        assert [found.message for found in session.diagnostics] == []
        plan, found = session.plan()
        result = write(plan)
        return [each.code for each in (*found, *plan.conflicts, *result.diagnostics)]

    def endpoints(self) -> dict[str, set[str]]:
        """Return the names in the written file, by the label of the node."""
        source = read_source(self.written, one(self.written.read_bytes())).source
        assert source is not None
        return {node.label: {each.name or "" for each in node.endpoints} for node in source.nodes}


@pytest.fixture
def bench(tmp_path: Path) -> Bench:
    return Bench(tmp_path)


BEFORE = {"left_arm": {"left/command"}, "Right": {"right/command", "right/state"}}


def test_a_name_is_asked_for(bench: Bench) -> None:
    (found,) = bench.session("load 'arms.py' as arms\n").diagnostics
    assert found.code == "several-nodes"
    assert "`left_arm`, `Right`" in found.message


@pytest.mark.parametrize(("name", "help_"), [("left_arn", "did you mean"), ("x", "there are")])
def test_a_name_that_the_file_does_not_have(bench: Bench, name: str, help_: str) -> None:
    (found,) = bench.session(f"load 'arms.py' node '{name}' as arms\n").diagnostics
    assert found.code == "node-not-found"
    assert help_ in (found.help or "")


def test_a_name_that_two_nodes_of_the_file_have_means_neither(bench: Bench) -> None:
    (bench.folder / "arms.py").write_text(
        ARMS.replace("super().__init__(name)", 'super().__init__("left_arm")')
    )
    (found,) = bench.session(LEFT).diagnostics
    assert found.code == "several-nodes"
    assert "several nodes that are called `left_arm`" in found.message


def test_each_node_has_what_is_its_own(bench: Bench) -> None:
    graph = graph_of(bench.session(LEFT + RIGHT).workspace)
    users = {topic.name: {end.node.variable for end in topic.ends} for topic in graph.topics}
    assert users == {
        "/left/command": {"left"},
        "/right/command": {"right"},
        "/right/state": {"right"},
    }


@pytest.mark.parametrize(("load", "variable"), [(LEFT, "left"), (RIGHT, "right")])
def test_a_change_is_made_in_the_node_that_it_is_for(
    bench: Bench, load: str, variable: str
) -> None:
    assert bench.generate(load + STOP.format(variable) + f"generate_node {variable}\n") == []
    label = {"left": "left_arm", "right": "Right"}[variable]
    assert bench.endpoints() == {**BEFORE, label: BEFORE[label] | {"stop"}}


def test_a_topic_of_another_node_cannot_be_taken_away(bench: Bench) -> None:
    (found,) = bench.session(LEFT + "unsubscribe left from 'right/command'\n").diagnostics
    assert found.code == "not-subscribed"


BOTH = (
    LEFT + RIGHT + STOP.format("left") + STOP.format("right") + "unsubscribe right from "
    "'right/command'\ngenerate_node right\ngenerate_node left\n"
)
AFTER = {"left_arm": {"left/command", "stop"}, "Right": {"right/state", "stop"}}


def test_the_changes_of_all_nodes_are_in_one_file(bench: Bench) -> None:
    assert bench.generate(BOTH) == []
    assert bench.endpoints() == AFTER
    before = bench.written.read_bytes()
    assert bench.generate(BOTH) == []
    assert bench.written.read_bytes() == before
    compile(before, "arms.py", "exec")


@pytest.mark.parametrize("again", [False, True], ids=["lines", "endpoints"])
def test_what_is_written_by_hand_stays(bench: Bench, again: bool) -> None:
    assert bench.generate(BOTH) == []
    text = bench.written.read_text()
    ours = text.replace("self.out.publish(message)", "self.out.publish(message)  # ours")
    if again:
        # The very line that the program takes away: no merge of lines does.
        (line,) = [each for each in text.split("\n") if '"stop"' in each and "left" not in each][:1]
        ours = ours.replace(line, f"{line}  # ours", 1)
    bench.written.write_text(ours)
    fewer = BOTH.replace(STOP.format("left"), "")
    # What is written in a line that goes is told.
    assert bench.generate(fewer) == ["merged-by-hand"] * (2 if again else 1)
    assert bench.endpoints() == {**AFTER, "left_arm": {"left/command"}}
    assert "publish(message)  # ours" in bench.written.read_text()


def test_a_node_may_be_changed_later_than_another(bench: Bench) -> None:
    assert bench.generate(LEFT + STOP.format("left") + "generate_node left\n") == []
    text = bench.written.read_text()
    bench.written.write_text(text.replace("message.data)", "message.data)  # ours"))
    assert bench.generate(BOTH) == ["merged-by-hand"]
    assert bench.endpoints() == AFTER
    assert "# ours" in bench.written.read_text()
