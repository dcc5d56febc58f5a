"""Runs attacks one after the other, each in a process of its own with little memory and time.

Started as a program, it forks for each line of standard input, which is an attack as JSON. The
answer is a line as well. A warm-up runs in the process that forks, so that what it imports and
reads is there for every attack.
"""

from __future__ import annotations

import json
import os
import resource
import signal
import sys
import time
import traceback
from collections.abc import Mapping
from contextlib import redirect_stderr, redirect_stdout
from io import StringIO
from pathlib import Path
from typing import Any

MEMORY = 1024**3
"""The most address space of an attacked process, in bytes; an idle one has a fifth of it."""

PROCESSOR = 40
"""The most seconds of processor time; most of what is attacked needs one, the slowest 15."""

PATIENCE = 300
"""Seconds after which a process that does nothing is taken for one that waits for ever."""


def main() -> None:
    """Answer each attack with what became of it."""
    for line in sys.stdin:
        attack = json.loads(line)
        if attack.get("is_warm_up"):
            with redirect_stdout(StringIO()), redirect_stderr(StringIO()):
                os.chdir(attack["folder"])
                os.environ.update(attack["environ"])
                answer = {"status": _run(attack)}
        else:
            answer = _attack(attack)
        print(json.dumps(answer), flush=True)


def _attack(attack: Mapping[str, Any]) -> dict[str, Any]:
    folder = Path(attack["folder"])
    out, err = folder.parent / f"{folder.name}.out", folder.parent / f"{folder.name}.err"
    child = os.fork()
    if child == 0:
        _become(attack, out, err)
    status = _wait(child)
    return {
        "status": status,
        "out": out.read_text("utf-8", "replace"),
        "err": err.read_text("utf-8", "replace"),
    }


def _wait(child: int) -> int | None:
    """Return the exit status, negative for a signal, None for a process that went on for ever."""
    deadline = time.monotonic() + PATIENCE
    pause = 0.001
    while True:
        found, status = os.waitpid(child, os.WNOHANG)
        if found:
            return os.waitstatus_to_exitcode(status)
        if time.monotonic() > deadline:
            os.kill(child, signal.SIGKILL)
            os.waitpid(child, 0)
            return None
        time.sleep(pause)
        pause = min(pause * 2, 0.05)


def _become(attack: Mapping[str, Any], out: Path, err: Path) -> None:
    """Run a command line, or Python, in the folder; never return."""
    status = 99
    try:
        os.chdir(attack["folder"])
        os.environ.update(attack["environ"])
        for number, file in ((1, out), (2, err)):
            os.dup2(os.open(file, os.O_WRONLY | os.O_CREAT | os.O_TRUNC, 0o600), number)
        os.dup2(os.open(os.devnull, os.O_RDONLY), 0)
        resource.setrlimit(resource.RLIMIT_CPU, (PROCESSOR, PROCESSOR))
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
        status = _run(attack)
        sys.stdout.flush()
        sys.stderr.flush()
    except BaseException:
        traceback.print_exc()
    finally:
        os._exit(status)


def _run(attack: Mapping[str, Any]) -> int:
    if "python" in attack:
        exec(attack["python"], {"__name__": "attack"})
        return 0
    from plastron_tui.cli import main as command_line

    sys.argv = ["plastron", *attack["arguments"]]
    try:
        command_line()
    except SystemExit as end:
        return end.code if isinstance(end.code, int) else 0
    return 0


if __name__ == "__main__":
    main()
