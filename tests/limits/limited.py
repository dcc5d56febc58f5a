"""Attacks, and what becomes of them."""

from __future__ import annotations

import json
import subprocess
from dataclasses import dataclass
from pathlib import Path
from typing import Any

PROGRAM = """\
create_node 'talker' as talker
create_message hello of message_type Odd and input 1
talker publish hello to 'chatter' of message_type Odd at 2 hz
load known as known
subscribe known to 'chatter' of message_type Odd
generate_node talker
generate_node known
"""
NODE = """\
import rospy
from std_msgs.msg import String

rospy.init_node('known')
publisher = rospy.Publisher('words', String, queue_size=1)
rospy.spin()
"""
SERVICE = "int32 a\n---\nint32 b\n"

LONGEST_LINE = 2_400
"""A message of 2 kB, with what stands around it."""


@dataclass(frozen=True)
class Outcome:
    """What became of an attack.

    Attributes:
        status: the exit status, negative for a signal, None for a process that hung.
        out: what was written to standard output.
        err: what was written to standard error.
    """

    status: int | None
    out: str
    err: str

    def check(self, *statuses: int) -> Outcome:
        """Fail unless the attacked process ended by itself, with one of the statuses."""
        assert self.status in (statuses or (0, 1, 2)), self
        assert self.status == 0 or self.err, self
        assert "Traceback" not in self.err, self.err[-2_000:]
        longest = max(self.err.split("\n"), key=len)
        assert len(longest) <= LONGEST_LINE, f"{len(longest)} characters: {longest[:200]}"
        return self


class Attacker:
    """Attacks Plastron in processes that have little memory and little time."""

    def __init__(self, server: subprocess.Popen[str], home: Path) -> None:
        self._server = server
        self.trusted = home / "state/plastron/trusted"
        self._environ = {
            "HOME": str(home),
            "XDG_CONFIG_HOME": str(home / "config"),
            "XDG_STATE_HOME": str(home / "state"),
            "XDG_DATA_HOME": str(home / "data"),
        }

    def run(self, folder: Path, *arguments: str) -> Outcome:
        """Run a command in a folder."""
        return Outcome(**self._ask(folder, arguments=arguments))

    def warm_up(self, folder: Path, *arguments: str) -> None:
        """Run a command in the process that the attacked ones are made from."""
        answer = self._ask(folder, arguments=arguments, is_warm_up=True)
        assert answer == {"status": 0}, answer

    def python(self, folder: Path, code: str) -> Outcome:
        """Run Python in a folder, for what no command does without a terminal."""
        return Outcome(**self._ask(folder, python=code))

    def _ask(self, folder: Path, **attack: object) -> dict[str, Any]:
        assert self._server.stdin is not None
        assert self._server.stdout is not None
        attack |= {"folder": str(folder), "environ": self._environ}
        print(json.dumps(attack), file=self._server.stdin, flush=True)
        answer: dict[str, Any] = json.loads(self._server.stdout.readline())
        return answer


def make_project(folder: Path) -> None:
    """Write a package with a program, a node file, types, and what an earlier run left."""
    for name in ("msg", "srv", "action", "output", "templates/rospy"):
        (folder / name).mkdir(parents=True)
    texts = {
        "p.plastron": PROGRAM,
        "plastron.yaml": "target: rospy\n",
        "package.xml": "<package><name>pkg</name></package>",
        "msg/Odd.msg": "int32 number\n",
        "srv/Ask.srv": SERVICE,
        "action/Go.action": f"int32 goal\n---\n{SERVICE}",
        "known.py": NODE,
    }
    for name, text in texts.items():
        (folder / name).write_text(text)
