"""An interrupt ends plastron with 130, and leaves the disk wholly old or wholly new."""

from __future__ import annotations

import shutil
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from command_line import PLASTRON, Run, snapshot
from machine import mostly_long, wait_until

COUNT = 40

# Sends a signal to its own process at the nth call of a function of `os`.
SIGNALLED = """
import os, signal, sys
from plastron_tui.cli import main
name, wanted, number = sys.argv.pop(1), int(sys.argv.pop(1)), int(sys.argv.pop(1))
original, calls = getattr(os, name), 0
def counted(*arguments, **options):
    global calls
    calls += 1
    if calls == wanted:
        os.kill(os.getpid(), number)
    return original(*arguments, **options)
setattr(os, name, counted)
main()
"""


def many(count: int, topic: str = "chatter") -> str:
    return "".join(
        f"create_node 'n{i}' as n{i}\n"
        f"subscribe n{i} to '{topic}' of message_type String\n"
        f"generate_node n{i}\n"
        for i in range(count)
    )


def generate_with_signal(
    here: Path, name: str, call: int, number: int
) -> subprocess.CompletedProcess[bytes]:
    return subprocess.run(
        [sys.executable, "-c", SIGNALLED, name, str(call), str(number), "generate", "a.plastron"],
        cwd=here,
        capture_output=True,
        timeout=120,
    )


@pytest.fixture(scope="module")
def written(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with a program, and what was generated of it."""
    folder = tmp_path_factory.mktemp("written")
    folder.joinpath("a.plastron").write_text(many(COUNT))
    assert subprocess.run([*PLASTRON, "generate", "a.plastron"], cwd=folder).returncode == 0
    return folder


@pytest.mark.parametrize(
    "call",
    [
        1,
        COUNT,
        *(pytest.param(call, marks=pytest.mark.long) for call in (2, COUNT // 2, COUNT + 1)),
    ],
)
@pytest.mark.parametrize(
    "name", mostly_long(["fsync", "rename", "replace", "open"], ["rename", "open"])
)
@pytest.mark.parametrize("has_files", mostly_long([False, True], [True]))
def test_interrupt_while_writing(
    here: Path, name: str, call: int, has_files: bool, written: Path, run: Run
) -> None:
    program = here / "a.plastron"
    if has_files:
        shutil.copytree(written, here, dirs_exist_ok=True)
    old = snapshot(here / "output")
    program.write_text(many(COUNT, "other"))
    result = generate_with_signal(here, name, call, signal.SIGINT)
    assert b"Traceback" not in result.stderr
    new = snapshot(here / "output")
    assert result.returncode in (0, 130)
    nodes = {name for name in new if name.endswith(".py")}
    # Where the writer does not call the function so often there is no interrupt.
    if new != old or result.returncode == 0:
        assert len(nodes) == COUNT
        assert all(b"other" in (new[name] or b"") for name in nodes)
    assert not [name for name in new if name.startswith(".plastron-")]
    # What is there is what the next run expects: no conflict.
    again = run("generate", "a.plastron")
    assert (again.returncode, again.stderr) == (0, b"")


def test_interrupt_is_130(here: Path) -> None:
    (here / "a.plastron").write_text(many(COUNT))
    result = generate_with_signal(here, "fsync", 3, signal.SIGINT)
    assert (result.returncode, result.stderr.strip()) == (130, b"")
    assert not (here / "output").exists()


def test_termination_leaves_nothing(here: Path) -> None:
    (here / "a.plastron").write_text(many(COUNT))
    result = generate_with_signal(here, "fsync", 3, signal.SIGTERM)
    assert result.returncode == -signal.SIGTERM
    assert not (here / "output").exists()


@pytest.mark.parametrize("written", mostly_long([1, 200, 399], [200]))
def test_interrupt_from_outside(here: Path, written: int) -> None:
    count = 400
    (here / "a.plastron").write_text(many(count))
    with subprocess.Popen(
        [*PLASTRON, "generate", "a.plastron"],
        cwd=here,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
    ) as process:
        wait_until(
            lambda: process.poll() is not None or len([*here.rglob(".plastron-*")]) >= written,
            "files are written",
        )
        process.send_signal(signal.SIGINT)
        _, errors = process.communicate(timeout=60)
    assert b"Traceback" not in errors
    assert process.returncode in (0, 130)
    found = snapshot(here / "output")
    assert len([name for name in found if name.endswith(".py")]) in (0, count)
    assert not [name for name in found if name.startswith(".plastron-")]


AT_START = """
import sys
from importlib.abc import MetaPathFinder
from plastron_tui.cli import main
class Interrupt(MetaPathFinder):
    def find_spec(self, name, path, target=None):
        if name == "plastron_tui.cli.streams":
            raise KeyboardInterrupt
sys.meta_path.insert(0, Interrupt())
main()
"""


def test_ctrl_c_while_plastron_starts_is_quiet(tmp_path: Path) -> None:
    done = subprocess.run(
        [sys.executable, "-c", AT_START], cwd=tmp_path, capture_output=True, timeout=120
    )
    assert (done.returncode, done.stdout, done.stderr) == (130, b"", b"")
