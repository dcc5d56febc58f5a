"""`plastron shell`, from a pipe and at a terminal."""

from __future__ import annotations

import os
import pty
import select
import subprocess
import time
from collections.abc import Iterator
from pathlib import Path

import pytest
from command_line import PLASTRON, TALKER, Run

from plastron_tui.cli.common import Report
from plastron_tui.cli.shell import Shell
from plastron_tui.session import Session


def test_pipe_generates_at_once(run: Run, here: Path) -> None:
    result = run("shell", stdin=TALKER.encode())
    assert (result.returncode, result.stderr) == (0, b"")
    assert result.stdout == b"   create  output/talker_pub.py\n"
    assert (here / "output" / "talker_pub.py").exists()


@pytest.mark.parametrize("end", ["", "\n", "\r\n", "\n\n\n"])
def test_pipe_ends_anywhere(run: Run, end: str) -> None:
    text = TALKER.rstrip("\n").replace("\n", end if end == "\r\n" else "\n") + end
    assert run("shell", "-o", "x", stdin=text.encode()).stderr == b""


def test_mistake_has_no_effect_and_a_place(run: Run, here: Path) -> None:
    text = TALKER.replace("generate", "subscribe tolker to 'x' of message_type String\ngenerate")
    result = run("shell", stdin=text.encode())
    assert result.returncode == 1
    assert result.stderr.decode() == (
        "error[unknown-node]: no node `tolker`\n"
        " --> <input>:4:11\n"
        "  |\n"
        "4 | subscribe tolker to 'x' of message_type String\n"
        "  |           ^^^^^^\n"
        "  = help: did you mean `talker`?\n"
        "\n"
        "found 1 error\n"
    )
    assert (here / "output" / "talker_pub.py").exists()


def test_generate_twice_and_load(run: Run, here: Path) -> None:
    text = TALKER + (
        "subscribe talker to 'x' of message_type String\n"
        "generate_node talker\n"
        "load talker_node as again\n"
        "again stop_publishing to 'chatter'\n"
        "generate_node again\n"
    )
    result = run("shell", stdin=text.encode())
    assert result.returncode == 0
    assert [line.split()[0] for line in result.stdout.decode().splitlines()] == [
        "create",
        "changed",
        "changed",
    ]


def test_conflict_is_reported(run: Run, here: Path) -> None:
    (here / "output").mkdir()
    (here / "output" / "talker_pub.py").write_text("mine")
    result = run("shell", stdin=TALKER.encode())
    assert (result.returncode, b"error[file-conflict]" in result.stderr) == (1, True)
    assert (here / "output" / "talker_pub.py").read_text() == "mine"


NODE = """\
import rospy
from std_msgs.msg import String

rospy.init_node("robot")
rospy.Subscriber("command", String, print)
rospy.spin()
"""
TWICE = """\
load robot as n
subscribe n to 'a' of message_type String
generate_node n
subscribe n to 'b' of message_type String
generate_node n
"""


def test_loaded_node_is_generated_over_itself_again(run: Run, here: Path) -> None:
    (here / "output").mkdir()
    written = here / "output" / "robot.py"
    written.write_text(NODE)
    result = run("shell", stdin=TWICE.encode())
    assert (result.stderr, result.returncode) == (b"", 0)
    assert [line.split()[0] for line in result.stdout.splitlines()] == [b"changed", b"changed"]
    assert all(f'Subscriber("{name}"' in written.read_text() for name in ("command", "a", "b"))


def test_what_another_variable_made_of_a_file_is_not_written_over(run: Run, here: Path) -> None:
    (here / "output").mkdir()
    written = here / "output" / "robot.py"
    written.write_text(NODE)
    text = f"load robot as m\nsubscribe m to 'c' of message_type String\n{TWICE}generate_node m\n"
    result = run("shell", stdin=text.encode())
    assert (result.returncode, b"error[file-conflict]" in result.stderr) == (1, True)
    assert 'Subscriber("b"' in written.read_text()


def test_what_was_changed_by_hand_meanwhile_is_kept(here: Path) -> None:
    (here / "output").mkdir()
    written = here / "output" / "robot.py"
    written.write_text(NODE)
    report = Report()
    shell = Shell(Session(), report)
    for line in TWICE.splitlines()[:4]:
        shell.take(line.encode())
    mine = written.read_text() + "# mine\n"
    written.write_text(mine)
    shell.take(b"generate_node n")
    assert report.status == 1
    assert written.read_text() == mine


@pytest.mark.parametrize(
    "line",
    [b"\xff\xfe\n", b"a\0b\n", b"x" * 1_000_000 + b"\n", b"foo\n"],
    ids=["not utf-8", "nul", "long", "nonsense"],
)
def test_noise_does_not_end_the_shell(run: Run, line: bytes) -> None:
    result = run("shell", stdin=line + TALKER.encode())
    assert result.returncode == 1
    assert result.stdout == b"   create  output/talker_pub.py\n"
    assert len(result.stderr) < 2_000


