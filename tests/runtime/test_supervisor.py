from __future__ import annotations

import os
import pty
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from supervised import Nodes, all_gone, clean_environ, command, run

from plastron_tui.runtime.child import Process
from plastron_tui.runtime.supervisor import Supervisor


@pytest.fixture
def nodes(tmp_path: Path) -> Nodes:
    return Nodes(tmp_path)


def test_every_line_of_every_node_arrives_in_order(nodes: Nodes) -> None:
    code = "for number in range(20000): print({0!r}, number)\nprint('no newline', end='')"
    done = run([nodes.python(name, code.format(name)) for name in ("one", "two")])
    assert done.returncode == 0
    lines = done.stdout.splitlines()
    for name in ("one", "two"):
        own = [line for line in lines if line.startswith(name)]
        expected = [*(f"{name} {number}" for number in range(20000)), "no newline"]
        assert own == [f"{name}      | {text}" for text in expected]


def test_a_node_that_dies_is_reported_and_the_others_go_on(nodes: Nodes) -> None:
    done = run(
        [
            nodes.python("bad", "print('first')\nraise KeyError('here')"),
            nodes.python("good", "time.sleep(1)\nprint('went on')"),
        ]
    )
    assert done.returncode == 1
    assert "good     | went on" in done.stdout
    assert "plastron | bad died with exit status 1: KeyError: 'here'\n" in done.stderr
    assert "bad      | KeyError: 'here'" in done.stdout
    assert "Traceback" not in done.stderr
    assert "plastron | good finished" in done.stderr


def test_a_node_has_no_hold_of_the_terminal(nodes: Nodes) -> None:
    code = r"print('\x1b]0;title\x07\x1b[2J\x1b[31mred\ttab\x1b[0m \x9b1A 10%\r20%')"
    done = run([nodes.python("one", code)])
    shown = r"one      | \x1b]0;title\x07\x1b[2Jred" + "\t" + r"tab \x9b1A 10%\r20%" + "\n"
    assert done.stdout == shown


@pytest.mark.parametrize(
    ("code", "words"),
    [
        ("sys.exit(7)", "died with exit status 7"),
        ("os.kill(os.getpid(), signal.SIGSEGV)", "was ended by SIGSEGV"),
    ],
)
def test_the_report_says_how_a_node_died(nodes: Nodes, code: str, words: str) -> None:
    done = run([nodes.python("bad", code)])
    assert (done.returncode, done.stderr) == (1, f"plastron | bad {words}\n")


def test_a_node_that_cannot_start_is_reported(nodes: Nodes) -> None:
    done = run([("none", ["/no/such/node"]), nodes.python("good", "print('ran')")])
    assert done.returncode == 1
    reason = "/no/such/node: No such file or directory"
    assert f"plastron | none never started: {reason}" in done.stderr
    assert "good     | ran" in done.stdout


def test_the_time_is_up(nodes: Nodes) -> None:
    done = run([nodes.ticking("one", helper="helper"), nodes.ticking("two")], 1.0)
    assert done.returncode == 0
    assert "left" not in done.stdout
    all_gone(*(nodes.pid(name) for name in ("one", "two", "helper")))


@pytest.mark.long
def test_a_node_that_heeds_no_signal_is_killed(nodes: Nodes) -> None:
    done = run([nodes.stubborn("one")], 0.5)
    assert (done.returncode, done.stdout) == (0, "")
    all_gone(nodes.pid("one"))


def test_what_a_dead_node_started_does_not_stay(nodes: Nodes) -> None:
    name, argv = nodes.ticking("one", helper="helper")
    argv[-1] = argv[-1].replace("while True:", "sys.exit(0)\nwhile True:")
    assert run([(name, argv)]).returncode == 0
    all_gone(nodes.pid("helper"))


@pytest.mark.long
def test_output_without_end_from_elsewhere_keeps_no_run_from_ending(nodes: Nodes) -> None:
    """What a node started in a session of its own is out of reach, and holds the pipe."""
    code = "subprocess.Popen(['yes'], start_new_session=True)\ntime.sleep(0.3)"
    assert run([nodes.python("one", code)]).returncode == 0


