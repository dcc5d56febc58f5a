"""How the studio ends when its terminal goes, or the system says so."""

from __future__ import annotations

import fcntl
import os
import pty
import select
import shutil
import signal
import struct
import sys
import termios
import time
from pathlib import Path

import pytest
from machine import mostly_long
from test_terminal import Terminal, is_running, start, terminal  # noqa: F401 - a fixture

from plastron_tui.studio.key_order import QUIET

pytestmark = pytest.mark.skipif(shutil.which("tmux") is None, reason="there is no tmux")


def wait_for_end(pid: int) -> None:
    end = time.monotonic() + 60
    while is_running(pid):
        assert time.monotonic() < end, "the studio did not end"
        time.sleep(0.05)


# How a studio ends that is terminated is tried below as well, from a shell.
@pytest.mark.parametrize("how", mostly_long(["closed", "terminated"], ["closed"]))
def test_what_was_typed_last_is_offered_when_the_terminal_goes(
    terminal: Terminal,  # noqa: F811
    tmp_path: Path,
    how: str,
) -> None:
    terminal.tmux("new-session", "-d", "-s", "stays", "sleep", "600")
    start(terminal, "mine.plastron")
    terminal.wait(lambda screen: "no nodes yet" in screen)
    terminal.keys("-l", "// typed at the last moment")
    terminal.wait(lambda screen: "last moment" in screen)
    if how == "closed":
        terminal.tmux("kill-window")
    else:
        os.kill(terminal.pid, signal.SIGTERM)
    terminal.wait_end()
    start(terminal, "mine.plastron")
    terminal.wait(lambda screen: "mine.plastron was not saved" in screen)
    # What comes by itself is deaf for so long.
    time.sleep(QUIET)
    terminal.keys("Enter")
    terminal.wait(lambda screen: "// typed at the last moment" in screen and "Save" in screen)
    assert not (tmp_path / "mine.plastron").exists()


def test_a_shell_gets_its_terminal_back_when_the_studio_is_terminated(terminal: Terminal) -> None:  # noqa: F811
    terminal.start("sh", "-i")
    terminal.keys(f"{sys.executable} -m plastron_tui mine.plastron; echo status $?", "Enter")
    terminal.wait(lambda screen: "no nodes yet" in screen)
    pids = terminal.tmux("list-panes", "-a", "-F", "#{pane_pid}").split()
    children = Path(f"/proc/{pids[0]}/task/{pids[0]}/children").read_text().split()
    os.kill(int(children[0]), signal.SIGTERM)
    terminal.wait(lambda screen: "status 143" in screen)
    terminal.keys("-l", "echo still $((40 + 2))")
    terminal.keys("Enter")
    terminal.wait(lambda screen: "still 42" in screen)


def read_until(descriptor: int, wanted: bytes) -> None:
    seen, end = b"", time.monotonic() + 60
    while wanted not in seen:
        assert time.monotonic() < end, seen[-2000:]
        if select.select([descriptor], [], [], 0.2)[0]:
            seen += os.read(descriptor, 65536)


# A terminal that goes also continues who it stops: Textual then starts to draw anew, on nothing.
@pytest.mark.parametrize("number", mostly_long([signal.SIGCONT, None], [None]))
def test_a_terminal_that_goes_ends_the_studio(tmp_path: Path, number: int | None) -> None:
    (tmp_path / "mine.plastron").touch()
    # Whether it draws once more is a matter of chance.
    for _ in range(1 if number is None else 3):
        pid, master = pty.fork()
        if pid == 0:
            fcntl.ioctl(0, termios.TIOCSWINSZ, struct.pack("HHHH", 24, 80, 0, 0))
            os.chdir(tmp_path)
            os.execv(sys.executable, [sys.executable, "-m", "plastron_tui", "mine.plastron"])
        read_until(master, b"no nodes yet")
        if number is not None:
            os.kill(pid, number)
        os.close(master)
        end = time.monotonic() + 30
        while os.waitpid(pid, os.WNOHANG)[0] == 0:
            if time.monotonic() > end:
                os.kill(pid, signal.SIGKILL)
                os.waitpid(pid, 0)
                raise AssertionError("the studio did not end")
            time.sleep(0.02)
