"""A ROS to run programs with, in a graph of the test's own."""

from __future__ import annotations

import os
import random
import signal
import socket
import subprocess
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import pytest
from command_line import PLASTRON

from plastron_tui.runtime.environment import find_environments

PROGRAM = """\
create_node 'talker' as talker
create_message hello of message_type String and input "hello"
talker publish hello to 'chatter' of message_type String at 20 hz
generate_node talker
create_node 'listener' as listener
subscribe listener to 'chatter' of message_type String
generate_node listener
create_node 'switcher' as switcher
switcher provides_service 'switch' of service_type SetBool
generate_node switcher
create_node 'asker' as asker
asker client_requests 'switch' of service_type SetBool with input True
subscribe asker to 'chatter' of message_type String
generate_node asker
"""


@dataclass(frozen=True)
class Ros:
    """Runs plastron in a folder, with one generation of ROS."""

    library: str
    folder: Path
    environ: dict[str, str]

    @property
    def version(self) -> str:
        return "1" if self.library == "rospy" else "2"

    def write(self, name: str, text: str) -> Path:
        path = self.folder / name
        path.write_text(text)
        return path

    def plastron(self, *arguments: str, limit: float = 90) -> subprocess.CompletedProcess[str]:
        done = subprocess.run(
            [*PLASTRON, *arguments],
            cwd=self.folder,
            env=self.environ,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            timeout=limit,
        )
        # What a node prints is behind the label of the run.
        assert "\nTraceback" not in f"\n{done.stderr}", done.stderr
        return done

    def run(self, file: str, *arguments: str) -> subprocess.CompletedProcess[str]:
        return self.plastron("run", file, *arguments, "--target", self.library)

    @contextmanager
    def running(self, file: str, *arguments: str) -> Iterator[subprocess.Popen[bytes]]:
        """Run a program beside the test, and interrupt it at the end."""
        log = self.folder / f"{file}.log"
        with log.open("wb") as stream:
            process = subprocess.Popen(
                [*PLASTRON, "run", file, "--target", self.library, *arguments],
                cwd=self.folder,
                env=self.environ,
                stdin=subprocess.DEVNULL,
                stdout=stream,
                stderr=stream,
            )
        try:
            yield process
        finally:
            process.send_signal(signal.SIGINT)
            assert process.wait(30) == 128 + signal.SIGINT, log.read_text()

    def processes(self) -> list[int]:
        """Return the processes whose command line names this folder."""
        found = []
        for path in Path("/proc").glob("[0-9]*/cmdline"):
            try:
                command = path.read_bytes()
            except OSError:
                continue
            if os.fsencode(self.folder) in command:
                found.append(int(path.parent.name))
        return found


def make_ros(library: str, folder: Path) -> Ros:
    """Make the environment of a graph, or skip: in CI, where both have to be there, fail."""
    environment, diagnostics = find_environments().choose(1 if library == "rospy" else 2)
    if environment is None:
        reason = "; ".join(f"{one.message}: {one.help}" for one in diagnostics)
        if os.environ.get("CI") or os.environ.get("PLASTRON_REQUIRE_ROS"):
            pytest.fail(reason)
        pytest.skip(reason)
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = probe.getsockname()[1]
    environ = {
        **os.environ,
        "ROS_HOME": str(folder / "ros"),
        "ROS_LOG_DIR": str(folder / "ros" / "log"),
        "ROS_MASTER_URI": f"http://127.0.0.1:{port}",
        "ROS_DOMAIN_ID": str(random.randint(1, 100)),
    }
    return Ros(library, folder, environ)


def wait_until(condition: Callable[[], object], what: str, limit: float = 40.0) -> None:
    deadline = time.monotonic() + limit
    while not condition():
        assert time.monotonic() < deadline, f"not in time: {what}"
        time.sleep(0.05)


def said_by(output: str, name: str) -> list[str]:
    """Return what a node printed."""
    lines = [line.partition("|") for line in output.splitlines()]
    return [text.strip() for label, bar, text in lines if bar and label.strip() == name]