def test_a_node_that_closes_its_output_is_waited_for(nodes: Nodes) -> None:
    done = run([nodes.python("one", "os.close(1); os.close(2); time.sleep(0.5); os._exit(3)")])
    assert (done.returncode, done.stderr) == (1, "plastron | one died with exit status 3\n")


def test_a_killed_supervisor_leaves_nothing_behind(nodes: Nodes) -> None:
    told = [nodes.ticking("one", helper="helper"), nodes.stubborn("two")]
    with subprocess.Popen(command(told), stdout=subprocess.DEVNULL) as supervisor:
        pids = [nodes.pid(name) for name in ("one", "two", "helper")]
        supervisor.kill()
    all_gone(*pids)


def test_a_reader_that_leaves_ends_the_run(nodes: Nodes) -> None:
    with subprocess.Popen(
        command([nodes.ticking("one")]), stdout=subprocess.PIPE, stderr=subprocess.PIPE
    ) as supervisor:
        assert supervisor.stdout is not None
        assert supervisor.stderr is not None
        supervisor.stdout.readline()
        supervisor.stdout.close()
        assert supervisor.stderr.read() == b""
    assert supervisor.returncode == 0
    all_gone(nodes.pid("one"))


class Terminal:
    """A run in a terminal of its own."""

    def __init__(self, told: list[tuple[str, list[str]]], **variables: str) -> None:
        self.pid, self.fd = pty.fork()
        if self.pid == 0:
            os.execve(sys.executable, command(told), clean_environ(**variables))

    def read_lines(self, count: int) -> bytes:
        seen = b""
        while seen.count(b"\n") < count:
            seen += self._read()
        return seen

    def _read(self) -> bytes:
        try:
            return os.read(self.fd, 4096)
        except OSError:
            return b""

    def press(self, key: bytes) -> None:
        os.write(self.fd, key)

    def close(self) -> None:
        os.close(self.fd)

    def status(self) -> int:
        while self._read():
            pass
        return os.waitstatus_to_exitcode(os.waitpid(self.pid, 0)[1])


def test_ctrl_c_ends_everything(nodes: Nodes) -> None:
    terminal = Terminal([nodes.ticking("one", helper="helper"), nodes.ticking("two")])
    pids = [nodes.pid(name) for name in ("one", "two", "helper")]
    terminal.press(b"\x03")
    assert terminal.status() == 128 + signal.SIGINT
    terminal.close()
    all_gone(*pids)


def test_a_closed_terminal_ends_everything(nodes: Nodes) -> None:
    terminal = Terminal([nodes.ticking("one", helper="helper"), nodes.stubborn("two")])
    pids = [terminal.pid, *(nodes.pid(name) for name in ("one", "two", "helper"))]
    terminal.close()
    os.waitpid(terminal.pid, 0)
    all_gone(*pids)


@pytest.mark.parametrize(("variables", "has_colour"), [({}, True), ({"NO_COLOR": "1"}, False)])
def test_a_terminal_shows_colours(
    nodes: Nodes, variables: dict[str, str], has_colour: bool
) -> None:
    terminal = Terminal([nodes.ticking("one"), nodes.ticking("two")], **variables)
    seen = terminal.read_lines(6)
    terminal.press(b"\x03")
    terminal.status()
    terminal.close()
    assert (b"\x1b[36mone      |\x1b[0m tick" in seen) is has_colour
    assert (b"one      | tick" in seen) is not has_colour


def test_a_host_ends_after_those_that_sign_off_at_it() -> None:
    signs_off = "trap 'sleep 0.1; exit 0' INT; echo up; while :; do sleep 0.01; done"
    host = Process("host", ("sleep", "100"), is_host=True)
    with Supervisor(lambda *_: supervisor.stop()) as supervisor:
        supervisor.start(host)
        supervisor.start(Process("guest", ("sh", "-c", signs_off)))
        supervisor.wait()
    assert [each.process.name for each in supervisor.exits] == ["guest", "host"]
