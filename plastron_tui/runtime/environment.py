"""Which ROS is there: found by looking at files, with nothing of ROS imported here."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

from plastron_tui.diagnostics import Diagnostic, Severity, codes
from plastron_tui.ros.catalog.distributions import usual_distribution
from plastron_tui.ros.installations import (
    Installation,
    Origin,
    distribution_of_rclpy,
    present,
    setup_file,
    sourced_version,
)

from . import installing

DEBIAN_COMMAND = "sudo apt install python3-rospy python3-rosmaster python3-std-msgs"
DEBIAN_PYTHON = Path("/usr/bin/python3")
LOOPBACK = "127.0.0.1"

_PROBE = Path(__file__).with_name("observers") / "probe.py"
_PROBE_LIMIT = 20.0

# These know only ROS_LOCALHOST_ONLY (ROS 2 documentation, "Improved dynamic discovery").
_BEFORE_DISCOVERY_RANGE = frozenset({"dashing", "eloquent", "foxy", "galactic", "humble"})

# What the wheels' start-up hook leaves in the environment of the Python that it set up.
_WHEELS_MARK = "_ROS_WHEELS_BOOTSTRAP_COMPLETE"


@dataclass(frozen=True, slots=True)
class Environment:
    """A ROS that nodes can be run with.

    Attributes:
        origin: where it comes from.
        ros_version: 1 or 2.
        distribution: its name (`kilted`, `noetic`), "" where nothing tells.
        python: the interpreter that can import its client library.
        overlays: folders of interface packages that are used with it, each with the folder
            `python`, and `lib` for libraries.
    """

    origin: Origin
    ros_version: int
    distribution: str
    python: Path
    overlays: tuple[Path, ...] = ()

    @property
    def library(self) -> str:
        """The Python client library."""
        return "rospy" if self.ros_version == 1 else "rclpy"

    @property
    def words(self) -> str:
        """What it is, for a person: `ROS 2 kilted (from the Python packages)`."""
        return Installation(self.origin, self.ros_version, self.distribution).words


@dataclass(frozen=True, slots=True)
class Half:
    """A ROS that is installed in part, and what to do about it."""

    ros_version: int
    diagnostic: Diagnostic


@dataclass(frozen=True, slots=True)
class Found:
    """What nodes can be run with, and what is in the way of more.

    Attributes:
        environments: the environments, the preferred one first.
        halves: what is installed in part.
        unsourced: what is in /opt/ros and would be an environment once it is sourced.
    """

    environments: tuple[Environment, ...]
    halves: tuple[Half, ...] = ()
    unsourced: tuple[Installation, ...] = ()

    def choose(self, ros_version: int | None = None) -> tuple[Environment | None, list[Diagnostic]]:
        """Return the preferred environment, of a ROS version where one is asked for.

        Without one the diagnostics say what is missing, and the command that installs it. With
        one they are warnings, about what is installed in part beside it.
        """
        halves = [
            half.diagnostic for half in self.halves if ros_version in (None, half.ros_version)
        ]
        for environment in self.environments:
            if ros_version in (None, environment.ros_version):
                return environment, [half._replace(severity=Severity.WARNING) for half in halves]
        if halves:
            return None, halves
        for each in self.unsourced:
            if ros_version in (None, each.ros_version):
                return None, [_not_sourced(each)]
        there = ", ".join(environment.words for environment in self.environments)
        which = "ROS" if ros_version is None else f"ROS {ros_version}"
        message = f"no {which} is on this machine" + (f", only {there}" if there else "")
        command = DEBIAN_COMMAND if ros_version == 1 else installing.extra()
        brought = f"ROS {ros_version or 2} {usual_distribution(ros_version or 2)}"
        help_ = f"install {brought} with `{command}`"
        return None, [Diagnostic(codes.NO_ROS, message, help=help_)]


def find_environments(
    environ: Mapping[str, str] = os.environ,
    *,
    interpreter: Path | None = None,
    debian_python: Path = DEBIAN_PYTHON,
) -> Found:
    """Find a sourced environment, the Python packages, and Debian's rospy.

    Args:
        environ: the environment variables.
        interpreter: the Python whose packages are the extra; None for the running one.
        debian_python: the system's Python.
    """
    interpreter = interpreter or Path(sys.executable)
    results: list[Environment | Half | None] = []
    version = sourced_version(environ)
    if version is not None:
        results.append(_find_sourced(version, environ, interpreter, debian_python))
    bare = _unsourced(environ)
    for origin, python in ((Origin.EXTRA, interpreter), (Origin.DEBIAN, debian_python)):
        found = _probe(python, bare)
        if found is not None:
            results.append(_of_probe(origin, python, found, bare))
    return Found(
        tuple(result for result in results if isinstance(result, Environment)),
        tuple(result for result in results if isinstance(result, Half)),
        tuple(each for each in present(environ) if each.origin is Origin.UNSOURCED),
    )


def missing_packages(
    environment: Environment, packages: Iterable[str], environ: Mapping[str, str] = os.environ
) -> list[str]:
    """Return the packages that the environment cannot import."""
    named = list(dict.fromkeys(packages))
    found = _probe(environment.python, node_environ(environment, environ), named)
    return [] if found is None else list(found["missing"])


def missing_package(environment: Environment, name: str) -> Diagnostic:
    """Say that an environment lacks an interface package, and how it gets there."""
    return Diagnostic(
        codes.MISSING_ROS_PACKAGE,
        f"`{name}` is not installed in {environment.words}",
        help=_remedy(environment, name),
    )


def node_environ(
    environment: Environment,
    environ: Mapping[str, str] = os.environ,
    *,
    network: bool = False,
    master_uri: str | None = None,
) -> dict[str, str]:
    """Return the environment variables of a node: this machine only, unless `network`."""
    own = dict(environ) if environment.origin is Origin.SOURCED else _unsourced(environ)
    own = _without_wheels(own)
    for variable, folder in (("PYTHONPATH", "python"), ("LD_LIBRARY_PATH", "lib")):
        parts = [*(str(each / folder) for each in environment.overlays), own.get(variable, "")]
        if environment.overlays:
            own[variable] = os.pathsep.join(filter(None, parts))
    own["PYTHONUNBUFFERED"] = "1"
    if environment.ros_version == 1:
        # rosconsole, whose lines would come in blocks.
        own["ROSCONSOLE_STDOUT_LINE_BUFFERED"] = "1"
        if master_uri is not None:
            own["ROS_MASTER_URI"] = master_uri
        if not network:
            # ROS_HOSTNAME would win over ROS_IP (rosgraph.network.get_address_override).
            own.pop("ROS_HOSTNAME", None)
            own.pop("ROS_IPV6", None)
            own["ROS_IP"] = LOOPBACK
    elif not network:
        own["ROS_AUTOMATIC_DISCOVERY_RANGE"] = "LOCALHOST"
        # A static peer is spoken to whatever the range is.
        own.pop("ROS_STATIC_PEERS", None)
        own.pop("ROS_LOCALHOST_ONLY", None)
        if environment.distribution in _BEFORE_DISCOVERY_RANGE:
            own["ROS_LOCALHOST_ONLY"] = "1"
    return own


def with_folders(environ: Mapping[str, str], folders: Sequence[tuple[str, Path]]) -> dict[str, str]:
    """Return variables with folders that come first in some of them, each of them once."""
    own = dict(environ)
    for variable, folder in reversed(folders):
        known = [part for part in own.get(variable, "").split(os.pathsep) if part]
        own[variable] = os.pathsep.join([str(folder), *(p for p in known if p != str(folder))])
    return own


def is_local(uri: str) -> bool:
    """Tell whether a ROS 1 master's address is on this machine by its very name."""
    host = urlsplit(uri).hostname or ""
    return host in ("localhost", "::1") or host.startswith("127.")


