"""Names and texts that a terminal would obey, and how to see whether any of them got out."""

from __future__ import annotations

import os
import pty
import re
import select
import subprocess
import time
from collections.abc import Callable, Sequence
from pathlib import Path

# A title (OSC), colours that blink (CSI), the same by its one-byte sign (C1), a text that runs
# backwards, and a byte that is no text.
PAYLOAD = "\x1b]0;OWNED\x07\x1b[35;5mX\x9b2J\x90q\u202egnp\u2066\r\x08"
NAME = f"p{PAYLOAD}"
ODD_NAME = os.fsdecode(b"q\x1b[35;5m\xff")

OBEYED = re.compile(
    "[\x00-\x08\x0b-\x1f\x7f-\x9f\u061c\u200e\u200f\u2028-\u202e\u2060-\u206f\ufeff]"
)
_OWN_COLOURS = re.compile(r"\x1b\[[0-9;]*m")
_BLINKS = re.compile(r"\x1b\[35;5m")

PROGRAM = f"""\
// {PAYLOAD.replace(chr(13), "")}
create_node 'talker' as talker
create_message hello of message_type String and input "{PAYLOAD.replace(chr(13), "")}"
talker publish hello to 'chatter' of message_type String
talker publish hello to 'a{PAYLOAD.replace(chr(13), "")}' of message_type Strin{chr(27)}[35;5mg
load 'x{PAYLOAD.replace(chr(13), "")}.py' as other
generate_node talker
"""
"""Most of it is wrong, so that it is quoted by diagnostics."""


def obeyed(text: str) -> list[str]:
    """Return what of a text a terminal would obey, but for colours that are Plastron's."""
    return [
        *_BLINKS.findall(text),
        *OBEYED.findall(_OWN_COLOURS.sub("", text).replace("\r\n", "\n")),
    ]


def on_terminal(
    command: Sequence[str],
    cwd: Path,
    *,
    stdin: bytes = b"",
    answer: Callable[[str], bytes] | None = None,
    limit: float = 100.0,
) -> str:
    """Run a program whose output is a terminal, and return all that it writes there.

    Args:
        command: the program and its arguments.
        cwd: its working folder.
        stdin: its input; with `answer` that is the terminal too.
        answer: called with what was written so far; what it returns is typed.
        limit: seconds.
    """
    own, its = pty.openpty()
    environ = {**os.environ, "TERM": "xterm-256color", "COLUMNS": "100", "LINES": "30"}
    process = subprocess.Popen(
        command, cwd=cwd, env=environ, stdout=its, stderr=its, start_new_session=True,
        stdin=its if answer is not None else subprocess.PIPE,
    )  # fmt: skip
    os.close(its)
    if process.stdin is not None:
        process.stdin.write(stdin)
        process.stdin.close()
    said = b""
    end = time.monotonic() + limit
    try:
        while time.monotonic() < end:
            if select.select([own], [], [], 0.1)[0]:
                try:
                    part = os.read(own, 1 << 16)
                except OSError:  # the other end is closed
                    break
                if not part:
                    break
                said += part
            if answer is not None and (typed := answer(said.decode("utf-8", "replace"))):
                os.write(own, typed)
        else:
            raise AssertionError(f"it does not end: {said[-1000:]!r}")
    finally:
        process.kill()
        process.wait()
        os.close(own)
    return said.decode("utf-8", "replace")
