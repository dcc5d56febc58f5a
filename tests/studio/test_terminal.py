"""The studio in a real terminal, as tmux gives one."""

from __future__ import annotations

import ast
import os
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import suppress
from pathlib import Path

import pytest

pytestmark = pytest.mark.skipif(shutil.which("tmux") is None, reason="there is no tmux")

PUBLISHER = """\
create_node 'node1' as node1
create_message message1 of message_type Point and input 5,6,7
node1 publish message1 to 'topic1' of message_type Point
generate_node node1
"""


class Terminal:
    """A tmux server of the test's own, with one window."""

    def __init__(self, folder: Path, columns: int, rows: int, environ: dict[str, str]) -> None:
        self._socket = str(folder / "tmux")
        self._size = ["-x", str(columns), "-y", str(rows)]
        self._folder = folder
        self._environ = environ

    def tmux(self, *words: str) -> str:
        command = ["tmux", "-S", self._socket, "-f", os.devnull, *words]
        done = subprocess.run(command, capture_output=True, text=True, check=True, timeout=20)
        return done.stdout

    def start(self, *words: str) -> None:
        settings = [
            part for name, value in self._environ.items() for part in ("-e", f"{name}={value}")
        ]
        self.tmux("new-session", "-d", *self._size, *settings, "-c", str(self._folder), *words)

    def keys(self, *keys: str) -> None:
        self.tmux("send-keys", *keys)

    def type(self, text: str) -> None:
        for line in text.splitlines():
            self.tmux("send-keys", "-l", line)
            self.keys("Enter")

    @property
    def screen(self) -> str:
        return self.tmux("capture-pane", "-p")

    def wait(self, condition: Callable[[str], bool]) -> str:
        end = time.monotonic() + 20
        while time.monotonic() < end:
            screen = self.screen
            if condition(screen):
                return screen
            time.sleep(0.05)
        raise AssertionError(f"it did not come to pass; the screen:\n{self.screen}")

    @property
    def pid(self) -> int:
        return int(self.tmux("display-message", "-p", "#{pane_pid}"))

    def wait_end(self) -> None:
        end = time.monotonic() + 20
        while time.monotonic() < end:
            try:
                if "1" in self.tmux("list-panes", "-F", "#{pane_dead}"):
                    return
            except subprocess.CalledProcessError:
                return
            time.sleep(0.05)
        raise AssertionError(f"the studio did not end; the screen:\n{self.screen}")


@pytest.fixture
def terminal(tmp_path: Path, home: Path) -> Iterator[Terminal]:
    environ = {
        "XDG_CONFIG_HOME": str(home / "config"),
        "XDG_STATE_HOME": str(home / "state"),
        "TERM": "tmux-256color",
        "ROS_VERSION": "1",
    }
    terminal = Terminal(tmp_path, 80, 24, environ)
    yield terminal
    with suppress(subprocess.CalledProcessError):
        terminal.tmux("kill-server")


def start(terminal: Terminal, *arguments: str) -> None:
    terminal.start(sys.executable, "-m", "plastron_tui", *arguments)


def test_a_publisher_is_typed_generated_and_right(terminal: Terminal, tmp_path: Path) -> None:
    start(terminal, "mine.plastron")
    terminal.wait(lambda screen: "no nodes yet" in screen)
    terminal.type(PUBLISHER)
    terminal.wait(lambda screen: "topic1 geometry_msgs/Point" in screen)
    terminal.keys("C-s")
    terminal.wait(lambda screen: "saved mine.plastron" in screen)
    terminal.keys("F6")
    terminal.wait(lambda screen: "+ create" in screen and "node1_pub.py" in screen)
    terminal.keys("Enter")
    terminal.wait(lambda screen: "plastron run mine.plastron" in screen)
    terminal.keys("Escape")
    terminal.wait(lambda screen: "Generate into" not in screen)
    terminal.keys("C-q")
    terminal.wait_end()
    assert (tmp_path / "mine.plastron").read_text() == PUBLISHER
    node = (tmp_path / "output" / "node1_pub.py").read_text()
    ast.parse(node)
    assert 'rospy.Publisher("topic1", Point' in node
    assert "x=5.0, y=6.0, z=7.0" in node


