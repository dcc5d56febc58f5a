"""A monitor: a process beside the nodes that says what travels, and sends, calls and sets.

It runs with the Python of the nodes' ROS (`observers/monitor_ros1.py`, `observers/monitor_ros2.py`)
and speaks lines of JSON. What it says is only queued here, in threads of their own, until somebody
takes it, what is out of date left out; nothing here waits for it.
"""

from __future__ import annotations

import json
import os
import subprocess
import threading
import time
from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from .child import Guard
from .environment import Environment, with_folders
from .monitor_reports import Report, Reports
from .process_lines import News, lines_of

_OBSERVERS = Path(__file__).with_name("observers")
_LONGEST_REPORT = 1 << 20
"""Bytes of a line."""
_MOST_UNSENT = 1 << 20
_LAST_WORDS = 2.0
"""Seconds for which is waited for what an ended monitor has written of its errors."""
SILENT = 15.0
"""Seconds without a word, of a monitor that says one every second, after which it hangs.

A machine that is busy with other things keeps it waiting for some."""
SLOWEST_START = 60.0
"""Seconds that it may take until its first word: it has a middleware to start."""


@dataclass(frozen=True, slots=True)
class MonitorCommand:
    """What starts a monitor.

    Attributes:
        ros_version: the generation of ROS whose nodes it watches.
        command: the program and its arguments.
        environ: its environment variables, those of the nodes.
        nodes: the full names of the nodes of the run, by what their lines are labelled with.
    """

    ros_version: int
    command: tuple[str, ...]
    environ: Mapping[str, str]
    nodes: Mapping[str, tuple[str, ...]] = field(default_factory=dict)


def monitor_commands(
    used: Iterable[tuple[Environment, Sequence[tuple[str, Path]]]],
    environ_of: Callable[[Environment], Mapping[str, str]],
) -> tuple[MonitorCommand, ...]:
    """Return what starts the monitors of nodes, one for each generation of ROS.

    Nodes of one generation see each other whatever they are found by, and so a monitor of all of
    them needs the types of all of them.

    Args:
        used: what each node runs with, and the folders that come first in its variables.
        environ_of: returns the variables of a node that runs with an environment.
    """
    found: dict[int, tuple[Environment, list[tuple[str, Path]]]] = {}
    for environment, folders in used:
        first, known = found.get(environment.ros_version, (environment, []))
        overlays = tuple(dict.fromkeys((*first.overlays, *environment.overlays)))
        found[environment.ros_version] = replace(first, overlays=overlays), [*known, *folders]
    commands = []
    for version, (environment, folders) in found.items():
        script = _OBSERVERS / f"monitor_ros{version}.py"
        environ = with_folders(environ_of(environment), folders)
        command = (str(environment.python), str(script))
        commands.append(MonitorCommand(version, command, environ))
    return tuple(commands)


_PATHS = ("AMENT_PREFIX_PATH", "LD_LIBRARY_PATH", "PYTHONPATH", "ROS_PACKAGE_PATH")
"""Variables with folders in which types are found."""


def joined(runs: Iterable[Sequence[MonitorCommand]]) -> tuple[MonitorCommand, ...]:
    """Return what starts monitors of the nodes of several runs, which see each other.

    Args:
        runs: what starts those of each run; of two the first one's Python and variables are taken,
            with the folders of both. Which nodes they have is left out.
    """
    found: dict[int, MonitorCommand] = {}
    for each in (command for run in runs for command in run):
        first = found.setdefault(each.ros_version, each)
        folders = [
            (variable, Path(folder))
            for variable in _PATHS
            for environ in (first.environ, each.environ)
            for folder in environ.get(variable, "").split(os.pathsep)
            if folder
        ]
        environ = with_folders(first.environ, folders)
        found[each.ros_version] = replace(first, environ=environ, nodes={})
    return tuple(found.values())


def announcement(commands: Iterable[MonitorCommand]) -> str:
    """Return a line that says what starts monitors, for `announced`."""
    told = [
        {
            "ros_version": each.ros_version,
            "command": each.command,
            "environ": dict(each.environ),
            "nodes": dict(each.nodes),
        }
        for each in commands
    ]
    return json.dumps(told) + "\n"


