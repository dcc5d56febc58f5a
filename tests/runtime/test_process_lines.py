"""Lines of a process, and the word that there are some."""

from __future__ import annotations

import io
import os
import signal
import subprocess
import sys

import pytest
from hypothesis import given
from hypothesis import strategies as some

from plastron_tui.runtime.child import Guard
from plastron_tui.runtime.process_lines import Backlog, News, lines_of


@pytest.mark.parametrize(
    ("written", "lines"),
    [
        (b"", []),
        (b"a\nb", [b"a", b"b"]),
        (b"a\r\n\n", [b"a", b""]),
        # Of a line that does not end the first bytes are enough.
        (b"0123456789\nb\n", [b"01234567", b"b"]),
        (b"01234567\nb\n", [b"01234567", b"b"]),
        (b"0123456789" * 3, [b"01234567"]),
    ],
)
def test_lines_come_without_their_ends(written: bytes, lines: list[bytes]) -> None:
    assert list(lines_of(io.BytesIO(written), 8)) == lines


def test_somebody_is_told_once_until_he_takes() -> None:
    told: list[int] = []
    news = News(lambda: told.append(1))
    news.tell()
    news.tell()
    assert len(told) == 1
    news.tell_anew()
    assert len(told) == 2
    news.taking()
    news.tell()
    assert len(told) == 3


def backlog() -> Backlog:
    return Backlog(
        most_lines=6, most_bytes=60, at_once=50, is_kept=lambda line: line.startswith(b"own")
    )


def test_what_comes_too_fast_is_left_out_but_for_what_the_run_says() -> None:
    waiting = backlog()
    for number in range(4):
        waiting.add(b"own %d" % number)
        waiting.add(b"a%d" % number)
    # Each is as long as some bytes more: few are taken at once.
    assert waiting.take() == ["… 1 line left out".encode(), b"own 0", b"own 1", b"a1", b"own 2"]
    waiting.add(b"x" * 49)
    waiting.skip()
    assert waiting.take() == ["… 2 lines left out".encode(), b"own 3", b"x" * 49]
    assert waiting.take() == []


@given(some.lists(some.sampled_from([b"", b"a", b"a" * 20, b"own", b"own" * 5, None])))
def test_each_line_is_taken_or_counted(steps: list[bytes | None]) -> None:
    waiting, taken = backlog(), list[bytes]()
    for step in steps:
        if step is None:
            taken += waiting.take()
        else:
            waiting.add(step)
        assert len(waiting) <= 6
    while found := waiting.take():
        taken += found
    lines = [step for step in steps if step is not None]
    left_out = sum(int(line.split()[1]) for line in taken if line.startswith("…".encode()))
    shown = [line for line in taken if not line.startswith("…".encode())]
    assert len(shown) + left_out == len(lines)
    own = [line for line in lines if line.startswith(b"own")]
    assert len(own) > 6 or [line for line in shown if line.startswith(b"own")] == own


def test_a_guard_is_ended_more_than_once_and_ends_what_is_noted() -> None:
    guard = Guard()
    process = subprocess.Popen(
        [sys.executable, "-c", "import time; time.sleep(600)"], start_new_session=True
    )
    guard.note(process.pid)
    guard.end()
    guard.forget()
    guard.close()
    assert process.wait(60) in (-signal.SIGINT, -signal.SIGTERM, -signal.SIGKILL, 1)
    with pytest.raises(ProcessLookupError):
        os.kill(process.pid, 0)
