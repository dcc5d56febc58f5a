"""What becomes of a command whose output nobody takes: statuses that are documented, no other.

A terminal that is closed answers every write with EIO, a pipe to what has ended with EPIPE, a
full disk with ENOSPC. Python itself would end with 120 where it cannot write what is left.
"""

from __future__ import annotations

import os
import pty
import signal
import subprocess
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path

import pytest
from command_line import BROKEN, PLASTRON, TALKER
from machine import mostly_long

HUNG_UP = 128 + signal.SIGHUP

RIGHT, WRONG = 0, 1
COMMANDS = {
    "--help": RIGHT,
    "--version": RIGHT,
    "types --help": RIGHT,
    "types -d jazzy": RIGHT,
    "completion bash": RIGHT,
    "graph right.plastron": RIGHT,
    "graph wrong.plastron": WRONG,
    "generate --diff right.plastron": RIGHT,
    "shell": WRONG,
    "check --format json wrong.plastron": WRONG,
}
"""Commands that print something, with their status."""

ERRORS_ONLY = {"check wrong.plastron": WRONG, "check nothing.plastron": 2, "nonsense": 2, "fmt": 2}
"""Commands that print to standard error only."""

QUICK = {"--help", "graph right.plastron", "shell", "check wrong.plastron"}


def each(commands: dict[str, int]) -> pytest.MarkDecorator:
    """Try each of the commands, in the quick suite some."""
    return pytest.mark.parametrize("command", mostly_long(commands, QUICK & commands.keys()))


@contextmanager
def nobody(kind: str) -> Iterator[int]:
    """Open what nobody reads from: the write end of a pipe, a terminal, a full device."""
    if kind == "full":
        end = os.open("/dev/full", os.O_WRONLY)
    else:
        reader, end = os.pipe() if kind == "pipe" else pty.openpty()
        os.close(reader)
    yield end
    os.close(end)


def status_of(here: Path, command: str, out: str | None, err: str | None) -> tuple[int, str]:
    """Run a command with its output going to nobody; return its status and its last words."""
    (here / "right.plastron").write_text(TALKER)
    (here / "wrong.plastron").write_text(BROKEN)
    said = here / "said"
    with ExitStack() as stack:
        errors = stack.enter_context(said.open("wb"))
        # One descriptor where both go to the same, as `2>&1` has it.
        ends = {kind: stack.enter_context(nobody(kind)) for kind in {out, err} if kind is not None}
        process = subprocess.Popen(
            [*PLASTRON, *command.split()],
            cwd=here,
            stdin=subprocess.PIPE,
            stdout=subprocess.DEVNULL if out is None else ends[out],
            stderr=errors if err is None else ends[err],
        )
        process.communicate(b"help\nnonsense\n", timeout=60)
    text = said.read_text()
    assert "Traceback" not in text
    assert "Exception ignored" not in text
    return process.returncode, text


@pytest.mark.parametrize("both", [False, True])
@each(COMMANDS)
def test_a_full_disk_under_the_result_is_2(here: Path, command: str, both: bool) -> None:
    status, said = status_of(here, command, "full", "full" if both else None)
    assert status == 2
    assert both or "error: no space left on device" in said


@pytest.mark.parametrize("kind", ["full", "pipe", "terminal"])
@each(ERRORS_ONLY)
def test_diagnostics_that_nobody_takes_leave_a_status(here: Path, command: str, kind: str) -> None:
    status, _ = status_of(here, command, None, kind)
    assert status in {"full": [2], "pipe": [0, ERRORS_ONLY[command]], "terminal": [HUNG_UP]}[kind]


@pytest.mark.parametrize("both", [False, True])
@each(COMMANDS)
def test_a_reader_that_leaves_is_no_error(here: Path, command: str, both: bool) -> None:
    status, said = status_of(here, command, "pipe", "pipe" if both else None)
    assert status in (0, COMMANDS[command])
    assert "error: " not in said


@each(COMMANDS)
def test_a_terminal_that_is_gone_has_the_status_of_its_signal(here: Path, command: str) -> None:
    assert status_of(here, command, "terminal", "terminal") == (HUNG_UP, "")
