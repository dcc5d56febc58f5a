"""How the studio ends when its terminal goes, or the system says so; in tmux."""

from __future__ import annotations

import os
import shutil
import signal
import sys
import time
from pathlib import Path

import pytest
from test_terminal import Terminal, start, terminal  # noqa: F401 - a fixture

pytestmark = pytest.mark.skipif(shutil.which("tmux") is None, reason="there is no tmux")


def wait_for_end(pid: int) -> None:
    end = time.monotonic() + 60
    while time.monotonic() < end:
        try:
            os.kill(pid, 0)
        except ProcessLookupError:
            return
        time.sleep(0.05)
    raise AssertionError("the studio did not end")


@pytest.mark.parametrize("how", ["closed", "terminated"])
def test_what_was_typed_last_is_offered_when_the_terminal_goes(
    terminal: Terminal,  # noqa: F811
    tmp_path: Path,
    how: str,
) -> None:
    terminal.tmux("new-session", "-d", "-s", "stays", "sleep", "600")
    start(terminal, "mine.plastron")
    terminal.wait(lambda screen: "no nodes yet" in screen)
    pid = terminal.pid
    terminal.keys("-l", "// typed at the last moment")
    terminal.wait(lambda screen: "last moment" in screen)
    if how == "closed":
        terminal.tmux("kill-window")
    else:
        os.kill(pid, signal.SIGTERM)
    wait_for_end(pid)
    start(terminal, "mine.plastron")
    terminal.wait(lambda screen: "mine.plastron was not saved" in screen)
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
