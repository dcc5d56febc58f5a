"""How often generated nodes send, on each ROS that is here, against what their program asks for."""

from __future__ import annotations

import json
import os
import signal
import socket
import subprocess
import sys
from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path
from tempfile import TemporaryDirectory

from benchmarks.row import Row
from plastron_tui.runtime.environment import Environment, find_environments, node_environ

_RATES = (0.5, 1, 10, 50, 100, 200)
_MESSAGES = 8
"""So many come over the slowest topic while all are listened to."""
_LONGEST = 120.0
_MOST = 10.0
"""Percent that a rate may be off."""

_LISTENER = Path(__file__).with_name("rate_listener.py")


def rows() -> Iterator[Row]:
    """Measure a node that publishes at all rates at once, with each client library."""
    found = find_environments()
    for version in (1, 2):
        environment, _ = found.choose(version)
        if environment is None:
            print(f"     no ROS {version}: its rates are not measured")
        else:
            yield from _rows(environment)


def _rows(environment: Environment) -> Iterator[Row]:
    for rate, times in _measured(environment).items():
        gaps = [later - earlier for earlier, later in pairwise(times)]
        hertz = len(gaps) / sum(gaps)
        yield Row(
            f"{environment.library}: how far a publisher at {rate:g} hz is off",
            abs(hertz / rate - 1) * 100,
            _MOST,
            "%",
            f"{hertz:.2f} hz, {min(gaps) * 1000:.1f} to {max(gaps) * 1000:.1f} ms apart",
        )


def _measured(environment: Environment) -> dict[float, list[float]]:
    """Return when the messages of each rate came, while those of all did."""
    topics = {rate: f"rate_{number}" for number, rate in enumerate(_RATES)}
    lines = [
        "create_node 'sender' as sender",
        'create_message hello of message_type String and input "hello"',
        *(
            f"sender publish hello to '{name}' of message_type String at {rate} hz"
            for rate, name in topics.items()
        ),
        "generate_node sender",
    ]
    with TemporaryDirectory() as folder:
        program = Path(folder, "rates.plastron")
        program.write_text("\n".join(lines) + "\n")
        environ = _graph_environ(Path(folder))
        command = (sys.executable, "-m", "plastron_tui", "run", str(program))
        with subprocess.Popen(
            [*command, "--target", environment.library],
            env=environ,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        ) as run:
            try:
                done = subprocess.run(
                    [environment.python, _LISTENER, str(_MESSAGES), *topics.values()],
                    env=node_environ(environment, environ, master_uri=environ["ROS_MASTER_URI"]),
                    stdout=subprocess.PIPE,
                    timeout=_LONGEST,
                    check=True,
                )
            finally:
                run.send_signal(signal.SIGINT)
    found: dict[str, list[float]] = json.loads(done.stdout.splitlines()[-1])
    # What was sent before the listener was known to all is not among it.
    start = max(times[0] for times in found.values())
    return {rate: [time for time in found[name] if time >= start] for rate, name in topics.items()}


def _graph_environ(folder: Path) -> dict[str, str]:
    """Return the environment of a graph that nobody else is in."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = probe.getsockname()[1]
    return {
        **os.environ,
        "ROS_MASTER_URI": f"http://127.0.0.1:{port}",
        "ROS_DOMAIN_ID": str(1 + os.getpid() % 100),
        "ROS_HOME": str(folder),
        "ROS_LOG_DIR": str(folder / "log"),
    }
