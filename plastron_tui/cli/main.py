"""Where the command line starts and ends.

A program that is opened in the studio is by far the most common way to start: it needs none of
the rest, which takes a tenth of the time.
"""

from __future__ import annotations

import gc
import os
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import TextIO

UNREADABLE = 2
INTERRUPTED = 130


def main() -> None:
    """Run the command line, and exit with its status.

    0: done; 1: a program or a file has errors; 2: wrong usage, or a file that cannot be read or
    written; 130: interrupted.
    """
    _open_closed_streams()
    if hasattr(sys.stdout, "reconfigure"):
        # Whatever the terminal's encoding is, a result is written; a file name need be no text.
        sys.stdout.reconfigure(errors="backslashreplace")
    arguments = sys.argv[1:]
    try:
        status = _open_studio(arguments) if _is_for_studio(arguments) else _run_command()
        sys.stdout.flush()
    except KeyboardInterrupt:
        status = INTERRUPTED
    except OSError as error:
        # What the commands do not expect: a full disk under standard output, a folder that is gone.
        discard(sys.stdout)
        what = (error.strerror or str(error)).lower()
        place = "" if error.filename is None else f"`{error.filename}`: "
        print(f"error: {place}{what}", file=sys.stderr)
        status = UNREADABLE
    # Python would look for cycles among all that is left, which the system is about to take.
    gc.freeze()
    sys.exit(status if isinstance(status, int) else 0)


def _open_closed_streams() -> None:
    """Let what goes to a stream that was closed (`>&-`) go nowhere.

    Files that are opened later would take its number, and get what is written to it.
    """
    for name, mode in (("stdin", "r"), ("stdout", "w"), ("stderr", "w")):
        if getattr(sys, name) is None:
            setattr(sys, name, Path(os.devnull).open(mode))  # noqa: SIM115


def _run_command() -> object:
    import click

    from .group import cli

    try:
        return cli.main(prog_name="plastron", standalone_mode=False)
    except click.exceptions.Abort:
        return INTERRUPTED
    except click.ClickException as error:
        error.show()
        return error.exit_code


def _is_for_studio(arguments: Sequence[str]) -> bool:
    """Tell whether the arguments are those of `plastron [FILE]`, with nothing to refuse or say."""
    if "_PLASTRON_COMPLETE" in os.environ or not has_terminal():
        return False
    if not arguments:
        return True
    name = arguments[0]
    is_program = name.endswith(".plastron") and not name.startswith("-")
    return is_program and len(arguments) == 1 and not Path(name).is_dir()


def _open_studio(arguments: Sequence[str]) -> int:
    # There is nothing to collect until the screen is there, which then says so.
    gc.disable()
    from plastron_tui.studio.app import run

    return run(Path(arguments[0]) if arguments else None)


def has_terminal() -> bool:
    """Tell whether a person sits at both ends."""
    return all(stream is not None and stream.isatty() for stream in (sys.stdin, sys.stdout))


def discard(stream: TextIO) -> None:
    """Let what is left in a stream go nowhere: Python would fail again when it exits."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())