def _find_sourced(
    version: int, environ: Mapping[str, str], interpreter: Path, debian_python: Path
) -> Environment | Half:
    # An empty part of PATH is the current folder.
    folders = filter(os.path.isabs, environ.get("PATH", os.defpath).split(os.pathsep))
    on_path = shutil.which("python3", path=os.pathsep.join(folders))
    candidates = [*([Path(on_path)] if on_path else []), debian_python, interpreter]
    own = _without_wheels(dict(environ))
    half: Half | None = None
    for python in dict.fromkeys(candidates):
        found = _probe(python, own)
        if found is None:
            continue
        if found["rospy" if version == 1 else "rclpy"]:
            result = _of_probe(Origin.SOURCED, python, found, own, version)
            if isinstance(result, Environment):
                return result
            half = half or result
    if half is not None:
        return half
    distribution = environ.get("ROS_DISTRO", "")
    library = "rospy" if version == 1 else "rclpy"
    name = f"ROS {version} {distribution}".rstrip()
    return _half(
        version,
        f"{name} is sourced, but no Python here can import {library}",
        _remedy(Environment(Origin.SOURCED, version, distribution, debian_python), library),
    )


def _of_probe(
    origin: Origin,
    python: Path,
    found: Mapping[str, Any],
    environ: Mapping[str, str],
    version: int | None = None,
) -> Environment | Half | None:
    """Judge what a probe found: an environment, half of one, or none."""
    if version is None:
        wanted = 1 if origin is Origin.DEBIAN else 2
        if not found["rospy" if wanted == 1 else "rclpy"]:
            return None
        version = wanted
    if version == 1:
        distribution = _distribution(origin, environ) or "noetic"
        environment = Environment(origin, 1, distribution, python)
        return environment if found["rosmaster"] else _no_master(environment, environ)
    distribution = _distribution(origin, environ) or distribution_of_rclpy(found["rclpy_version"])
    environment = Environment(origin, 2, distribution, python)
    return _middleware_problem(environment, found["middlewares"], environ) or environment


