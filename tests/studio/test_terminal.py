"""The studio in a real terminal, as tmux gives one."""

from __future__ import annotations

import ast
import os
import re
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import suppress
from pathlib import Path

import pytest

from plastron_tui.studio.key_order import QUIET

pytestmark = pytest.mark.skipif(shutil.which("tmux") is None, reason="there is no tmux")

PUBLISHER = """\
create_node 'node1' as node1
create_message message1 of message_type Point and input 5,6,7
node1 publish message1 to 'topic1' of message_type Point
generate_node node1
"""


PATIENCE = 60
"""Seconds after which a test gives up; nothing takes so long, however busy the machine is."""


def until(condition: Callable[[], bool]) -> bool:
    """Wait for something to come to pass; tell whether it has."""
    end = time.monotonic() + PATIENCE
    while time.monotonic() < end:
        if condition():
            return True
        time.sleep(0.05)
    return False


def is_running(pid: int) -> bool:
    """Tell whether a process runs: one that has ended may still be listed."""
    try:
        state = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0]
    except (FileNotFoundError, ProcessLookupError):
        return False
    return state != "Z"


_OF_TERMINALS = frozenset({"TMUX", "TMUX_PANE", "COLUMNS", "LINES"})
"""What a shell says of its own terminal: the size of all windows, the pane that is meant."""


class Terminal:
    """A tmux server of the test's own, with one window."""

    def __init__(self, folder: Path, columns: int, rows: int, environ: dict[str, str]) -> None:
        self._socket = str(folder / "tmux")
        self._size = ["-x", str(columns), "-y", str(rows)]
        self._folder = folder
        self._environ = environ
        self.pid = 0
        """The process last started; asked once, since tmux forgets it when it has ended."""

    def tmux(self, *words: str) -> str:
        command = ["tmux", "-S", self._socket, "-f", os.devnull, *words]
        environ = {name: value for name, value in os.environ.items() if name not in _OF_TERMINALS}
        done = subprocess.run(
            command, capture_output=True, text=True, check=True, timeout=PATIENCE, env=environ
        )
        return done.stdout

    def start(self, *words: str) -> None:
        # tmux has a TERM of its own for what it starts.
        settings = [f"{name}={value}" for name, value in self._environ.items()]
        session = ["new-session", "-d", *self._size, "-c", str(self._folder)]
        command = [*session, "-P", "-F", "#{pane_pid}", "env", *settings, *words]

        def is_started() -> bool:
            # A server that is about to end takes nothing new.
            with suppress(subprocess.CalledProcessError):
                self.pid = int(self.tmux(*command))
                return True
            return False

        assert until(is_started)

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
        screens = [""]

        def holds() -> bool:
            screens.append(self.screen)
            return condition(screens[-1])

        assert until(holds), f"it did not come to pass; the screen:\n{screens[-1]}"
        return screens[-1]

    def wait_below(self, line: str, offered: str) -> None:
        """Wait until a line is there, and below it, or after it, what is offered."""
        self.wait(
            lambda screen: line in screen and offered in " ".join(screen.partition(line)[2].split())
        )

    def wait_end(self) -> None:
        # The system knows it first: tmux may take its time to look after what has ended.
        def has_ended() -> bool:
            return not is_running(self.pid)

        assert until(has_ended), f"the studio did not end; the screen:\n{self.screen}"


@pytest.fixture
def terminal(tmp_path: Path, home: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Terminal]:
    # As in a window of tmux whose shell exports its size.
    for name, value in {"TMUX_PANE": "%0", "COLUMNS": "200", "LINES": "9"}.items():
        monkeypatch.setenv(name, value)
    environ = {
        "XDG_CONFIG_HOME": str(home / "config"),
        "XDG_STATE_HOME": str(home / "state"),
        "TERM": "tmux-256color",
        "COLORTERM": "",
        "ROS_VERSION": "1",
    }
    terminal = Terminal(tmp_path, 80, 24, environ)
    yield terminal
    with suppress(subprocess.CalledProcessError):
        terminal.tmux("kill-server")


def start(terminal: Terminal, *arguments: str) -> None:
    terminal.start(sys.executable, "-m", "plastron_tui", *arguments)


