"""A run in a process of its own, which tests can interrupt, kill and watch."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

from machine import wait_until

# Runs the nodes that it is told on its command line, and then tells what it still holds.
DRIVER = """
import json, os, sys
from plastron_tui.runtime.child import Process
from plastron_tui.runtime.console import Console
from plastron_tui.runtime.supervisor import Supervisor

def descriptors():
    names = os.listdir("/proc/self/fd")
    return sorted(name for name in names if os.path.exists(f"/proc/self/fd/{name}"))

nodes, duration = json.loads(sys.argv[1]), json.loads(sys.argv[2])
before = descriptors()
processes = [Process(name, tuple(argv)) for name, argv in nodes]
names = [name for name, _ in nodes]
console = Console(names, sys.stdout, sys.stderr, on_gone=lambda: supervisor.stop())
supervisor = Supervisor(console.line, console.ended)
with supervisor:
    for process in processes:
        supervisor.start(process)
    status = supervisor.wait(duration)
try:
    os.waitpid(-1, os.WNOHANG)
except ChildProcessError:
    pass
else:
    print("a child is left")
if descriptors() != before:
    print("descriptors are left", before, descriptors())
sys.exit(status)
"""

# Notes its process under its name, and the one that it starts.
NOTE = """
import os, pathlib, subprocess, sys, time, signal
def note(name, pid=None):
    path = pathlib.Path({folder!r}, name)
    path.with_suffix(".new").write_text(str(pid or os.getpid()))
    path.with_suffix(".new").rename(path)
"""


@dataclass(frozen=True)
class Nodes:
    """Makes small nodes that note their processes in a folder."""

    folder: Path

    def python(self, name: str, code: str) -> tuple[str, list[str]]:
        text = NOTE.format(folder=str(self.folder)) + code
        return name, [sys.executable, "-u", "-c", text]

    def ticking(self, name: str, *, helper: str = "") -> tuple[str, list[str]]:
        """A node that never ends by itself, perhaps with a process of its own."""
        start = f"note({helper!r}, subprocess.Popen(['sleep', '600']).pid)" if helper else ""
        return self.python(
            name, f"{start}\nnote({name!r})\nwhile True:\n    print('tick')\n    time.sleep(0.05)"
        )

    def stubborn(self, name: str) -> tuple[str, list[str]]:
        """A node that asks to be killed."""
        return self.python(
            name,
            "for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):\n"
            "    signal.signal(number, signal.SIG_IGN)\n"
            f"note({name!r})\nwhile True:\n    time.sleep(1)",
        )

    def pid(self, name: str) -> int:
        """Return a noted process, once it is there."""
        path = self.folder / name
        wait_until(path.exists, f"{name} starts")
        return int(path.read_text())


def command(nodes: list[tuple[str, list[str]]], duration: float | None = None) -> list[str]:
    return [sys.executable, "-c", DRIVER, json.dumps(nodes), json.dumps(duration)]


def run(
    nodes: list[tuple[str, list[str]]], duration: float | None = None
) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        command(nodes, duration), capture_output=True, text=True, timeout=60, check=False
    )


def is_running(pid: int) -> bool:
    """Tell whether a process runs; one that only waits to be reaped does not."""
    try:
        state = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0]
    except (FileNotFoundError, ProcessLookupError):
        return False
    return state not in "ZX"


def all_gone(*pids: int) -> None:
    wait_until(lambda: not any(map(is_running, pids)), f"{pids} are gone")


def clean_environ(**variables: str) -> dict[str, str]:
    dropped = ("NO_COLOR", "TERM")
    kept = {name: value for name, value in os.environ.items() if name not in dropped}
    return {**kept, "TERM": "xterm", **variables}