def announced(line: str) -> tuple[MonitorCommand, ...]:
    """Read a line of `announcement`; nothing where it is none."""
    try:
        return tuple(
            MonitorCommand(
                int(each["ros_version"]),
                tuple(map(str, each["command"])),
                dict(each["environ"]),
                {str(label): tuple(map(str, names)) for label, names in each["nodes"].items()},
            )
            for each in json.loads(line)
        )
    except (ValueError, TypeError, KeyError, AttributeError):
        return ()


class Monitor:
    """A monitor that runs; it ends with the process that started it, however that ends.

    Attributes:
        ros_version: the generation of ROS whose nodes it watches.
        ended: why it ended, None as long as it runs.
    """

    def __init__(self, command: MonitorCommand, on_news: Callable[[], None]) -> None:
        """Start a monitor.

        Args:
            command: what starts it.
            on_news: called, in a thread of its own, when there are reports to take or it has
                ended; not again before `take` was called.

        Raises:
            OSError: no process can be started.
        """
        self.ros_version = command.ros_version
        self.ended: str | None = None
        self._news = News(on_news)
        self._reports = Reports()
        self._heard = time.monotonic()
        self._has_reported = False
        self._unsent = b""
        self._last_said = ""
        # It ends with its orders; what hangs, or is stopped, does not.
        self._guard = Guard()
        try:
            self._process = subprocess.Popen(
                command.command,
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=subprocess.PIPE,
                env=command.environ,
                start_new_session=True,
            )
        except OSError:
            self._guard.close()
            raise
        self._guard.note(self._process.pid)
        assert self._process.stdin is not None
        self._orders = self._process.stdin
        # One that hangs reads nothing, and must not keep who writes to it waiting.
        os.set_blocking(self._orders.fileno(), False)
        errors = threading.Thread(target=self._read_errors, daemon=True)
        errors.start()
        threading.Thread(target=self._read, args=(errors,), daemon=True).start()

    @property
    def is_silent(self) -> bool:
        """Whether it has said nothing for so long that it hangs.

        It may also be this process that was stopped, and has not read yet: twice in a row means it.
        """
        limit = SILENT if self._has_reported else SLOWEST_START
        return self.ended is None and time.monotonic() - self._heard > limit

    def take(self) -> list[Report]:
        """Return what it said since this was called last, without what is out of date."""
        self._news.taking()
        found = self._reports.take()
        if self._unsent:
            self._write()
        return found

    def order(self, **order: Any) -> bool:
        """Tell it what to do; False where it takes no orders any more."""
        if self.ended is not None or len(self._unsent) > _MOST_UNSENT:
            return False
        self._unsent += json.dumps(order).encode() + b"\n"
        return self._write()

    def close(self) -> None:
        """End it; nothing waits for that."""
        with suppress(OSError):
            self._orders.close()
        threading.Thread(target=self._end, daemon=True).start()

    def kill(self) -> None:
        """End it at once, because it hangs."""
        with suppress(OSError):
            self._process.kill()

    def _end(self) -> None:
        try:
            self._process.wait(2)
        except subprocess.TimeoutExpired:
            self.kill()

    def _write(self) -> bool:
        try:
            while self._unsent:
                written = os.write(self._orders.fileno(), self._unsent)
                self._unsent = self._unsent[written:]
        except BlockingIOError:
            return True
        except (OSError, ValueError):
            return False
        return True

    def _read(self, errors: threading.Thread) -> None:
        assert self._process.stdout is not None
        with self._process.stdout as stream:
            for line in lines_of(stream, _LONGEST_REPORT):
                self._heard = time.monotonic()
                # What is no report, a client library has printed.
                with suppress(ValueError, RecursionError):
                    report = json.loads(line)
                    if isinstance(report, dict):
                        self._has_reported = True
                        if self._reports.add(report):
                            self._news.tell()
        status = self._process.wait()
        self._guard.forget()
        self._guard.close()
        # What it said last tells why; a process of its own may hold the pipe open for longer.
        errors.join(_LAST_WORDS)
        self.ended = self._last_said or f"it ended with status {status}"
        self._news.tell_anew()

    def _read_errors(self) -> None:
        assert self._process.stderr is not None
        with self._process.stderr as stream:
            for line in lines_of(stream, _LONGEST_REPORT):
                text = line.decode("utf-8", "replace").strip()
                if text:
                    self._last_said = text
