"""A process that has been copied, and goes on as plastron."""

from __future__ import annotations

import os
import signal
import sys
import traceback
from collections.abc import Callable, Sequence

from plastron_tui.cli.entry import run

_PATIENCE = 120
"""Seconds after which a command is ended; none takes more than one."""


def become(
    arguments: Sequence[str],
    prepare: Callable[[], object],
    leave: Callable[[], object] = lambda: None,
) -> None:
    """Run a command line in this process, and end it with its status; never return.

    Args:
        arguments: of the command line.
        prepare: gives the process its folder, its environment and its first three files.
        leave: called at the end.
    """
    status: object = 1
    try:
        signal.alarm(_PATIENCE)
        prepare()
        sys.stdin, sys.stdout, sys.stderr = (
            os.fdopen(number, mode, encoding="utf-8") for number, mode in enumerate("rww")
        )
        sys.argv = ["plastron", *arguments]
        run()
    except SystemExit as end:
        status = end.code
    except BaseException:
        traceback.print_exc()
    finally:
        sys.stdout.flush()
        sys.stderr.flush()
        leave()
        os._exit(status if isinstance(status, int) else 0)