def generate_and_quit(terminal: Terminal, folder: Path) -> None:
    terminal.keys("C-s")
    terminal.wait(lambda screen: "saved mine.plastron" in screen)
    terminal.keys("F6")
    terminal.wait(lambda screen: "+ create" in screen and "node1_pub.py" in screen)
    terminal.keys("Enter")
    terminal.wait(lambda screen: "plastron run mine.plastron" in screen)
    terminal.keys("Escape")
    terminal.wait(lambda screen: "Close" not in screen)
    terminal.keys("C-q")
    terminal.wait_end()
    node = folder / "output" / "node1_pub.py"
    text = node.read_text()
    ast.parse(text)
    assert 'rospy.Publisher("topic1", Point' in text
    assert "x=5.0, y=6.0, z=7.0" in text
    assert os.access(node, os.X_OK)


def test_a_publisher_is_typed_generated_and_right(terminal: Terminal, tmp_path: Path) -> None:
    start(terminal, "mine.plastron")
    terminal.wait(lambda screen: "no nodes yet" in screen)
    terminal.type(PUBLISHER)
    terminal.wait(lambda screen: "topic1 geometry_msgs/Point" in screen)
    generate_and_quit(terminal, tmp_path)
    assert (tmp_path / "mine.plastron").read_text() == PUBLISHER


def test_keys_from_before_the_first_screen_are_not_lost(terminal: Terminal, tmp_path: Path) -> None:
    start(terminal, "mine.plastron")
    typed = ""
    # From before the studio has the terminal until it has shown itself.
    while "Ctrl-Q" not in terminal.screen or len(typed) < 20:
        typed += "xyz"[len(typed) % 3]
        terminal.keys("-l", typed[-1])
    file = tmp_path / "mine.plastron"
    terminal.keys("C-s")
    assert until(file.exists)
    assert file.read_text() == typed


def test_completion_writes_most_of_a_publisher(terminal: Terminal, tmp_path: Path) -> None:
    start(terminal, "mine.plastron")
    terminal.wait(lambda screen: "no nodes yet" in screen)
    line = ""
    for typed, offered in (
        ("create_n", "create_node Make a new node."),
        (" 'node1' as n", "node1"),
        ("\rcreate_me", "create_message Make a message"),
        (" message1 of message_type Poi", "Point x:"),
        (" and input 5,6,7\rnod", "node1 node 'node1'"),
        (" pub", "publish"),
        (" mes", "message1"),
        (" to 'topic1' of message_ty", "message_type"),
        (" Po", "Point x:"),
        ("\rgenerate_n", "generate_node Write"),
        (" no", "node1 node 'node1'"),
    ):
        terminal.keys("-l", typed)
        line = (line + typed).rpartition("\r")[2]
        terminal.wait_below(line, offered)
        terminal.keys("Tab")
        before, space, _ = line.rpartition(" ")
        line = before + space + offered.split()[0]
        terminal.wait_below(line, "")
    terminal.keys("Enter")
    terminal.wait(lambda screen: "topic1 geometry_msgs/Point" in screen)
    generate_and_quit(terminal, tmp_path)
    assert (tmp_path / "mine.plastron").read_text() == PUBLISHER


def test_what_was_typed_survives_a_kill(terminal: Terminal, tmp_path: Path, home: Path) -> None:
    start(terminal, "mine.plastron")
    terminal.wait(lambda screen: "no nodes yet" in screen)
    terminal.type(PUBLISHER)
    journals = home / "state" / "plastron" / "journal"
    assert until(lambda: any(PUBLISHER in file.read_text() for file in journals.glob("*.journal")))
    os.kill(terminal.pid, signal.SIGKILL)
    terminal.wait_end()
    start(terminal, "mine.plastron")
    terminal.wait(lambda screen: "mine.plastron was not saved" in screen)
    # What comes by itself is deaf for so long.
    time.sleep(QUIET)
    terminal.keys("Enter")
    terminal.wait(lambda screen: "topic1 geometry_msgs/Point" in screen)
    terminal.keys("C-s")
    terminal.wait(lambda screen: "saved" in screen)
    assert (tmp_path / "mine.plastron").read_text() == PUBLISHER


