"""Real nodes of either ROS, run, watched, described, and run again from the description."""

from __future__ import annotations

import os
import signal
import socket
import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import pytest
from jazzy import jazzy_python
from machine import TALKING, find_ros, graph_environ, wait_until
from processes import own_tracebacks
from supervised import all_gone

from plastron_tui.model.kinds import EndpointKind
from plastron_tui.runtime.describe import Described, DescribedNode, describe
from plastron_tui.runtime.environment import Environment
from plastron_tui.runtime.master import DEFAULT_PORT, call, master_pid
from plastron_tui.runtime.program import to_program

pytestmark = pytest.mark.live

# Another interpreter than the running one may have the Python packages of ROS 2.
ROS2_PYTHON = os.environ.get("PLASTRON_ROS2_PYTHON")

STOPPED = 128 + signal.SIGINT

# Runs every node of a folder, the file's name up to its last `_` being the node's.
DRIVER = """
import os, sys
from pathlib import Path
from plastron_tui.ros.installations import Origin
from plastron_tui.runtime.environment import Environment
from plastron_tui.runtime.launch import NodeFile, Options, run_nodes
origin, version, distribution, python, folder, duration, watch = sys.argv[1:]
environment = Environment(Origin(origin), int(version), distribution, Path(python))
nodes = [
    NodeFile(path.stem.rpartition("_")[0], (python, str(path)), environment, path)
    for path in sorted(Path(folder).glob("*.py"))
]
print("run", os.getpid(), flush=True)
result = run_nodes(nodes, Options(float(duration), watch=bool(watch)))
for diagnostic in result.diagnostics:
    print(diagnostic.code, diagnostic.message, diagnostic.help)
sys.exit(result.status)
"""


@dataclass(frozen=True)
class Ros:
    """A ROS to test with, in a graph of the test's own."""

    environment: Environment
    environ: dict[str, str]
    folder: Path

    def generate(self, program: str, name: str) -> Path:
        file = self.folder / f"{name}.plastron"
        file.write_text(program)
        output = self.folder / name
        arguments = ["generate", str(file), "-o", str(output)]
        subprocess.run(
            [
                *(sys.executable, "-m", "plastron_tui", *arguments),
                *("--target", self.environment.library),
            ],
            check=True,
            capture_output=True,
            timeout=60,
        )
        return output

    def command(self, nodes: Path, duration: float, *, watch: bool = False) -> list[str]:
        one = self.environment
        told = (one.origin.value, one.ros_version, one.distribution, one.python, nodes, duration)
        return [sys.executable, "-c", DRIVER, *map(str, told), "watch" if watch else ""]

    def run(
        self, nodes: Path, duration: float, *, watch: bool = False
    ) -> subprocess.CompletedProcess[str]:
        return subprocess.run(
            self.command(nodes, duration, watch=watch),
            env=self.environ,
            capture_output=True,
            text=True,
            timeout=duration + 60,
            check=False,
        )

    def run_until(
        self,
        said: Callable[[str], object],
        nodes: Path,
        *,
        watch: bool = False,
        status: int = STOPPED,
    ) -> str:
        """Run nodes until something is said, interrupt them, and return all that was said."""
        with self.running(nodes, watch=watch, status=status) as run:
            wait_until(lambda: run.poll() is not None or said(self.said), "it is said", 120)
        return self.said

    @property
    def said(self) -> str:
        """What `running` nodes have said, and the run of them."""
        return self._log.read_text()

    @property
    def _log(self) -> Path:
        return self.folder / "running.log"

    @contextmanager
    def running(
        self, nodes: Path, *, watch: bool = False, status: int = STOPPED
    ) -> Iterator[subprocess.Popen[str]]:
        with self._log.open("w") as log:
            run = subprocess.Popen(
                self.command(nodes, 600, watch=watch),
                env=self.environ,
                stdout=log,
                stderr=log,
                text=True,
            )
            try:
                yield run
            finally:
                run.send_signal(signal.SIGINT)
                assert run.wait(60) == status, self.said

    def described(self, names: set[str]) -> tuple[DescribedNode, ...]:
        """Return the graph, once these nodes are in it with all that they have."""
        found = Described(None)

        def is_there() -> bool:
            nonlocal found
            found = describe(self.environment, environ=self.environ)
            nodes = {node.name for node in found.nodes or () if not node.is_idle}
            return nodes == names

        wait_until(is_there, f"the graph has {names}", 60)
        assert found.nodes is not None
        return found.nodes


@pytest.fixture(params=["rospy", "rclpy"])
def ros(request: pytest.FixtureRequest, tmp_path: Path) -> Ros:
    return _ros(request.param, tmp_path)


@pytest.fixture
def ros1(tmp_path: Path) -> Ros:
    return _ros("rospy", tmp_path)


def _ros(library: str, folder: Path) -> Ros:
    interpreter = Path(ROS2_PYTHON) if ROS2_PYTHON else None
    environment = find_ros(1 if library == "rospy" else 2, interpreter)
    return Ros(environment, graph_environ(folder), folder)


def _lines(output: str, name: str) -> list[str]:
    return [line for line in output.splitlines() if line.split(" |")[0].rstrip() == name]


def _heard(output: str, name: str = "listener") -> list[str]:
    return [line for line in _lines(output, name) if "hello" in line]


# `tests/cli/test_run.py` has the same nodes run by the command.
@pytest.mark.long
def test_nodes_talk_and_stop(ros: Ros) -> None:
    said = ros.run_until(lambda said: len(_heard(said)) > 20, ros.generate(TALKING, "nodes"))
    for node in ("talker", "listener", "switcher", "asker"):
        own = "".join(f"{line.partition('| ')[2]}\n" for line in _lines(said, node))
        assert not own_tracebacks(own), said
    if ros.environment.ros_version == 1:
        uri = ros.environ["ROS_MASTER_URI"]
        assert f"started a ROS 1 master at {uri}" in said
        assert master_pid(uri) is None