def _distribution(origin: Origin, environ: Mapping[str, str]) -> str:
    return environ.get("ROS_DISTRO", "") if origin is Origin.SOURCED else ""


def _no_master(environment: Environment, environ: Mapping[str, str]) -> Environment | Half:
    if environ.get("ROS_MASTER_URI"):
        return environment
    return _half(
        1,
        "rospy is installed, but not rosmaster, the master that nodes find each other by",
        _remedy(environment, "rosmaster"),
    )


def _middleware_problem(
    environment: Environment, middlewares: Sequence[str], environ: Mapping[str, str]
) -> Half | None:
    asked = environ.get("RMW_IMPLEMENTATION")
    if asked and asked not in middlewares:
        return _half(
            2,
            f"RMW_IMPLEMENTATION asks for the middleware `{asked}`, which is not installed",
            f"{_remedy(environment, asked)}, or unset RMW_IMPLEMENTATION",
        )
    if middlewares:
        return None
    return _half(
        2,
        "rclpy is installed, but no middleware that its messages could travel by",
        _remedy(environment, "rmw_fastrtps_cpp"),
    )


def _not_sourced(installation: Installation) -> Diagnostic:
    file = setup_file(installation.distribution)
    message = f"{installation.name} is installed, but not sourced"
    return Diagnostic(codes.NO_ROS, message, help=f"source it with `. {file}`")


def _half(ros_version: int, message: str, help_: str) -> Half:
    return Half(ros_version, Diagnostic(codes.HALF_A_ROS, message, help=help_))


def _remedy(environment: Environment, package: str) -> str:
    """Return the help line that says how a package gets into an environment."""
    match environment.origin:
        case Origin.EXTRA:
            command = installing.wheel(package, environment.distribution)
        case Origin.DEBIAN:
            command = installing.debian(package)
        case _:
            command = installing.of_distribution(package, environment.distribution)
    if command is not None:
        return f"install it with `{command}`"
    tool = "catkin" if environment.ros_version == 1 else "colcon"
    return f"build `{package}` from its definitions with {tool}, and source the result"


def _unsourced(environ: Mapping[str, str]) -> dict[str, str]:
    """Return the variables without the paths of a sourced ROS, so that it cannot mix in."""
    own = dict(environ)
    if sourced_version(environ) is None:
        return own
    prefixes = [
        prefix
        for variable in ("AMENT_PREFIX_PATH", "CMAKE_PREFIX_PATH", "COLCON_PREFIX_PATH")
        for prefix in own.get(variable, "").split(os.pathsep)
        if prefix
    ]
    for variable in ("PYTHONPATH", "LD_LIBRARY_PATH", "PATH"):
        if variable in own:
            own[variable] = _path_without(own[variable], prefixes)
    for variable in ("AMENT_PREFIX_PATH", "ROS_PACKAGE_PATH", "ROS_DISTRO", "ROS_VERSION"):
        own.pop(variable, None)
    return own


def _without_wheels(environ: dict[str, str]) -> dict[str, str]:
    """Undo the wheels' start-up hook: the node's own Python may be another one."""
    if environ.pop(_WHEELS_MARK, None) is None:
        return environ
    left = _path_without(environ.get("LD_LIBRARY_PATH", ""), [sys.prefix])
    if left:
        environ["LD_LIBRARY_PATH"] = left
    else:
        environ.pop("LD_LIBRARY_PATH", None)
    return environ


def _path_without(value: str, prefixes: Iterable[str]) -> str:
    roots = tuple(prefix.rstrip("/") + "/" for prefix in prefixes)
    parts = (part for part in value.split(os.pathsep) if part)
    return os.pathsep.join(part for part in parts if not (part + "/").startswith(roots))


def _probe(
    python: Path, environ: Mapping[str, str], packages: Sequence[str] = ()
) -> dict[str, Any] | None:
    """Ask an interpreter what it could import; None when it cannot be run."""
    try:
        done = subprocess.run(
            [python, _PROBE, *packages],
            env=_without_wheels(dict(environ)),
            capture_output=True,
            text=True,
            timeout=_PROBE_LIMIT,
            check=False,
        )
    except (OSError, subprocess.TimeoutExpired):
        return None
    match = re.search(r"^\{.*\}$", done.stdout, re.MULTILINE)
    found: dict[str, Any] | None = json.loads(match.group()) if match else None
    return found