def test_it_comes_back_after_it_was_suspended(terminal: Terminal, tmp_path: Path) -> None:
    terminal.start("sh", "-i")
    # What goes wrong may be written to a file; what is drawn is not.
    terminal.keys(f"{sys.executable} -m plastron_tui mine.plastron 2>log", "Enter")
    terminal.wait(lambda screen: "no nodes yet" in screen)
    terminal.keys("-l", "// before")
    terminal.keys("F10")
    terminal.wait(lambda screen: "What do you want" in screen)
    terminal.keys("-l", "suspend")
    terminal.wait(lambda screen: "Suspend" in screen)
    terminal.keys("Enter")
    terminal.wait(lambda screen: "stopped" in screen.lower() and "no nodes yet" not in screen)
    terminal.keys("fg", "Enter")
    terminal.wait(lambda screen: "// before" in screen and "Nodes" in screen)
    terminal.tmux("resize-window", "-x", "120", "-y", "40")
    terminal.wait(lambda screen: "Problems" in screen and "Output" in screen)
    terminal.keys("-l", " after")
    terminal.wait(lambda screen: "// before after" in screen)
    assert (tmp_path / "log").read_text() == ""


@pytest.mark.parametrize(
    "environ",
    [
        {"NO_COLOR": "1"},
        pytest.param({"TERM": "screen"}, marks=pytest.mark.long),
        {"TERM": "linux"},
    ],
)
def test_it_works_with_few_colours(
    terminal: Terminal, tmp_path: Path, environ: dict[str, str]
) -> None:
    terminal._environ.update(environ)
    (tmp_path / "mine.plastron").write_text(PUBLISHER + "nothing\n")
    start(terminal, "mine.plastron")
    terminal.wait(lambda screen: "`nothing`" in screen and "topic1 geometry_msgs/Point" in screen)
    colours = set(re.findall(r"[34]8;[25];[0-9;]+", terminal.tmux("capture-pane", "-p", "-e")))
    assert bool(colours) == ("TERM" not in environ)


def test_another_editor_has_the_terminal_meanwhile(terminal: Terminal, tmp_path: Path) -> None:
    editor = tmp_path / "own_editor"
    editor.write_text('#!/bin/sh\necho what now; read answer; echo "// $answer" >>"$1"\n')
    editor.chmod(0o755)
    terminal._environ["EDITOR"] = str(editor)
    (tmp_path / "mine.plastron").write_text(PUBLISHER)
    start(terminal, "mine.plastron")
    terminal.wait(lambda screen: "topic1 geometry_msgs/Point" in screen)
    terminal.keys("C-e")
    terminal.wait(lambda screen: "what now" in screen and "Nodes" not in screen)
    terminal.keys("-l", "an answer")
    terminal.keys("Enter")
    terminal.wait(lambda screen: "// an answer" in screen and "Nodes" in screen)
    terminal.keys("C-End")
    terminal.keys("-l", "generate_")
    terminal.wait(lambda screen: "generate_node " in screen)


def test_an_editor_that_cannot_be_started_leaves_the_terminal_to_the_studio(
    terminal: Terminal,
) -> None:
    terminal._environ["EDITOR"] = "no-such-editor"
    start(terminal, "mine.plastron")
    terminal.wait(lambda screen: "no nodes yet" in screen)
    terminal.keys("C-e")
    terminal.wait(lambda screen: "`no-such-editor` cannot be started" in screen)
    terminal.keys("-l", "// still here")
    terminal.wait(lambda screen: "// still here" in screen)


def test_what_is_copied_reaches_the_clipboard_of_the_terminal(
    terminal: Terminal, tmp_path: Path
) -> None:
    (tmp_path / "mine.plastron").write_text("// 日本\n")
    start(terminal, "mine.plastron")
    terminal.tmux("set-option", "-s", "set-clipboard", "on")
    terminal.wait(lambda screen: "no nodes yet" in screen)
    terminal.keys("S-End", "C-c")

    def is_copied() -> bool:
        with suppress(subprocess.CalledProcessError):
            return terminal.tmux("show-buffer") == "// 日本"
        return False

    assert until(is_copied)


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
