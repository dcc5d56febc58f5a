"""Every example of the project does the same on both generations of ROS."""

from __future__ import annotations

import json
import re
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import pytest
from graph import Graph
from processes import Process, generate, own_tracebacks, plastron

pytestmark = pytest.mark.live

# An example that loads a file has nodes of that file's generation only, and managed ones are
# nodes of ROS 2; one with types of its own is built before it runs, and one that names client
# libraries is for those; robots are started by what a package has.
_ROBOT = r"^create_robot "
_OF_ANOTHER_KIND = rf"^load | managed | using |^create_message_type |{_ROBOT}"
FOLDER = Path(__file__).parents[2] / "examples"
EXAMPLES = sorted(
    path
    for path in FOLDER.glob("*.plastron")
    if not re.search(_OF_ANOTHER_KIND, path.read_text(encoding="utf-8"), re.MULTILINE)
)


def drawn(program: Path) -> dict[str, Any]:
    """Return the topics, services and actions of a program."""
    done = plastron("graph", "--format", "json", program)
    assert done.returncode == 0, done.stderr
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
    """Run the nodes of a program; return what travels, by topic, service and action."""
    picture = drawn(program)
    files = generate(str(program.with_suffix("")), output, graph.target)
    nodes = {file: graph.run(path) for file, path in files.items()}
    topics = {each["name"]: each["type"] for each in picture["topics"] if each["publishers"]}
    # What was sent once is kept for whoever asks for it: another node may have heard it before.
    kept = {
        each["name"]
        for each in picture["topics"]
        if each["publishers"]
        and all(
            one.get("qos", {}).get("durability") == "transient_local" for one in each["publishers"]
        )
    }
    seen: dict[str, Any] = {}
    asked: list[tuple[Process, str, int]] = []
    for qos, names in (([], topics.keys() - kept), (["transient_local"], kept)):
        heard = graph.listen({name: topics[name] for name in names}, 3, qos) if names else {}
        for topic, received in heard.items():
            messages = {json.dumps(untimed(each.message), sort_keys=True) for each in received}
            seen[topic] = (topics[topic], sorted(messages))
    for service in picture["services"]:
        if service["providers"]:
            name = service["name"]
            seen[name] = (service["type"], graph.call(name, service["type"], {}))
    for service in picture["services"]:
        for client in service["clients"]:
            [caller] = [node for file, node in nodes.items() if file.startswith(client["node"])]
            count = len(client["requests"])
            # The first node to be interrupted may be the one that answers.
            caller.wait_to_print(f"{client['written']}: ", count=count)
            asked.append((caller, f"{client['written']}: ", count))
            seen[f"{client['node']} calls {service['name']}"] = count
    for action in picture["actions"]:
        for client in action["action_clients"]:
            [asker] = [node for file, node in nodes.items() if file.startswith(client["node"])]
            done = f"{client['written']}: succeeded"
            asker.wait_to_print(done)
            # It has nothing else to do.
            assert asker.wait(60) == 0
            asked.append((asker, done, 1))
            seen[f"{client['node']} sends goals to {action['name']}"] = 1
    for node in nodes.values():
        node.interrupt()
        assert not own_tracebacks(node.output)
    for caller, answer, count in asked:
        assert caller.output.count(answer) == count, caller.output
    return seen


@pytest.mark.long
@pytest.mark.parametrize("program", EXAMPLES, ids=lambda path: path.stem)
def test_an_example_is_the_same_on_both(
    program: Path, ros1: Graph, request: pytest.FixtureRequest, tmp_path: Path
) -> None:
    # What has actions needs a package that is built once for all tests.
    has_actions = bool(drawn(program)["actions"])
    ros2 = request.getfixturevalue("ros2_with_services" if has_actions else "ros2")
    # Neither knows of the other, and both are mostly waited for.
    with ThreadPoolExecutor() as both:
        running = both.submit(traffic, ros1, program, tmp_path / "ros1")
        on_ros2 = traffic(ros2, program, tmp_path / "ros2")
        on_ros1 = running.result()
    assert on_ros1
    assert on_ros2 == on_ros1


CHANGED = [
    # The program, the graph, what its changed node sends, and what it now hears and provides.
    ("change_node", "ros1", "distance", "sonar", "/sonar/mode", "calibrate"),
    ("change_node_ros2", "ros2", "brightness", "lamp", "/lamp/light", "replace_bulb"),
]


def test_every_example_that_loads_a_file_is_run() -> None:
    others = [path for path in FOLDER.glob("*.plastron") if path not in EXAMPLES]
    # Robots are started in `tests/launch/test_robot_live.py`.
    loading = {path.stem for path in others if not re.search(_ROBOT, path.read_text(), re.M)}
    # What `run` says of managed nodes is for `tests/cli/test_run_managed.py` to prove, and what it
    # builds for `tests/runtime/test_live_builds.py`.
    assert loading - {"managed", "own_message", "cpp_and_python"} == {name for name, *_ in CHANGED}


@pytest.mark.long
@pytest.mark.parametrize(("name", "ros", "sent", "node", "heard", "service"), CHANGED)
def test_a_node_that_was_changed_runs(
    name: str,
    ros: str,
    sent: str,
    node: str,
    heard: str,
    service: str,
    request: pytest.FixtureRequest,
    tmp_path: Path,
) -> None:
    graph: Graph = request.getfixturevalue(ros)
    files = generate(str(FOLDER / name), tmp_path, graph.target)
    process = graph.run(files[f"{node}.py"])
    assert graph.listen({sent: "std_msgs/Float32"}, 1)[sent]
    found = graph.wait_for_endpoint(node, "subscriptions", heard)
    assert heard.rpartition("/")[2] not in {topic.strip("/") for topic in found["subscriptions"]}
    assert "success" in graph.call(service, "std_srvs/Trigger", {})
    process.interrupt()
    assert not own_tracebacks(process.output)
