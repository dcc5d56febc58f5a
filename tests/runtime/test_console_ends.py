"""What a run says of how a node has ended."""

from __future__ import annotations

import io
import signal

import pytest

from plastron_tui.runtime.child import Exit, Process
from plastron_tui.runtime.console import Console


@pytest.mark.parametrize(
    ("status", "last", "said"),
    [
        (-signal.SIGKILL, "[INFO] all is well", "was ended by SIGKILL"),
        (-signal.SIGKILL, "nothing to do with it", "was ended by SIGKILL"),
        (-signal.SIGABRT, "what():  no map", "was ended by SIGABRT: what():  no map"),
        (-signal.SIGSEGV, "[INFO] all is well", "was ended by SIGSEGV"),
        (1, "KeyError: 'x'", "died with exit status 1: KeyError: 'x'"),
        (1, "[ERROR] no map", "died with exit status 1: [ERROR] no map"),
        (1, "[INFO] [1.5] [a]: all is well", "died with exit status 1"),
    ],
)
def test_the_last_line_is_told_where_it_may_be_the_cause(status: int, last: str, said: str) -> None:
    err = io.StringIO()
    console = Console(["guard"], io.StringIO(), err, environ={})
    console.ended(Exit(Process("guard", ("x",)), status, last_lines=("first", last)))
    assert err.getvalue() == f"plastron | guard {said}\n"
