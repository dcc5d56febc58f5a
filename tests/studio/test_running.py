"""Nodes that run in the studio: real ones, on the ROS 2 that comes with the extra."""

from __future__ import annotations

import os
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import pytest
from machine import domain_id, mostly_long
from studio_driver import Driver, studio
from test_terminal import Terminal, start
from test_terminal import terminal as terminal

from plastron_tui.studio.main import run_actions
from plastron_tui.studio.recipes import recipes

pytestmark = pytest.mark.live

HAS_ROS2 = (
    subprocess.run([sys.executable, "-c", "import rclpy, std_msgs.msg"], capture_output=True)
).returncode == 0
HEARD = "[INFO] chatter: std_msgs.msg.String(data='hello, robots')"
needs_ros2 = pytest.mark.skipif(
    not HAS_ROS2 and not os.environ.get("CI"), reason="ROS 2 is missing: ./dev setup dev"
)


@pytest.fixture
def talking(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The recipe of two nodes that talk, for ROS 2, in a graph of the test's own."""
    for name, value in graph_of_its_own(tmp_path).items():
        monkeypatch.setenv(name, value)
    monkeypatch.chdir(tmp_path)
    (tmp_path / "plastron.yaml").write_text("target: rclpy\n")
    path = tmp_path / "talk.plastron"
    path.write_bytes(recipes()[0].text)
    return path


def graph_of_its_own(folder: Path) -> dict[str, str]:
    return {
        "ROS_DOMAIN_ID": domain_id(),
        "ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST",
        "ROS_LOG_DIR": str(folder / "log"),
    }


def nodes_of(folder: Path) -> set[int]:
    """Return the processes that run files of the folder."""
    found = set()
    for process in Path("/proc").iterdir():
        if process.name.isdigit():
            try:
                words = (process / "cmdline").read_bytes()
            except OSError:
                continue
            if f"{folder}/output/".encode() in words:
                found.add(int(process.name))
    return found


def wait_gone(folder: Path, seconds: float = 60) -> None:
    end = time.monotonic() + seconds
    while nodes_of(folder):
        assert time.monotonic() < end, f"nodes are left: {nodes_of(folder)}"
        time.sleep(0.05)


@pytest.fixture(autouse=True)
def nothing_is_left(tmp_path: Path) -> Iterator[None]:
    """What every one of these tests has to show in the end."""
    yield
    try:
        wait_gone(tmp_path)
    finally:
        for process in nodes_of(tmp_path):
            os.kill(process, signal.SIGKILL)


async def wait_shown(driver: Driver, *texts: str) -> list[str]:
    """Wait until the output panel shows texts, and return its lines."""
    await driver.until(lambda: all(text in driver.main.panels["output"].text for text in texts))
    lines: list[str] = driver.main.panels["output"].text.splitlines()
    return lines


@needs_ros2
async def test_the_messages_arrive_stop_ends_all_and_a_death_is_said(
    talking: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(run_actions, "TWICE", 0.0)
    async with studio(talking, (80, 24)) as driver:
        await driver.press("f5")
        lines = await wait_shown(driver, "listener |", HEARD)
        assert lines[0] == "plastron run talk.plastron"
        assert any(line.startswith("listener | ") and HEARD in line for line in lines)
        assert driver.main.focused is driver.main.editor.view
        assert "F5 Stop" in driver.main.query_one("KeyBar").text
        # There is room for one of the two: what travels says more than what is printed.
        assert driver.main.dock_layout.is_in_sight("live")
        assert "running" in driver.main.query_one("#title").text
        assert len(nodes_of(tmp_path)) == 2
        await driver.press("f5")
        lines = await wait_shown(driver, "\nstopped")
        assert lines[-1] == "stopped"
        assert "running" not in driver.main.query_one("#title").text
        assert not nodes_of(tmp_path)
        await driver.app.run_call("screen.stop")
        await driver.until(lambda: "nothing runs" in driver.notes())
        # And once more: what was shown is gone. This time the nodes end by themselves.
        await driver.pilot.resize_terminal(120, 40)
        await driver.press("f5")
        lines = await wait_shown(driver, HEARD)
        assert "stopped" not in lines
        for process in nodes_of(tmp_path):
            os.kill(process, signal.SIGKILL)
        lines = await wait_shown(driver, "ended with status")
        assert any("talker was ended by SIGKILL" in line for line in lines), lines
        await driver.until(lambda: "talker was ended by SIGKILL" in driver.notes())
        nodes = driver.main.panels["nodes"]
        assert set(nodes.remarks) == {"talker", "listener"}
        rows = [nodes.render_line(y).text for y in range(nodes.size.height)]
        assert any("talker" in row and "has ended" in row for row in rows), rows


@pytest.mark.skipif(
    not Path("/usr/lib/python3/dist-packages/rospy").is_dir() and not os.environ.get("CI"),
    reason="Debian's ROS 1 is missing: apt-get install python3-rospy python3-roslaunch",
)
@pytest.mark.long
async def test_they_arrive_on_ros_1_too(talking: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    with socket.socket() as listener:
        listener.bind(("127.0.0.1", 0))
        port = listener.getsockname()[1]
    monkeypatch.setenv("ROS_MASTER_URI", f"http://127.0.0.1:{port}")
    monkeypatch.setenv("ROS_IP", "127.0.0.1")
    talking.with_name("plastron.yaml").write_text("target: rospy\n")
    async with studio(talking, (80, 24)) as driver:
        await driver.press("f5")
        await wait_shown(driver, "started a ROS 1 master", "listener | [INFO] chatter: ", "hello")
        await driver.press("f5")
        await wait_shown(driver, "\nstopped")


@needs_ros2
@pytest.mark.long
async def test_leaving_ends_the_nodes(talking: Path, tmp_path: Path) -> None:
    async with studio(talking) as driver:
        await driver.press("f5")
        await wait_shown(driver, HEARD)
        await driver.pilot.press("ctrl+q")
    wait_gone(tmp_path)


async def test_a_run_that_fails_is_said(talking: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PYTHONPATH", str(talking.parent))
    (talking.parent / "rclpy").mkdir()
    (talking.parent / "rclpy" / "__init__.py").write_text("raise ImportError('not that one')\n")
    async with studio(talking) as driver:
        await driver.press("f5")
        lines = await wait_shown(driver, "ended with status 1")
        assert any("error" in line for line in lines), lines
        assert not driver.main.runner.is_running


async def test_a_program_with_mistakes_is_not_run(talking: Path) -> None:
    talking.write_text("nonsense\n")
    async with studio(talking) as driver:
        await driver.press("f5")
        assert "to be fixed first" in driver.notes()
        assert not driver.main.runner.is_running


@needs_ros2
@pytest.mark.long
async def test_what_prints_without_end_leaves_the_studio_responsive(
    talking: Path, tmp_path: Path
) -> None:
    async with studio(talking) as driver:
        await driver.press("f6")
        dialog = await driver.dialog("GenerateDialog")
        await driver.pilot.press("enter")
        await driver.until(lambda: dialog.is_written)
        await driver.pilot.press("escape")
        await driver.back()
        node = tmp_path / "output" / "listener_sub1.py"
        made = node.read_text()
        logging = "        self.get_logger()"
        assert made.count(logging) == 1
        flood = "        while True:\n            print('x' * 60)\n"
        node.write_text(made.replace(logging, flood + logging))
        await driver.press("f5")
        await wait_shown(driver, "x" * 60)
        await driver.pilot.press("alt+1")
        for key in ("alt+2", "alt+1"):
            await driver.pilot.press(key)
            name = {"alt+1": "nodes", "alt+2": "topics"}[key]
            await driver.until(lambda: driver.main.panels[name].has_focus)  # noqa: B023
        assert len(driver.main.panels["output"].lines) <= 5000


@needs_ros2
@pytest.mark.parametrize(
    "how", mostly_long([signal.SIGHUP, signal.SIGTERM, signal.SIGKILL], [signal.SIGKILL])
)
def test_however_the_studio_ends_the_nodes_end(
    talking: Path, tmp_path: Path, terminal: Terminal, how: signal.Signals
) -> None:
    terminal._environ.update(graph_of_its_own(tmp_path))
    start(terminal, str(talking))
    terminal.wait(lambda screen: "create_node 'talker'" in screen)
    terminal.keys("F5")
    terminal.wait(lambda screen: "≈ /chatter" in screen)
    os.kill(terminal.pid, how)
    terminal.wait_end()
    wait_gone(tmp_path)