class Terminal:
    """A process at a terminal of its own."""

    def __init__(self, here: Path) -> None:
        self._master, slave = pty.openpty()
        environment = {**os.environ, "TERM": "dumb", "PYTHON_BASIC_REPL": "1"}
        self.process = subprocess.Popen(
            [*PLASTRON, "shell"],
            cwd=here,
            stdin=slave,
            stdout=slave,
            stderr=slave,
            env=environment,
            start_new_session=True,
            preexec_fn=lambda: os.close(os.open(os.ttyname(0), os.O_RDWR)),
        )
        os.close(slave)
        self.shown = ""

    def expect(self, text: str, count: int = 1) -> None:
        limit = time.monotonic() + 60
        while self.shown.count(text) < count and self._read():
            assert time.monotonic() < limit, self.shown
        assert self.shown.count(text) >= count, self.shown

    def interrupt(self, count: int) -> None:
        """Interrupt a line that is being typed, and wait for so many prompts."""
        limit = time.monotonic() + 60
        while self.shown.count(">> ") < count:
            assert time.monotonic() < limit, self.shown
            # An interrupt at the very moment of the echo is noticed at the next key only.
            self.type(b"\x03")
            length = -1
            while self.shown.count(">> ") < count and len(self.shown) > length:
                length = len(self.shown)
                assert self._read(), self.shown

    def _read(self) -> bool:
        """Take what is shown within a second; tell whether there may be more."""
        ready, _, _ = select.select([self._master], [], [], 1)
        try:
            self.shown += os.read(self._master, 4096).decode("utf-8", "replace") if ready else ""
        except OSError:
            return False
        return True

    def type(self, text: bytes) -> None:
        os.write(self._master, text)

    def close(self) -> None:
        self.process.kill()
        self.process.wait()
        os.close(self._master)


@pytest.fixture
def terminal(here: Path) -> Iterator[Terminal]:
    terminal = Terminal(here)
    terminal.expect(">> ")
    yield terminal
    terminal.close()


@pytest.mark.parametrize("leave", [b"exit\n", b"\x04"])
def test_terminal_takes_statements(terminal: Terminal, here: Path, leave: bytes) -> None:
    for number, line in enumerate(TALKER.splitlines(), 2):
        terminal.type(line.encode() + b"\n")
        terminal.expect(">> ", number)
    terminal.expect("create  output/talker_pub.py")
    assert (here / "output" / "talker_pub.py").exists()
    terminal.type(leave)
    assert terminal.process.wait(60) == 0


def test_terminal_helps_and_survives_mistakes(terminal: Terminal) -> None:
    terminal.type(b"help\n")
    terminal.expect("generate_node VARIABLE")
    terminal.expect(">> ", 2)
    assert "SERVICE_TYPE with input\r\n        VALUES | none [at RATE hz]\r\n" in terminal.shown
    assert max(map(len, terminal.shown.splitlines())) <= 80
    terminal.type(b"nonsense here\n")
    terminal.expect("error[")
    terminal.expect(">> ", 3)
    terminal.type(b"\xff\xfe\n")
    terminal.expect("not UTF-8")
    terminal.expect(">> ", 4)
    terminal.type(b"half a li")
    terminal.expect("half a li")
    terminal.interrupt(5)
    assert terminal.process.poll() is None
    assert "Traceback" not in terminal.shown
    terminal.type(b"exit\n")
    assert terminal.process.wait(60) == 0


EXPLAINED = [
    (b"?\n", "generate_node VARIABLE"),
    (b"help load\n", "Example: load 'scripts/driver.py' as driver"),
    (b"help service\n", "Example: adder stop_service 'add'"),
    (b"help subscrib\n", "no statement `subscrib`; did you mean `subscribe`?"),
    (b"help xyzzy\n", "no statement `xyzzy`; there are create_node, load"),
]


def test_terminal_explains_a_statement(terminal: Terminal) -> None:
    for typed, said in EXPLAINED:
        terminal.shown = ""
        terminal.type(typed)
        terminal.expect(said)
        terminal.expect(">> ")
    terminal.type(b"quit\n")
    assert terminal.process.wait(60) == 0


def test_terminal_completes_keywords(terminal: Terminal) -> None:
    terminal.type(b"create_n\t'a' as a\n")
    terminal.expect("create_node 'a' as a")
    terminal.expect(">> ", 2)
    assert "error" not in terminal.shown


def test_a_pipe_may_ask_for_help_and_leave(run: Run) -> None:
    result = run("shell", stdin=b"help load\nexit\nnonsense\n")
    assert b"Example: load 'scripts/driver.py' as driver" in result.stdout
    assert (result.returncode, result.stderr) == (0, b"")
