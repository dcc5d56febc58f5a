"""Lines of a process, and the word that there are some."""

from __future__ import annotations

import io
import os
import signal
import subprocess
import sys

import pytest

from plastron_tui.runtime.child import Guard
from plastron_tui.runtime.process_lines import News, lines_of


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