@pytest.mark.long
def test_nodes_run_for_a_time(ros: Ros) -> None:
    done = ros.run(ros.generate(TALKING, "nodes"), 6)
    assert done.returncode == 0, done.stdout + done.stderr


@pytest.mark.long
def test_the_watch_shows_topics_and_calls(ros: Ros) -> None:
    def is_told(said: str) -> bool:
        told = [line.partition("| ")[2] for line in _lines(said, "watch")]
        topics = [line for line in told if line.startswith("/chatter std_msgs/String ")]
        return (
            any(15 < float(line.split()[2]) < 25 for line in topics)
            and any(line.endswith('Hz data: "hello"') for line in told)
            and any(line.startswith("/switch (data: True) → (success: ") for line in told)
        )

    ros.run_until(is_told, ros.generate(TALKING, "nodes"), watch=True)


@pytest.mark.long
def test_a_description_run_again_is_the_same_graph(ros: Ros) -> None:
    names = {"/talker", "/listener", "/switcher", "/asker"}
    with ros.running(ros.generate(TALKING, "nodes")):
        wait_until(lambda: _heard(ros.said) and _heard(ros.said, "asker"), "all talk", 120)
        before = ros.described(names)
    by_name = {node.name: node for node in before}
    assert [str(type_) for _, type_ in by_name["/talker"].by_kind[EndpointKind.PUBLISHER]] == [
        "std_msgs/String"
    ]
    assert [str(type_) for _, type_ in by_name["/switcher"].by_kind[EndpointKind.SERVICE]] == [
        "std_srvs/SetBool"
    ]
    program = to_program(before, ros.environment.library)
    with ros.running(ros.generate(program, "again")):
        assert ros.described(names) == before


@pytest.mark.long
def test_a_node_that_crashes_at_its_start(ros: Ros) -> None:
    nodes = ros.generate(TALKING, "nodes")
    (nodes / "crasher_pub.py").write_text("import no_such_module\n")
    said = ros.run_until(
        lambda said: "crasher died" in said and _lines(said, "listener"), nodes, status=1
    )
    assert "plastron | crasher died with exit status 1" in said
    assert ": ModuleNotFoundError: No module named 'no_such_module'" in said


@pytest.mark.long(1)
def test_an_older_ros_2_is_found_and_run_and_watched(
    tmp_path: Path, tmp_path_factory: pytest.TempPathFactory
) -> None:
    environment = find_ros(2, jazzy_python(tmp_path_factory))
    assert environment.words == "ROS 2 jazzy (from the Python packages)"
    ros = Ros(environment, graph_environ(tmp_path), tmp_path)
    test_nodes_talk_and_stop(ros)
    test_the_watch_shows_topics_and_calls(ros)


@pytest.mark.long
def test_a_second_run_beside_the_first(ros: Ros) -> None:
    nodes = ros.generate(TALKING, "nodes")
    environ = {key: value for key, value in ros.environ.items() if key != "ROS_MASTER_URI"}
    first = Ros(ros.environment, environ, ros.folder)
    second = Ros(ros.environment, environ, ros.folder / "second")
    second.folder.mkdir()
    with first.running(nodes) as run:
        wait_until(lambda: "hello" in first.said, "the first run talks", 120)
        said = second.run_until(_heard, nodes)
        assert run.poll() is None
    if ros.environment.ros_version == 1:
        assert "started a ROS 1 master" in said
        assert f":{DEFAULT_PORT}\n" not in said
    assert "died" not in first.said


def test_a_killed_run_takes_its_master_along(ros1: Ros) -> None:
    uri = ros1.environ["ROS_MASTER_URI"]
    with subprocess.Popen(
        ros1.command(ros1.generate(TALKING, "nodes"), 120),
        env=ros1.environ,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    ) as run:
        wait_until(lambda: master_pid(uri) is not None, "a master answers")
        pid = master_pid(uri)
        assert pid is not None
        wait_until(lambda: len(call(uri, "getSystemState")[0]) > 1, "the nodes are there")
        run.kill()
    all_gone(pid)


@pytest.mark.long
def test_a_master_that_answers_is_used_and_stays(ros1: Ros) -> None:
    uri = ros1.environ["ROS_MASTER_URI"]
    nodes = ros1.generate(TALKING, "nodes")
    with ros1.running(nodes):
        wait_until(lambda: master_pid(uri) is not None, "a master answers")
        pid = master_pid(uri)
        other = ros1.generate(TALKING.replace("'talker'", "'other'"), "other")
        for file in other.iterdir():
            if not file.name.startswith("other"):
                file.unlink()
        done = ros1.run(other, 2)
        assert f"using the ROS 1 master at {uri}" in done.stderr
        assert done.returncode == 0, done.stderr
        assert master_pid(uri) == pid


def test_a_master_that_cannot_be_there(ros1: Ros) -> None:
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        uri = f"http://127.0.0.1:{taken.getsockname()[1]}"
        ros = Ros(ros1.environment, {**ros1.environ, "ROS_MASTER_URI": uri}, ros1.folder)
        done = ros.run(ros.generate(TALKING, "nodes"), 2)
    assert done.returncode == 1
    assert f"no-master no ROS 1 master answers at {uri}" in done.stdout


def test_a_graph_that_is_not_there(ros1: Ros) -> None:
    found = describe(ros1.environment, environ=ros1.environ)
    assert found.nodes is None
    assert [diagnostic.code for diagnostic in found.diagnostics] == ["no-graph"]
