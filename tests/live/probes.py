"""Questions to a graph, answered by copies of a probe that has its modules already."""

from __future__ import annotations

import json
import subprocess
from collections.abc import Mapping, Sequence
from pathlib import Path
from threading import Lock

from machine import wait_until

_SERVER = Path(__file__).with_name("copied_probe.py")
_AT_START = ("PYTHONPATH", "LD_LIBRARY_PATH", "AMENT_PREFIX_PATH")
"""The variables that a process has to have from its start on."""

_servers: dict[tuple[str, ...], subprocess.Popen[str]] = {}
_lock = Lock()


def ask(
    python: Path,
    probe: Path,
    environ: Mapping[str, str],
    arguments: Sequence[str],
    output: Path,
    seconds: float,
) -> str:
    """Run a probe in a graph until it ends, and return what it printed.

    Args:
        python: the interpreter that has ROS.
        probe: the file of the probe, whose `main` is called.
        environ: all variables of the probe.
        arguments: of its command line.
        output: gets what it prints.
        seconds: how long it may take.
    """
    status = output.with_suffix(".status")
    asked = {
        "arguments": list(arguments),
        "environ": dict(environ),
        "output": str(output),
        "status": str(status),
        "seconds": int(seconds),
    }
    with _lock:
        server = _server(python, probe, environ)
        assert server.stdin is not None
        print(json.dumps(asked), file=server.stdin, flush=True)
    wait_until(status.exists, f"the probe has ended: {arguments[0]}", seconds + 10)
    said = output.read_text(encoding="utf-8", errors="replace")
    assert status.read_text() == "0", said
    return said


def _server(python: Path, probe: Path, environ: Mapping[str, str]) -> subprocess.Popen[str]:
    """Return what copies the probe; it ends with this process, whose end of the pipe closes."""
    key = (str(python), str(probe), *(environ.get(name, "") for name in _AT_START))
    if key not in _servers or _servers[key].poll() is not None:
        _servers[key] = subprocess.Popen(
            [str(python), str(_SERVER), str(probe)],
            env=dict(environ),
            stdin=subprocess.PIPE,
            stdout=subprocess.DEVNULL,
            text=True,
            start_new_session=True,
        )
    return _servers[key]
