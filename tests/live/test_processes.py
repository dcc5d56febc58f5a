"""Which tracebacks in the output of a node are not rospy's own, and when a node has ended."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest
from processes import Process, own_tracebacks

CALL = """\
  File "talker.py", line 3, in publish
    self.talker.publish(message)
"""
TRACEBACK = "Traceback (most recent call last):\n" + CALL
CLOSED = "rospy.exceptions.ROSException: publish() to a closed topic\n"
TWICE = (
    "rclpy._rclpy_pybind11.RCLError: failed to shutdown: rcl_shutdown already called on the given "
    "context, at ./src/rcl/init.c:333\n"
)

BROKEN_OFF = (
    "Exception ignored in: <function Future.__del__ at 0x7f00>\n"
    "Traceback (most recent call last):\n"
    '  File "rclpy/task.py", line 63, in __del__\n    def __del__(self) -> None:\n\n{}: \n'
)

OUTPUTS = {
    "a destructor": (BROKEN_OFF.format("KeyboardInterrupt"), 0),
    "a destructor of what was not made": (
        BROKEN_OFF.format("AttributeError: 'Task' object has no attribute '_exception'"),
        0,
    ),
    "a destructor's own": (BROKEN_OFF.format("ValueError"), 1),
    "the node's own behind a destructor's": (
        BROKEN_OFF.format("KeyboardInterrupt") + TRACEBACK + "ValueError: 3\n",
        1,
    ),
    "a context that is shut down twice": (TRACEBACK + TWICE, 0),
    "the node's own before it is shut down twice": (
        TRACEBACK + "ValueError: 3\n" + TRACEBACK + TWICE,
        1,
    ),
    "nothing": ("ready\n", 0),
    "the node's own": (TRACEBACK + "ValueError: 3\n", 1),
    "a thread": ("Exception in thread Thread-5:\n" + TRACEBACK + CLOSED, 0),
    "a callback": ("bad callback: <bound method>\n" + TRACEBACK + CLOSED, 0),
    "cut off": ("Exception in thread Thread-5:\n" + TRACEBACK, 0),
    "not cut off": ("Exception in thread Thread-5:\n" + TRACEBACK + "ValueError: 3\n", 1),
    "the node's own behind a thread's": (
        "Exception in thread Thread-5:\n" + TRACEBACK + CLOSED + TRACEBACK + "ValueError: 3\n",
        1,
    ),
}


@pytest.mark.parametrize(("output", "count"), OUTPUTS.values(), ids=OUTPUTS)
def test_tracebacks_of_a_node(output: str, count: int) -> None:
    assert len(own_tracebacks(output)) == count


def test_a_long_traceback_is_told_at_once() -> None:
    """In a process of its own: a pattern that does not end cannot be stopped in this one."""
    output = "bad callback: <bound method>\n" + TRACEBACK + CALL * 20 + "ValueError: 3\n"
    code = (
        "import sys\n"
        "from processes import own_tracebacks\n"
        "print(len(own_tracebacks(sys.stdin.read())))"
    )
    done = subprocess.run(
        [sys.executable, "-c", code],
        input=output,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)},
        capture_output=True,
        text=True,
        timeout=60,
    )
    assert done.stdout == "1\n", done.stderr


def test_nobody_waits_for_what_a_process_that_ended_would_print(tmp_path: Path) -> None:
    process = Process([sys.executable, "-c", "print('ready')"], os.environ, tmp_path / "log")
    process.wait_to_print("ready")
    with pytest.raises(AssertionError, match="it ended without 'set up', in:\nready"):
        process.wait_to_print("set up")