def test_completion_writes_most_of_it(terminal: Terminal, tmp_path: Path) -> None:
    start(terminal, "mine.plastron")
    terminal.wait(lambda screen: "no nodes yet" in screen)
    for typed, offered in (
        ("create_n", "Make a new node."),
        (" 'node1' as node1\r", ""),
        ("create_me", "Make a message"),
        (" message1 of message_type Poi", "Point "),
    ):
        terminal.keys("-l", typed)
        if typed.endswith("\r"):
            continue
        terminal.wait(lambda screen, offered=offered: offered in screen)
        terminal.keys("Tab")
    terminal.wait(lambda screen: "message_type Point" in screen)
    terminal.keys("-l", " and input 5,6,7")
    terminal.keys("Enter")
    terminal.type(PUBLISHER.split("\n", 2)[2])
    terminal.keys("C-s")
    terminal.wait(lambda screen: "saved" in screen)
    written = (tmp_path / "mine.plastron").read_text()
    assert [line.split() for line in written.splitlines()] == [
        line.split() for line in PUBLISHER.splitlines()
    ]


def test_what_was_typed_survives_a_kill(terminal: Terminal, tmp_path: Path) -> None:
    start(terminal, "mine.plastron")
    terminal.wait(lambda screen: "no nodes yet" in screen)
    terminal.type(PUBLISHER)
    terminal.wait(lambda screen: "generate_node node1" in screen)
    time.sleep(1)
    os.kill(terminal.pid, signal.SIGKILL)
    terminal.wait_end()
    start(terminal, "mine.plastron")
    terminal.wait(lambda screen: "mine.plastron was not saved" in screen)
    terminal.keys("Enter")
    terminal.wait(lambda screen: "topic1 geometry_msgs/Point" in screen)
    terminal.keys("C-s")
    terminal.wait(lambda screen: "saved" in screen)
    assert (tmp_path / "mine.plastron").read_text() == PUBLISHER


def test_it_comes_back_after_it_was_suspended(terminal: Terminal, tmp_path: Path) -> None:
    terminal.start("sh", "-i")
    terminal.keys(f"{sys.executable} -m plastron_tui mine.plastron", "Enter")
    terminal.wait(lambda screen: "no nodes yet" in screen)
    terminal.keys("-l", "// before")
    terminal.keys("F10")
    terminal.wait(lambda screen: "Search" in screen)
    terminal.keys("-l", "suspend")
    terminal.wait(lambda screen: "Suspend" in screen)
    terminal.keys("Enter")
    terminal.wait(lambda screen: "no nodes yet" not in screen)
    terminal.keys("fg", "Enter")
    terminal.wait(lambda screen: "// before" in screen and "Nodes" in screen)
    terminal.tmux("resize-window", "-x", "120", "-y", "40")
    terminal.wait(lambda screen: "Problems" in screen and "Output" in screen)
    terminal.keys("-l", " after")
    terminal.wait(lambda screen: "// before after" in screen)


@pytest.mark.parametrize("environ", [{"NO_COLOR": "1"}, {"TERM": "screen"}, {"TERM": "linux"}])
def test_it_works_with_few_colours(
    terminal: Terminal, tmp_path: Path, environ: dict[str, str]
) -> None:
    terminal._environ.update(environ)
    (tmp_path / "mine.plastron").write_text(PUBLISHER + "nothing\n")
    start(terminal, "mine.plastron")
    terminal.wait(lambda screen: "`nothing`" in screen and "topic1 geometry_msgs/Point" in screen)


def test_a_wrong_command_offers_the_right_one(run_plastron: Callable[..., str]) -> None:
    assert "did you mean 'check'" in run_plastron("chek", "x")
    assert "needs a terminal" in run_plastron("none.plastron")


@pytest.fixture
def run_plastron(tmp_path: Path) -> Callable[..., str]:
    def run(*words: str) -> str:
        command = [sys.executable, "-m", "plastron_tui", *words]
        done = subprocess.run(command, capture_output=True, text=True, cwd=tmp_path, check=False)
        assert done.returncode == 2
        return done.stderr

    return run
