"""Actions in the pictures of a graph, as services are."""

from __future__ import annotations

import json
from xml.etree import ElementTree

import pytest

from plastron_tui.model.graph import Graph, graph_of
from plastron_tui.output.graphs import dot, mermaid, svg, text
from plastron_tui.output.graphs import json as as_json
from plastron_tui.output.graphs.boxes import BEVEL, Shape, inset
from plastron_tui.session import Session

PROGRAM = """\
create_node 'counter' as counter using rclpy
counter provides_action 'count' of action_type Fibonacci calling work
create_node 'asker' as asker using rclpy
asker sends_goal to 'count' of action_type Fibonacci with input 5
asker sends_goal to 'carry' of action_type Fibonacci with input 5
subscribe asker to 'scan' of message_type LaserScan with qos best_effort, depth 1
"""


@pytest.fixture
def graph() -> Graph:
    session = Session(PROGRAM.encode(), environ={})
    assert session.diagnostics == ()
    return graph_of(session.workspace)


@pytest.mark.parametrize(
    ("render", "line"),
    [
        (text.render, "  /count  example_interfaces/Fibonacci"),
        (text.render, "    counter  serves  work"),
        (text.render, "    asker    calls"),
        (text.render, "  /carry  example_interfaces/Fibonacci  (nobody serves)"),
        (text.render, "    asker  listens  best_effort, depth 1"),
        (mermaid.render, '  a0[["/count<br/>example_interfaces/Fibonacci"]]:::action'),
        (mermaid.render, "  n1 -. calls .-> a0"),
        (mermaid.render, "  a0 -.-> n0"),
        (dot.render, '  n1 -> a0 [style=dashed, label="calls"];'),
        (dot.render, "  a0 -> n0 [style=dashed];"),
    ],
)
def test_a_picture_has_the_action(graph: Graph, render: object, line: str) -> None:
    assert callable(render)
    assert line in render(graph).splitlines()


def test_the_svg_has_a_goal_and_a_result_for_each_that_meets(graph: Graph) -> None:
    root = ElementTree.fromstring(svg.render(graph))
    classes = [element.get("class") or "" for element in root.iter()]
    shapes = {name for name in classes if name.startswith("action")}
    assert shapes == {"action", "action missing"}
    # The legend has one of each as well.
    assert classes.count("goal") == classes.count("result") == 4


def test_the_data_has_both_sides(graph: Graph) -> None:
    count, carry = json.loads(as_json.render(graph))["actions"]
    assert [each["node"] for each in count["action_servers"]] == ["counter"]
    assert count["action_clients"][0]["goals"] == [{"order": 5}]
    assert carry["missing"] == "action server"


@pytest.mark.parametrize(
    ("dy", "depth"), [(0, 0), (20 - BEVEL, 0), (-(20 - BEVEL), 0), (20, BEVEL), (-20, BEVEL)]
)
def test_an_octagon_gives_way_at_its_corners_alone(dy: float, depth: float) -> None:
    assert inset(Shape.ACTION, 40.0, dy) == depth
