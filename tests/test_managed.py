"""Whether a node is managed is known everywhere: of what is created, loaded, and remembered."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import pytest

from plastron_tui.model.graph import graph_of
from plastron_tui.model.program_text import program_of
from plastron_tui.output.graphs import render
from plastron_tui.output.node_json import recall, remember
from plastron_tui.runtime.launch import activation_of
from plastron_tui.session import Options, Session
from plastron_tui.sources.python.layout import fit

NODES = Path(__file__).parent / "nodes" / "rclpy"
PROGRAM = """\
create_node 'made' as made managed using rclpy
made repeats work at 1 hz
create_node 'plain' as plain using rclpy
plain repeats work at 1 hz
load 'lifecycle_talker.py' as loaded
load 'battery_monitor.py' as other
generate_node made
generate_node loaded
"""
MANAGED = {"made": True, "plain": False, "loaded": True, "other": False}


@pytest.fixture
def session(tmp_path: Path) -> Session:
    for name in ("lifecycle_talker.py", "battery_monitor.py"):
        shutil.copy(NODES / name, tmp_path / name)
    options = Options("rclpy", tmp_path / "output")
    return Session(PROGRAM.encode(), tmp_path / "p.plastron", options, environ={})


def test_nodes_that_are_created_and_loaded(session: Session) -> None:
    nodes = session.workspace.nodes
    assert {name: node.is_managed for name, node in nodes.items()} == MANAGED
    made = [each.node for each in session.workspace.generations]
    assert all(node.is_managed for node in made)
    recalled = [recall(json.loads(json.dumps(remember(node, "rclpy", "p")))) for node in made]
    assert [node is not None and node.is_managed for node in recalled] == [True, True]


def test_the_graph_as_data_and_as_text(session: Session) -> None:
    graph = graph_of(session.workspace)
    data = json.loads(render(graph, "json"))
    assert {node["variable"]: node.get("managed", False) for node in data["nodes"]} == MANAGED
    assert render(graph, "text").count("managed") == 2


def test_a_file_as_a_program_creates_managed_nodes(session: Session) -> None:
    source = session.workspace.nodes["loaded"].source
    assert source is not None
    first = next(x for x in program_of(source, 2).splitlines() if x.startswith("create_node"))
    assert first.endswith(" managed using rclpy")


@pytest.mark.parametrize(
    ("line", "told"),
    [
        (
            '{"node": "/a", "passed": ["configure"], "error": null}',
            ("/a", ("configure",), None, "active"),
        ),
        ('{"node": "/a", "passed": [], "error": "why"}', ("/a", (), "why", "active")),
        (
            '{"node": "/a", "passed": [], "error": null, "wanted": "loaded"}',
            ("/a", (), None, "loaded"),
        ),
        ("[INFO] a log of the client library", None),
        ('{"node": "/a"}', None),
        ('"text"', None),
        ("[" * 100_000, None),
    ],
    ids=["active", "failed", "loaded", "log", "other", "text", "deep"],
)
def test_what_is_told_of_an_activation(line: str, told: object) -> None:
    assert activation_of(line) == told


def test_an_assignment_whose_name_leaves_no_room_goes_into_parentheses() -> None:
    name, call = "self." + "long_" * 12 + "name", "self.create_lifecycle_publisher"
    assert fit(f'    {name} = {call}(String, "a", 10)\n') == (
        f'    {name} = (\n        {call}(String, "a", 10)\n    )\n'
    )


@pytest.mark.parametrize(
    ("line", "operands"),
    [
        ("if not {0} or {1} is not goal:", ["not {0}", "or {1} is not goal"]),
        ("while {0} and not {1} or goal:", ["{0} and not {1}", "or goal"]),
        ("elif goal == ' and ' and {0} and {1}:", ["goal == ' and '", "and {0}", "and {1}"]),
    ],
)
def test_a_condition_that_is_too_long_goes_into_parentheses(line: str, operands: list[str]) -> None:
    names = "self." + "long_" * 6 + "one", "self." + "long_" * 6 + "two"
    word = line.partition(" ")[0]
    inner = "".join(f"        {each.format(*names)}\n" for each in operands)
    assert fit(f"    {line.format(*names)}\n") == f"    {word} (\n{inner}    ):\n"


@pytest.mark.parametrize(
    "line",
    [
        "{0} = {1}('a'); self.b = {1}('b')",
        "{0} = self.b = {1}('a')",
        "{0} = {1}('a') or \\\n    None",
    ],
    ids=["two statements", "two assignments", "two lines"],
)
def test_parentheses_stand_around_one_whole_value_only(line: str) -> None:
    text = line.format("self." + "long_" * 12 + "name", "self.create_lifecycle_publisher")
    compile(fit(text), "node.py", "exec")


@pytest.mark.parametrize("length", range(63, 73))
def test_a_value_is_in_brackets_only_where_they_stand_in_the_line(length: int) -> None:
    """As ruff has it: `name = (` stands in the line or helps nobody."""
    name = "a" * length
    opened = f"        self.{name}.ns = ("
    laid = fit(f"        self.{name}.ns = int(1e9 / self.value_of(parameter))\n")
    assert (laid.splitlines()[0] == opened) == (len(opened) <= 88 < len(opened) + len("int"))
