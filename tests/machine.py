"""What tests need of the machine: a ROS, a graph that no other test sees, a port, time."""

from __future__ import annotations

import os
import socket
import time
import zlib
from collections.abc import Callable, Collection, Iterable
from itertools import count
from pathlib import Path
from typing import Any, NoReturn, TypeVar

import pytest

from plastron_tui.runtime.environment import Environment, find_environments

T = TypeVar("T")

IN_CI = bool(os.environ.get("CI"))

_QUICK = 12
"""The quick suite tries one of so many examples; `long` tests try all."""

_is_quick = False


def be_quick() -> None:
    """Try few examples from here on: called before the tests are read."""
    global _is_quick
    _is_quick = True


def examples(number: int) -> int:
    """Return how many examples a property is tried on: so many where tests may take long."""
    return max(number // _QUICK, min(number, 6)) if _is_quick else number


def mostly_long(
    values: Iterable[Any], quick: Collection[Any], name: Callable[[Any], str] | None = None
) -> list[Any]:
    """Return values for `parametrize`: but for the quick ones they make `long` tests.

    Args:
        values: one argument of a test each.
        quick: those that count in the quick suite; by name, where names are given.
        name: names a value.
    """
    named = [(value, value if name is None else name(value)) for value in values]
    assert {key for _, key in named} >= set(quick), quick
    return [
        pytest.param(
            value,
            id=None if name is None else str(key),
            marks=() if key in quick else pytest.mark.long,
        )
        for value, key in named
    ]


TALKING = """\
create_node 'talker' as talker
create_message hello of message_type String and input "hello"
talker publish hello to 'chatter' of message_type String at 20 hz
generate_node talker
create_node 'listener' as listener
subscribe listener to 'chatter' of message_type String
generate_node listener
create_node 'switcher' as switcher
switcher provides_service 'switch' of service_type SetBool
generate_node switcher
create_node 'asker' as asker
asker client_requests 'switch' of service_type SetBool with input True
subscribe asker to 'chatter' of message_type String
generate_node asker
"""
"""Four nodes that talk over topics, and over a service."""


def skip_or_fail(reason: str) -> NoReturn:
    """Skip where a developer's machine lacks what a test needs; in CI, which has all, fail."""
    if IN_CI:
        pytest.fail(reason)
    pytest.skip(reason)


def find_ros(version: int, interpreter: Path | None = None) -> Environment:
    """Return a ROS of the machine's; without one there is no test."""
    environment, diagnostics = find_environments(interpreter=interpreter).choose(version)
    if environment is None:
        skip_or_fail("; ".join(f"{one.message}: {one.help}" for one in diagnostics))
    return environment


def graph_environ(folder: Path) -> dict[str, str]:
    """Return the environment of a graph of the test's own, with its logs in the folder."""
    return {
        **os.environ,
        "ROS_HOME": str(folder / "ros"),
        "ROS_LOG_DIR": str(folder / "ros" / "log"),
        "ROS_MASTER_URI": f"http://127.0.0.1:{free_port()}",
        "ROS_DOMAIN_ID": domain_id(),
    }


_domains = count()


def domain_id() -> str:
    """Return a domain that no other graph of this run is in, as long as one test needs it.

    Above 101 the ports of a domain are those that the system gives away:
    https://docs.ros.org/en/rolling/Concepts/Intermediate/About-Domain-ID.html
    """
    run = zlib.crc32(os.environ.get("PYTEST_XDIST_TESTRUNUID", str(os.getpid())).encode())
    worker = int(os.environ.get("PYTEST_XDIST_WORKER", "gw0").removeprefix("gw"))
    each = 100 // int(os.environ.get("PYTEST_XDIST_WORKER_COUNT", "1"))
    return str(1 + (run + worker * each + next(_domains) % each) % 100)


def free_port() -> int:
    """Return a port of the loopback interface that nobody listens to."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port: int = probe.getsockname()[1]
    return port


def wait_until(look: Callable[[], T | None], what: str, limit: float = 120.0) -> T:
    """Return the first result of `look` that is true; fail where none is in time, in seconds."""
    deadline = time.monotonic() + limit
    while not (found := look()):
        assert time.monotonic() < deadline, f"not in time: {what}"
        time.sleep(0.02)
    return found
