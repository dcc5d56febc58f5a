"""A launch file of the nodes that run, as far as their graph and processes tell."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

from plastron_tui.ros.launch import LaunchFile, Parameter, ParameterValue, StartedNode
from plastron_tui.ros.launch_text import text
from plastron_tui.sources.launch.around import package_name

from .describe import DescribedNode
from .environment import LOOPBACK, is_local
from .master import DEFAULT_PORT, MasterError, call
from .private_parameters import setting

_UNKNOWN = {1: ("PACKAGE", "TYPE"), 2: ("PACKAGE", "EXECUTABLE")}
_WORDS = 2
"""The words of a command line that may be the executable: itself, or behind an interpreter."""


class Origin(NamedTuple):
    """Which executable a node is.

    Attributes:
        package: the package that has it.
        executable: its name.
    """

    package: str
    executable: str


def launch_of(
    nodes: Sequence[DescribedNode], ros_version: int, origins: Mapping[str, Origin]
) -> LaunchFile:
    """Return a launch file that starts nodes with their names and parameters.

    Args:
        nodes: the nodes.
        ros_version: the generation of ROS that they run with.
        origins: what is known of their executables, by their full names; the others have words
            there that no package has.
    """
    items = []
    for node in nodes:
        namespace, _, name = node.name.rpartition("/")
        package, executable = origins.get(node.name, _UNKNOWN[ros_version])
        items.append(
            StartedNode(
                text(package),
                text(executable),
                text(name),
                text(namespace) if namespace else None,
                parameters=tuple(_parameters(node, ros_version)),
            )
        )
    return LaunchFile(tuple(items))


def not_known(
    nodes: Sequence[DescribedNode], ros_version: int, origins: Mapping[str, Origin]
) -> str | None:
    """Return what to say of nodes whose executables are not known, None where all are."""
    if all(node.name in origins for node in nodes):
        return None
    words = " and ".join(_UNKNOWN[ros_version])
    return f"The graph does not tell which executables these are: replace {words}."


def _parameters(node: DescribedNode, ros_version: int) -> Iterator[Parameter]:
    for name, details in node.parameters.items():
        value = setting(details.default)
        if value is not None:
            own = name.lstrip("~/") if ros_version == 1 else name
            yield ParameterValue(text(own), value, isinstance(value, str))


def origins_of(
    nodes: Sequence[DescribedNode],
    ros_version: int,
    environ: Mapping[str, str] = os.environ,
    processes: Path = Path("/proc"),
) -> dict[str, Origin]:
    """Return which executables nodes are, where that is sure.

    A node of ROS 1 tells its process itself; one of ROS 2 does not.
    """
    if ros_version == 2:
        return {}
    uri = environ.get("ROS_MASTER_URI") or f"http://{LOOPBACK}:{DEFAULT_PORT}"
    found = {}
    for node in nodes:
        try:
            address = str(call(uri, "lookupNode", node.name))
            pid = int(call(address, "getPid")) if is_local(address) else None
        except (MasterError, TypeError, ValueError):
            continue
        origin = None if pid is None else origin_of(processes / str(pid))
        if origin is not None:
            found[node.name] = origin
    return found


def origin_of(process: Path) -> Origin | None:
    """Return the executable that a process is of, None where its file is in no package."""
    try:
        words = (process / "cmdline").read_bytes().split(b"\0")[:_WORDS]
    except OSError:
        return None
    for word in map(os.fsdecode, words):
        path = Path(word)
        if not path.is_absolute() or not path.is_file():
            continue
        folder = path.parent
        installed = folder.parent.parent / "share" / folder.name
        if folder.parent.name == "lib" and package_name(installed) == folder.name:
            return Origin(folder.name, path.name)
        # As roslaunch does, which looks through all folders of a package's sources.
        own = next((each for each in path.parents if (each / "package.xml").is_file()), None)
        name = None if own is None else package_name(own)
        if name is not None:
            return Origin(name, path.name)
    return None
