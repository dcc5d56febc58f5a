"""Terminals that are closed under what runs in them: how it ends, and that nothing stays."""

from __future__ import annotations

import fcntl
import os
import pty
import select
import signal
import struct
import sys
import termios
import time
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

import pytest
from command_line import PLASTRON
from machine import find_ros, free_port, graph_environ, wait_until

HUNG_UP = 128 + signal.SIGHUP

TALKING = """\
create_node 'talker' as talker
create_message hello of message_type String and input "hello"
talker publish hello to 'chatter' of message_type String at 50 hz
generate_node talker
"""


@dataclass
class Closing:
    """A command in a terminal of its own that is closed."""

    folder: Path
    environ: dict[str, str]
    pid: int = 0
    master: int = -1

    def start(self, *arguments: str, ignores_hang_up: bool) -> None:
        self.pid, self.master = pty.fork()
        if self.pid == 0:
            try:
                fcntl.ioctl(0, termios.TIOCSWINSZ, struct.pack("HHHH", 24, 80, 0, 0))
                if ignores_hang_up:
                    signal.signal(signal.SIGHUP, signal.SIG_IGN)
                os.chdir(self.folder)
                os.execve(sys.executable, [*PLASTRON, *arguments], self.environ)
            finally:
                os._exit(99)

    def read_until(self, wanted: bytes) -> None:
        seen, end = b"", time.monotonic() + 60
        while wanted not in seen:
            assert time.monotonic() < end, seen[-2000:]
            if select.select([self.master], [], [], 0.2)[0]:
                seen += os.read(self.master, 65536)

    def close(self) -> int:
        """Close the terminal, and return the exit status, as a shell has it."""
        os.close(self.master)
        ended: list[int] = []

        def has_ended() -> bool:
            pid, status = os.waitpid(self.pid, os.WNOHANG)
            if pid:
                ended.append(os.waitstatus_to_exitcode(status))
            return bool(ended)

        try:
            wait_until(has_ended, "it ends")
        finally:
            if not ended:
                os.kill(self.pid, signal.SIGKILL)
                os.waitpid(self.pid, 0)
        return ended[0] if ended[0] >= 0 else 128 - ended[0]

    def left(self) -> list[int]:
        """Return the processes that work in the graph of the test's own."""
        mark = f"ROS_HOME={self.environ['ROS_HOME']}".encode()
        found = []
        for path in Path("/proc").glob("[0-9]*/environ"):
            with suppress(OSError):
                if mark in path.read_bytes().split(b"\0"):
                    found.append(int(path.parent.name))
        return found


@pytest.fixture
def closing(tmp_path: Path) -> Closing:
    environ = {**graph_environ(tmp_path), "TERM": "xterm-256color", "XDG_STATE_HOME": str(tmp_path)}
    return Closing(tmp_path, environ)


# Where nothing says that the terminal has gone (`nohup`), what is written says so.
@pytest.mark.parametrize(
    ("options", "shown", "ignores"),
    [
        ((), b"create", False),
        pytest.param(("--watch",), b"chatter", False, marks=pytest.mark.long),
        pytest.param(("--watch",), b"chatter", True, marks=pytest.mark.long),
    ],
)
@pytest.mark.live
def test_a_run_ends_with_its_nodes(
    closing: Closing, options: tuple[str, ...], shown: bytes, ignores: bool
) -> None:
    find_ros(2)
    (closing.folder / "p.plastron").write_text(TALKING)
    command = ("run", "p.plastron", "--target", "rclpy", *options)
    closing.start(*command, ignores_hang_up=ignores)
    closing.read_until(shown)
    wait_until(lambda: len(closing.left()) > 1, "something was started")
    assert closing.close() == HUNG_UP
    wait_until(lambda: not closing.left(), "everything has ended")


@pytest.mark.parametrize(
    ("command", "shown"),
    [("shell", b">> "), ("serve --port {port}", b"the studio is at"), ("p.plastron", b"no nodes")],
)
def test_what_waits_ends(closing: Closing, command: str, shown: bytes) -> None:
    closing.start(*command.format(port=free_port()).split(), ignores_hang_up=False)
    closing.read_until(shown)
    assert closing.close() == HUNG_UP
    wait_until(lambda: not closing.left(), "everything has ended")


@pytest.mark.parametrize("command", ["shell", "p.plastron"])
def test_what_reads_ends_where_nothing_tells_it(closing: Closing, command: str) -> None:
    closing.start(command, ignores_hang_up=True)
    closing.read_until(b">> " if command == "shell" else b"no nodes")
    assert closing.close() == HUNG_UP
    wait_until(lambda: not closing.left(), "everything has ended")


@pytest.mark.live
def test_describe_ends_with_what_looks_for_it(closing: Closing) -> None:
    find_ros(2)
    closing.start("describe", "--ros", "2", ignores_hang_up=False)
    wait_until(lambda: len(closing.left()) > 1, "it looks for nodes")
    assert closing.close() == HUNG_UP
    wait_until(lambda: not closing.left(), "everything has ended")
