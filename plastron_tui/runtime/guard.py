"""A process that outlives its supervisor, to stop what the supervisor left behind.

It is run as a file, with nothing but the standard library, in a session of its own, so that
neither Ctrl-C nor a closed terminal reaches it. Its standard input is a pipe whose only writing
end is the supervisor's: however the supervisor ends, `kill -9` and a crash included, the pipe
ends too, and every process group that is still noted is stopped.

A line `+12` notes the process group 12, `-12` takes it off, `-` takes off the last one noted.
The parent-death signal of Linux would be less: it reaches a node but not the processes that
the node started, and gives the node no time to end well.
"""

from __future__ import annotations

import contextlib
import os
import signal
import sys
import time

# What a group is sent, and how long it may take then, in seconds.
_STEPS = ((signal.SIGINT, 1.5), (signal.SIGTERM, 0.5), (signal.SIGKILL, 0.5))


def command() -> list[str]:
    """Return the command that starts the guard, in a Python that looks for modules nowhere else."""
    return [sys.executable, "-I", "-S", __file__]


def _is_there(group: int) -> bool:
    try:
        os.killpg(group, 0)
    except (ProcessLookupError, PermissionError):
        return False
    return True


def _stop(groups: set[int]) -> None:
    for signum, limit in _STEPS:
        for group in groups:
            with contextlib.suppress(ProcessLookupError, PermissionError):
                os.killpg(group, signum)
        deadline = time.monotonic() + limit
        while groups and time.monotonic() < deadline:
            groups = {group for group in groups if _is_there(group)}
            time.sleep(0.02)


def main() -> None:
    """Note process groups until the supervisor is gone, then stop those that are left."""
    for signum in (signal.SIGINT, signal.SIGHUP, signal.SIGTERM):
        signal.signal(signum, signal.SIG_IGN)
    groups: list[int] = []
    for line in sys.stdin.buffer:
        word = line.strip()
        if word.startswith(b"+"):
            groups.append(int(word[1:]))
        elif word == b"-":
            del groups[-1:]
        elif int(word[1:]) in groups:
            groups.remove(int(word[1:]))
    _stop(set(groups))


if __name__ == "__main__":
    main()
