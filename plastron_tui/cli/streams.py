"""The standard streams: closed before the start, full, or with nobody at the other end."""

from __future__ import annotations

import errno
import os
import signal
import stat
import sys
from contextlib import suppress
from pathlib import Path
from typing import TextIO

UNREADABLE = 2
HUNG_UP = 128 + signal.SIGHUP


def open_closed_streams() -> None:
    """Let what goes to a stream that was closed (`>&-`) go nowhere.

    Files that are opened later would take its number, and get what is written to it.
    """
    for name, mode in (("stdin", "r"), ("stdout", "w"), ("stderr", "w")):
        if getattr(sys, name) is None:
            setattr(sys, name, Path(os.devnull).open(mode))  # noqa: SIM115


def has_terminal() -> bool:
    """Tell whether a person sits at both ends."""
    return all(stream is not None and stream.isatty() for stream in (sys.stdin, sys.stdout))


def guard_terminals() -> None:
    """Let nothing pass to a terminal that it would obey, whoever writes it."""
    streams = {name: getattr(sys, name) for name in ("stdout", "stderr")}
    if not any(stream.isatty() for stream in streams.values()):
        return
    from plastron_tui.diagnostics.terminal import EscapingStream

    for name, stream in streams.items():
        if stream.isatty():
            setattr(sys, name, EscapingStream(stream))


def status_after(error: OSError, status: int = 0) -> int:
    """Say what the commands do not expect, and return the exit status.

    Args:
        error: a full disk under standard output, a folder that is gone.
        status: that of a command whose reader has left, which is no error.
    """
    if error.errno == errno.EPIPE:
        return status
    if error.errno == errno.EIO and any(map(_is_device, (sys.stdout, sys.stderr))):
        # The terminal was closed, which here nothing else has said.
        return HUNG_UP
    from plastron_tui.diagnostics.terminal import visible
    from plastron_tui.regular_files import reason

    what = reason(error)
    place = "" if error.filename is None else f"`{error.filename}`: "
    with suppress(OSError):
        print(visible(f"error: {place}{what}"), file=sys.stderr)
    return UNREADABLE


def flush_streams(status: int) -> int:
    """Write what is left, and return the exit status; Python's own would be 120 for a failure."""
    return _flush(sys.stderr, _flush(sys.stdout, status))


def _flush(stream: TextIO, status: int) -> int:
    try:
        stream.flush()
    except OSError as error:
        discard(stream)
        return status_after(error, status)
    return status


def discard(stream: TextIO) -> None:
    """Let what is left in a stream go nowhere: Python would fail again when it exits."""
    nowhere = os.open(os.devnull, os.O_WRONLY)
    os.dup2(nowhere, stream.fileno())
    os.close(nowhere)


def _is_device(stream: TextIO) -> bool:
    # A terminal that was closed no longer says that it is one.
    with suppress(OSError, ValueError):
        return stat.S_ISCHR(os.fstat(stream.fileno()).st_mode)
    return False
