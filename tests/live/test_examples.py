"""Every example of the project does the same on both generations of ROS."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path
from typing import Any

import pytest
from graph import Graph
from processes import PLASTRON, generate

pytestmark = pytest.mark.live

# An example that loads a file has nodes of that file's generation only.
EXAMPLES = sorted(
    path
    for path in (Path(__file__).parents[2] / "examples").glob("*.plastron")
    if "\nload " not in path.read_text(encoding="utf-8")
)


def drawn(program: Path) -> dict[str, Any]:
    """Return the topics and services of a program."""
    done = subprocess.run(
        [PLASTRON, "graph", "--format", "json", program], capture_output=True, check=True
    )
    found: dict[str, Any] = json.loads(done.stdout)
    return found


def untimed(message: dict[str, Any]) -> dict[str, Any]:
    """Return a message without what differs from moment to moment, and from ROS to ROS."""
    return {
        name: untimed(value) if isinstance(value, dict) else value
        for name, value in message.items()
        if name not in {"stamp", "seq"}
    }


def traffic(graph: Graph, program: Path, output: Path) -> dict[str, Any]:
    """Run the nodes of a program; return what travels, by topic and service."""
    picture = drawn(program)
    files = generate(str(program.with_suffix("")), output, graph.target)
    nodes = {file: graph.run(path) for file, path in files.items()}
    topics = {each["name"]: each["type"] for each in picture["topics"] if each["publishers"]}
    seen: dict[str, Any] = {}
    if topics:
        for topic, received in graph.listen(topics, 3).items():
            messages = {json.dumps(untimed(each.message), sort_keys=True) for each in received}
            seen[topic] = (topics[topic], sorted(messages))
    for service in picture["services"]:
        if service["providers"]:
            name = service["name"]
            seen[name] = (service["type"], graph.call(name, service["type"], {}))
    for node in nodes.values():
        node.interrupt()
        assert "Traceback" not in node.output
    for service in picture["services"]:
        for client in service["clients"]:
            [caller] = [node for file, node in nodes.items() if file.startswith(client["node"])]
            answers = caller.output.count(f"{client['written']}: ")
            assert answers == len(client["requests"]), caller.output
            seen[f"{client['node']} calls {service['name']}"] = answers
    return seen


@pytest.mark.parametrize("program", EXAMPLES, ids=lambda path: path.stem)
def test_an_example_is_the_same_on_both(
    program: Path, ros1: Graph, ros2: Graph, tmp_path: Path
) -> None:
    on_ros1 = traffic(ros1, program, tmp_path / "ros1")
    assert on_ros1
    assert traffic(ros2, program, tmp_path / "ros2") == on_ros1
