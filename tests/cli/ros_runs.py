"""A ROS to run programs with, in a graph of the test's own."""

from __future__ import annotations

import os
import signal
import subprocess
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from command_line import PLASTRON
from machine import find_ros, graph_environ, wait_until

STOPPED = 128 + signal.SIGINT


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

    def run_until(
        self, said: Callable[[str], object], file: str, *arguments: str, status: int = STOPPED
    ) -> str:
        """Run a program until something is said, interrupt it, and return all that was said."""
        with self.running(file, *arguments, status=status) as run:
            # What is built first takes half a minute of a processor's time.
            wait_until(lambda: run.poll() is not None or said(self.said(file)), "it is said", 300)
        return self.said(file)

    def said(self, file: str) -> str:
        """Return what a program that is `running` has said, with what is said of it."""
        return self._log(file).read_text()

    def _log(self, file: str) -> Path:
        return self.folder / f"{file}.log"

    @contextmanager
    def running(
        self, file: str, *arguments: str, status: int = STOPPED
    ) -> Iterator[subprocess.Popen[bytes]]:
        """Run a program beside the test, and interrupt it at the end."""
        with self._log(file).open("wb") as stream:
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
            assert process.wait(60) == status, self.said(file)

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
    """Make the environment of a graph; without a ROS there is no test."""
    find_ros(1 if library == "rospy" else 2)
    return Ros(library, folder, graph_environ(folder))


def said_by(output: str, name: str) -> list[str]:
    """Return what a node printed."""
    lines = [line.partition("|") for line in output.splitlines()]
    return [text.strip() for label, bar, text in lines if bar and label.strip() == name]
