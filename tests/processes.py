"""Processes of a test: nodes and probes, each stopped by its own id."""

from __future__ import annotations

import re
import shutil
import signal
import subprocess
import sys
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from threading import Lock

from command_line import Copies
from machine import wait_until

PROGRAMS = Path(__file__).with_name("programs")
PLASTRON = Path(sys.executable).with_name("plastron")

# rospy closes its topics before `is_shutdown` says so: a timer or a callback whose turn it is in
# between publishes to a closed topic, in a thread of rospy's own (`rospy.impl.registration`,
# `cleanup`). Its server may likewise begin to accept when its socket is closed already
# (`tcpros_base`). What a timer's thread says is cut off where the process ends meanwhile.
CLOSED_BY_ROSPY = re.compile(
    r"(?:Exception in thread |bad callback: )(?:(?!Exception in thread|bad callback: ).)*?"
    r"(?:rospy\.exceptions\.ROSException: (?:publish\(\) to a closed topic"
    r"|topic was closed during publish\(\))\n"
    r"|self\.server_sock\.accept\(\)(?:(?!Exception in thread).)*?OSError: \[Errno 9\][^\n]*\n"
    r"|\nTraceback[^\n]*(?:\n [^\n]*)*\n?\Z)",
    re.DOTALL,
)

# Python goes on behind what a signal breaks off in a destructor of rclpy's own, and says so.
BROKEN_OFF = re.compile(
    r"^Exception ignored in: .*\nTraceback .*\n(?: .*\n|\n)*"
    # What Ctrl-C has kept from being made lacks its parts.
    r"(?:KeyboardInterrupt|AttributeError: '\w+' object has no attribute).*\n",
    re.MULTILINE,
)

# rclpy asks whether a context is shut down and then shuts it down, while the thread that it keeps
# for signals does the same (`rclpy.context`, `try_shutdown`).
SHUT_DOWN_TWICE = re.compile(
    r"^Traceback .*\n(?: .*\n)+.*RCLError: failed to shutdown: rcl_shutdown already called.*\n",
    re.MULTILINE,
)


def own_tracebacks(output: str) -> list[str]:
    """Return the lines that begin a traceback which is not rospy's or rclpy's own."""
    left = CLOSED_BY_ROSPY.sub("", output)
    for pattern in (BROKEN_OFF, SHUT_DOWN_TWICE):
        left = pattern.sub("", left)
    return [line for line in left.splitlines() if "Traceback" in line]


_copies: list[Copies] = []
_one_at_a_time = Lock()


def use_copies(copies: Copies) -> None:
    """Let `plastron` be a copy of a process that has its modules, from here on.

    To read them takes five times as long as to generate a node.
    """
    _copies[:] = [copies]


def plastron(*arguments: str | Path) -> subprocess.CompletedProcess[str]:
    """Run plastron in the working folder and the environment of this process."""
    given = list(map(str, arguments))
    if _copies:
        # Some tests run the nodes of both libraries in threads of their own.
        with _one_at_a_time:
            done = _copies[0].run(given, Path.cwd(), b"", {}, is_debian=False)
        out, err = done.stdout.decode(), done.stderr.decode()
        return subprocess.CompletedProcess(done.args, done.returncode, out, err)
    command = [str(PLASTRON), *given]
    return subprocess.run(command, capture_output=True, text=True, timeout=120, check=False)


def generate(program: str, output: Path, target: str) -> dict[str, Path]:
    """Generate a program, and return all nodes of the output folder by their names.

    The program is one of `tests/programs`, or a path; both without `.plastron`.
    """
    file = PROGRAMS / f"{program}.plastron"
    done = plastron("generate", file, "-o", output, "--target", target)
    assert done.returncode == 0, done.stdout + done.stderr
    return {file.name: file for file in sorted(output.glob("*.py"))}


def generate_one(program: str, output: Path, target: str) -> Path:
    """Generate a program that has one node, and return its file."""
    [file] = generate(program, output, target).values()
    return file


def edit(
    original: Path,
    statements: str,
    folder: Path,
    *,
    node: str | None = None,
    using: str | None = None,
) -> Path:
    """Change the node of a file, in a folder; return the new file. The old one stays as it is.

    Args:
        original: the file.
        statements: what the program says of `node`, one statement a line.
        folder: gets a copy of the file, the program, and the new file.
        node: which of the file's nodes.
        using: the client library that the new file is for, if it is another.
    """
    loaded = folder / original.name
    shutil.copy(original, loaded)
    program = loaded.with_suffix(".plastron")
    which = f" node '{node}'" if node else ""
    library = f" using {using}" if using else ""
    program.write_text(
        f"load '{original.name}'{which} as node\n{statements}generate_node node{library}\n"
    )
    done = plastron("generate", program, "-o", folder / "output")
    assert done.returncode == 0, done.stdout + done.stderr
    assert loaded.read_bytes() == original.read_bytes()
    return folder / "output" / original.name


class Process:
    """A process, and what it has printed so far."""

    def __init__(self, command: Sequence[str | Path], env: Mapping[str, str], log: Path) -> None:
        self._log = log
        with log.open("wb") as stream:
            self._popen = subprocess.Popen(
                [str(part) for part in command],
                env=dict(env),
                stdin=subprocess.DEVNULL,
                stdout=stream,
                stderr=subprocess.STDOUT,
                start_new_session=True,
            )

    @property
    def pid(self) -> int:
        """Its process id."""
        return self._popen.pid

    @property
    def output(self) -> str:
        """What the process has printed."""
        return self._log.read_text(encoding="utf-8", errors="replace")

    def wait(self, seconds: float) -> int:
        """Wait until it ends by itself, and return its exit status."""
        return self._popen.wait(seconds)

    def wait_to_print(self, text: str, seconds: float = 60.0, count: int = 1) -> None:
        """Wait until it has printed a text, so often."""

        def look() -> bool:
            has_ended = self._popen.poll() is not None
            if self.output.count(text) >= count:
                return True
            assert not has_ended, f"it ended without {text!r}"
            return False

        try:
            wait_until(look, repr(text), seconds)
        except AssertionError as error:
            raise AssertionError(f"{error}, in:\n{self.output}") from None

    def interrupt(self, seconds: float = 60.0) -> int:
        """End it as Ctrl-C does, and return its exit status."""
        if self._popen.poll() is None:
            self._popen.send_signal(signal.SIGINT)
            try:
                self._popen.wait(seconds)
            except subprocess.TimeoutExpired:
                self._popen.kill()
                self._popen.wait()
                raise AssertionError(
                    f"still there {seconds} s after Ctrl-C:\n{self.output}"
                ) from None
        return self._popen.returncode

    def send(self, signum: int) -> None:
        """Send it a signal, and do not wait."""
        self._popen.send_signal(signum)

    def kill(self) -> None:
        """End it at once, however it is."""
        if self._popen.poll() is None:
            self._popen.kill()
            self._popen.wait()


@contextmanager
def processes() -> Iterator[list[Process]]:
    """Give a list for processes, all of which are ended at the end."""
    started: list[Process] = []
    try:
        yield started
    finally:
        for process in reversed(started):
            process.kill()
