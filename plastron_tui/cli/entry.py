"""Where the command line starts and ends.

A program that is opened in the studio is by far the most common way to start: it needs none of
the rest, which takes a tenth of the time.
"""

from __future__ import annotations

import io
import os
import sys
from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path

from plastron_tui import collector

from .streams import (
    discard,
    flush_streams,
    guard_terminals,
    has_terminal,
    open_closed_streams,
    status_after,
)

INTERRUPTED = 130


def run() -> None:
    """Run the command line in this process, and exit with its status.

    0: done; 1: a program or a file has errors; 2: wrong usage, or a file that cannot be read or
    written; 130: interrupted; 129, 143: ended because its terminal was closed, or by SIGTERM.
    """
    open_closed_streams()
    if hasattr(sys.stdout, "reconfigure"):
        # Whatever the terminal's encoding is, a result is written; a file name need be no text.
        sys.stdout.reconfigure(errors="backslashreplace")
    guard_terminals()
    arguments = sys.argv[1:]
    try:
        status = _open_studio(arguments) if _is_for_studio(arguments) else _run_command()
    except KeyboardInterrupt:
        status = INTERRUPTED
    except OSError as error:
        discard(sys.stdout)
        status = status_after(error)
    status = flush_streams(status if isinstance(status, int) else 0)
    collector.spare()
    sys.exit(status)


def _run_command() -> object:
    import click

    from .group import cli

    try:
        return cli.main(prog_name="plastron", standalone_mode=False)
    except click.exceptions.Abort:
        return INTERRUPTED
    except click.ClickException as error:
        from plastron_tui.diagnostics.terminal import visible_text

        # It quotes arguments as they are.
        said = io.StringIO()
        error.show(said)
        with suppress(BrokenPipeError):
            click.echo(visible_text(said.getvalue()), err=True, nl=False)
        return error.exit_code


def _is_for_studio(arguments: Sequence[str]) -> bool:
    """Tell whether the arguments are those of `plastron [FILE]...`, nothing to refuse or say."""
    if "_PLASTRON_COMPLETE" in os.environ or not has_terminal():
        return False
    return all(
        name.endswith(".plastron") and not name.startswith("-") and not Path(name).is_dir()
        for name in arguments
    )


def _open_studio(arguments: Sequence[str]) -> int:
    from plastron_tui.studio.app import run as run_studio

    paths = [*map(Path, arguments)]
    return run_studio(paths[0] if paths else None, others=paths[1:])
