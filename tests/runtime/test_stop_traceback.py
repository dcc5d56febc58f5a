"""The traceback of a node that was told to stop is folded, any other one is shown."""

from __future__ import annotations

import sys

import pytest
from hypothesis import given
from hypothesis import strategies as some

from plastron_tui.runtime.child import Process
from plastron_tui.runtime.stop_traceback import STOPPED, StopTracebacks
from plastron_tui.runtime.supervisor import Supervisor

BEGIN = ["Traceback (most recent call last):", '  File "a.py", line 3, in main', "    spin(node)"]
STOP = [*BEGIN, "KeyboardInterrupt"]
OTHER = [*BEGIN, "ValueError: no"]
DURING = ["", "During handling of the above exception, another exception occurred:", ""]


def told(lines: list[str]) -> list[str]:
    tracebacks = StopTracebacks()
    return [*tracebacks.without(lines), *tracebacks.rest()]


@pytest.mark.parametrize(
    ("lines", "shown"),
    [
        (STOP, [STOPPED]),
        (["a", *STOP, "", "b"], ["a", STOPPED, "b"]),
        ([*BEGIN, "rclpy.executors.ExternalShutdownException"], [STOPPED]),
        ([*STOP[:-1], "KeyboardInterrupt: on line 3"], [STOPPED]),
        ([*STOP, *STOP], [STOPPED]),
        ([*STOP, *DURING, *STOP], [STOPPED]),
        ([*OTHER, "a"], [*OTHER, "a"]),
        ([*STOP, *DURING, *OTHER], [*STOP, *DURING, *OTHER]),
        ([*BEGIN, "[INFO] spinning"], [*BEGIN, "[INFO] spinning"]),
        (BEGIN, BEGIN),
        (["KeyboardInterrupt", "", "  a"], ["KeyboardInterrupt", "", "  a"]),
    ],
)
def test_only_the_traceback_of_a_stop_is_folded(lines: list[str], shown: list[str]) -> None:
    assert told(lines) == shown


@given(some.lists(some.sampled_from([*OTHER, *DURING, "a"])))
def test_what_has_no_stop_in_it_is_shown_as_it_is(lines: list[str]) -> None:
    assert told(lines) == lines


NODE = """
import time
print("up", flush=True)
def main():
    time.sleep(600)
main()
"""


def test_a_node_that_is_stopped_prints_no_traceback() -> None:
    lines: list[str] = []
    with Supervisor(lambda process, line: lines.append(line)) as supervisor:
        supervisor.start(Process("node", (sys.executable, "-c", NODE)))
        assert supervisor.wait_for(lambda: lines == ["up"], 60)
    assert lines == ["up", STOPPED]
