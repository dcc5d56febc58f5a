"""Changing a parameter of a node that runs."""

from __future__ import annotations

import json
import os
import subprocess
from collections.abc import Mapping
from enum import Enum
from pathlib import Path
from typing import NamedTuple

from plastron_tui.ros.names import check_parameter_name
from plastron_tui.ros.parameter_values import unfit
from plastron_tui.ros.parameters import Setting

from .environment import LOOPBACK, Environment, is_local, node_environ
from .master import DEFAULT_PORT, MasterError, call

_SET_PARAMETER = Path(__file__).with_name("observers") / "set_parameter.py"
_LIMIT = 10.0
# To start Python, import rclpy, and end.
_AROUND = 20.0


class SetStatus(str, Enum):
    """What became of a parameter that was to be changed."""

    DONE = "done"
    REFUSED = "refused"
    ABSENT = "absent"
    """No such node answers."""


class SetResult(NamedTuple):
    """What a node says to a new value of a parameter: what became of it, and why."""

    status: SetStatus
    reason: str = ""


def set_parameter(
    environment: Environment,
    node: str,
    name: str,
    value: Setting,
    *,
    master_uri: str | None = None,
    limit: float = _LIMIT,
    environ: Mapping[str, str] = os.environ,
) -> SetResult:
    """Change a parameter of a running node on this machine.

    A ROS 2 node is asked, by its service `set_parameters`, and may refuse. In ROS 1 nobody is:
    the private parameter on the master changes, and the node sees it when it reads it again.

    Args:
        environment: the ROS that the node runs with.
        node: its full name, such as `/robot1/talker`.
        name: the parameter; its parts are separated by `.`, or `/`.
        value: the new value.
        master_uri: the ROS 1 master; None for the one that the environment names, or the usual.
        limit: the most seconds that the node may take to answer.
        environ: the environment variables.
    """
    version = environment.ros_version
    name = name.replace(".", "/") if version == 1 else name
    problem = check_parameter_name(name, version)
    reason = unfit(value, version) if problem is None else problem.message
    if reason is not None:
        return SetResult(SetStatus.REFUSED, reason)
    if version == 1:
        usual = environ.get("ROS_MASTER_URI") or f"http://{LOOPBACK}:{DEFAULT_PORT}"
        return _set_ros1(master_uri or usual, node, name, value, limit)
    return _set_ros2(environment, node, name, value, limit, environ)


def _set_ros1(uri: str, node: str, name: str, value: Setting, limit: float) -> SetResult:
    if not is_local(uri):
        return SetResult(SetStatus.ABSENT, f"the ROS 1 master at {uri} is on another machine")
    try:
        own = call(uri, "lookupNode", node, limit=limit)
        if is_local(own):
            call(own, "getPid", limit=limit)
    except MasterError as error:
        return SetResult(SetStatus.ABSENT, str(error))
    try:
        call(uri, "setParam", f"{node}/{name}", value, limit=limit)
    except MasterError as error:
        return SetResult(SetStatus.REFUSED, str(error))
    return SetResult(SetStatus.DONE)


def _set_ros2(
    environment: Environment,
    node: str,
    name: str,
    value: Setting,
    limit: float,
    environ: Mapping[str, str],
) -> SetResult:
    command = [str(environment.python), str(_SET_PARAMETER), node, name, json.dumps(value)]
    try:
        done = subprocess.run(
            [*command, str(limit)],
            env=node_environ(environment, environ),
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            timeout=limit + _AROUND,
            check=False,
        )
        answer = json.loads(done.stdout.strip().splitlines()[-1])
        return SetResult(SetStatus(answer["status"]), answer["reason"])
    except (OSError, subprocess.TimeoutExpired) as error:
        return SetResult(SetStatus.ABSENT, str(error))
    except (IndexError, ValueError):
        return SetResult(SetStatus.ABSENT, (done.stderr.strip().splitlines() or ["no answer"])[-1])
