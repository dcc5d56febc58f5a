"""What brings managed nodes up may die: they are not active then, and the run has failed."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

# The node ends once what activates it has been waited for.
NODE = """\
import pathlib, sys, time
pid = pathlib.Path(sys.argv[1])
while not pid.exists() or pathlib.Path("/proc", pid.read_text().strip()).exists():
    time.sleep(0.01)
"""
DRIVER = """\
import sys
from pathlib import Path
from plastron_tui.ros.installations import Origin
from plastron_tui.runtime.environment import Environment
from plastron_tui.runtime.launch import NodeFile, Options, run_nodes
python, node, pid = sys.argv[1:]
environment = Environment(Origin.EXTRA, 2, "kilted", Path(python))
command = (sys.executable, node, pid)
sys.exit(run_nodes([NodeFile("lamp", command, environment, managed=("/lamp",))], Options()).status)
"""


@pytest.mark.parametrize("status", [0, 3])
def test_the_run_fails_with_what_activates(tmp_path: Path, status: int) -> None:
    pid = tmp_path / "pid"
    python, node = tmp_path / "python3", tmp_path / "node.py"
    python.write_text(f"#!/bin/sh\necho $$ >{pid}.new\nmv {pid}.new {pid}\nexit {status}\n")
    python.chmod(0o755)
    node.write_text(NODE)
    command = [sys.executable, "-c", DRIVER, str(python), str(node), str(pid)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=60)
    assert done.returncode == bool(status), done.stdout + done.stderr
